"""The commands verify and merge."""

import pytest

from elastomer_friction.workflow.cli import main
from elastomer_friction.workflow.store.store import Store
from tests.support.commands import facts, output, refusal
from tests.support.shards import WORK, filled, shard_of


@pytest.fixture
def results(tmp_path, monkeypatch):
    """Return a folder of results, in the working folder, with a store of three shards."""
    monkeypatch.chdir(tmp_path)
    filled(tmp_path / "results" / "store", WORK[:3])
    return tmp_path / "results"


def test_a_store_is_verified_by_folder_and_by_study(capsys, results, study):
    said = output(capsys, "verify")
    assert facts(said)["shards"].split() == ["shards", "3", "of", "3", "sound"]
    for what in (("results",), ("results/store",), (study,), (study, "--out", "results/small.nc")):
        assert facts(output(capsys, "verify", *what))["shards"] == facts(said)["shards"]


def test_a_fault_is_printed_and_is_exit_status_three(capsys, results):
    path = shard_of(Store(results / "store"), WORK[1])
    path.write_bytes(b"")
    assert main(["verify", "results"]) == 3
    out, err = capsys.readouterr()
    assert err == ""
    assert f"fault       {path.name}: damaged" in out


def test_stores_are_merged_by_folder(capsys, results, tmp_path):
    said = output(capsys, "merge", "results", "other")
    assert said == "taken over  3 of 3 shards, 3 records that are new\n"
    assert len(list((tmp_path / "other" / "store").glob("*.nc"))) == 3
    assert "0 of 3 shards" in output(capsys, "merge", "other/store", "results/store")


def test_what_holds_no_store_is_refused(capsys, results):
    (results / "empty").mkdir()
    for command in (("verify", "results/empty"), ("merge", "results/empty", "results")):
        assert "holds no store of finished work" in refusal(capsys, *command)
