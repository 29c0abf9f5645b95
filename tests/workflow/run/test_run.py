"""A run: the same bytes however it is cut, nothing computed twice, only what is asked."""

import json
import shutil

import pytest

from elastomer_friction.workflow.errors import UserError
from elastomer_friction.workflow.run import run as driver
from elastomer_friction.workflow.run.status import status_file
from elastomer_friction.workflow.store import journal
from elastomer_friction.workflow.store.store import Store, store_folder
from elastomer_friction.workflow.system.lock import hold
from tests.support.runs import run, shards
from tests.support.shards import held
from tests.support.small import all_records


@pytest.fixture(scope="module")
def cut(scheduler, tmp_path_factory):
    """Return a run in the smallest batches, on two workers. Leave its folder as it is."""
    return run(tmp_path_factory.mktemp("cut"), scheduler=scheduler, batch_seconds=1e-4)


def copied(run, folder):
    """Return a folder with a copy of a run and its store."""
    return shutil.copytree(run.path.parent, folder / "copy")


def test_a_run_computes_everything_and_says_so(finished):
    assert (finished.summary.reused, finished.summary.interrupted) == (0, False)
    assert finished.summary.batches >= len(shards(finished.path.parent)) > 0
    assert held(Store(store_folder(finished.path))) == set(all_records(finished.plan))
    for group, scheme in ((None, "exponential"), ("coarse", "implicit-euler")):
        dataset = finished.load(group)
        assert dataset.attrs["scheme"] == scheme
        assert dataset.mu_1.shape == (2, 2, 1, 1, 2, 1)
        assert (dataset.mu_1 > 0).all()
    names = {path.name for path in finished.path.parent.iterdir()}
    assert names == {"small.nc", "small.status.json", "store"}
    assert json.loads(status_file(finished.path).read_text())["state"] == "finished"
    begun = [entry for entry, _ in journal.entries(store_folder(finished.path)) if "run" in entry]
    assert len(begun) == 1
    assert 0.0 < finished.summary.start <= finished.summary.wall < 3600.0


def test_a_run_says_how_far_it_is(tmp_path, capsys):
    run(tmp_path, "grid.hurst=0.7", "grid.velocity=0.1")
    said = capsys.readouterr().err.splitlines()
    assert any(line.startswith("computing: 100%, 0 s left") for line in said)
    assert "fitting: 100%, 0 s left" in said


def test_kernels_are_loaded_beforehand_where_this_machine_is_to_compute(
    scheduler, tmp_path, monkeypatch
):
    loaded, few = [], ("grid.hurst=0.7", "grid.velocity=0.1")
    monkeypatch.setattr(driver, "load_kernels", lambda scheme, _: loaded.append(scheme))
    run(tmp_path / "there", *few, scheduler=scheduler)
    assert loaded == []
    found = run(tmp_path / "here", *few)
    assert loaded == ["exponential", "implicit-euler"]
    found.path.unlink()
    run(tmp_path / "here", *few)  # which has only to fit
    assert loaded == ["exponential", "implicit-euler"]


def test_a_run_that_has_nothing_to_do_says_that_it_is_finished(finished, tmp_path):
    result = copied(finished, tmp_path) / finished.path.name
    status_file(result).unlink()
    assert run(result.parent).summary.unchanged
    assert json.loads(status_file(result).read_text())["state"] == "finished"


def test_other_batches_on_a_cluster_give_the_same_bytes(finished, cut):
    assert cut.summary.batches > 4 * finished.summary.batches
    assert cut.path.read_bytes() == finished.path.read_bytes()


def test_a_larger_study_computes_only_what_is_new_and_gives_the_bytes_of_a_fresh_one(
    finished, tmp_path
):
    folder, more = copied(finished, tmp_path), ("study.realizations=24",)
    before = shards(folder)
    wide = run(folder, *more, scale="wide")
    fresh = run(tmp_path, *more, scale="wide")
    assert wide.summary.reused == finished.plan.records
    assert 0 < wide.summary.predicted < 0.9 * fresh.summary.predicted
    after = shards(folder)
    assert {name: after[name] for name in before} == before
    assert len(after) > len(before)
    assert wide.load().realizations.values.flat[0] == 24
    assert wide.path.read_bytes() == fresh.path.read_bytes()


def test_records_of_a_damaged_shard_alone_are_computed_again(finished, cut, tmp_path, capsys):
    folder = copied(cut, tmp_path)
    before, store = shards(folder), Store(folder / "store")
    victim = folder / "store" / min(before)
    lost = sum(store.index.find(record)[0] == victim.stem for record in held(store))
    victim.write_bytes(bytes(victim.stat().st_size))  # its length is kept: found when it is read
    (folder / "small.nc").unlink()  # or nothing is read
    again = run(folder, batch_seconds=1e-4)
    assert again.summary.batches == lost > 0  # a record each
    after = shards(folder)
    assert all(after[name] == before[name] for name in before if name != victim.name)
    assert again.path.read_bytes() == finished.path.read_bytes()
    assert "set aside" in capsys.readouterr().err


def test_a_folder_in_use_is_refused(tmp_path, monkeypatch):
    monkeypatch.setattr("elastomer_friction.workflow.system.lock.GLANCE_SECONDS", 0.1)
    with hold(tmp_path / "store"), pytest.raises(UserError, match="in use by process"):
        run(tmp_path)
    assert not (tmp_path / "small.nc").exists()
