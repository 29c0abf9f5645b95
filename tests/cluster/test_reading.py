"""A colleague looks at results while a run goes on: neither disturbs the other."""

import pytest
import xarray as xr

from tests.cluster.processes import PATIENCE, STUDY, start
from workflow.store import journal
from workflow.system.lock import holder

pytestmark = pytest.mark.cluster


def test_a_result_opened_lazily_does_not_block_the_run_that_replaces_it(tmp_path):
    def run(*settings):
        options = ("--out", str(tmp_path), "--workers", "1", *settings)
        return start(tmp_path / "log", *STUDY, *options)

    assert run("--set", "study.realizations=4").wait(timeout=PATIENCE) == 0
    with xr.open_dataset(tmp_path / "fig7.nc") as old:
        again = run("--set", "study.realizations=8")
        size = journal.size(tmp_path / "store")
        while journal.size(tmp_path / "store") == size:
            assert again.poll() is None
        assert str(again.pid) in holder(tmp_path / "store")
        with xr.open_dataset(tmp_path / "fig7.nc") as meanwhile:
            assert (meanwhile.realizations == 4).all()
        second = run("--set", "study.realizations=6")  # one run at a time in a folder
        assert second.wait(timeout=PATIENCE) == 2
        assert f"in use by process {again.pid} on " in (tmp_path / "log").read_text()
        assert again.wait(timeout=PATIENCE) == 0
        assert (old.mu_1.load() > 0).all()  # read only now, from the file that was replaced
        assert (old.realizations.load() == 4).all()
    with xr.open_dataset(tmp_path / "fig7.nc") as new:
        assert (new.realizations == 8).all()
    assert holder(tmp_path / "store") is None
