"""A run: the same bytes however it is cut, nothing computed twice, whoever computes."""

import json
import shutil

import numpy as np
import pytest
import xarray as xr

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.plan.plan import make_plan
from elastomer_friction.workflow.run import collect, workers
from elastomer_friction.workflow.run import grid_run as driver
from elastomer_friction.workflow.run.grid_run import run_plan
from elastomer_friction.workflow.run.node import Node
from elastomer_friction.workflow.run.status import status_file
from elastomer_friction.workflow.run.workers import SECONDS_HERE, PoolHere, RunOptions
from elastomer_friction.workflow.store import journal
from elastomer_friction.workflow.store.store import Store, store_folder
from elastomer_friction.workflow.study.cluster import Cluster
from elastomer_friction.workflow.system.lock import hold
from elastomer_friction.workflow.system.watch import Watch
from tests.support.documents import without
from tests.support.runs import run, shards
from tests.support.shards import held
from tests.support.simulated import stream
from tests.support.small import all_records, small_study


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


def test_one_measured_line_runs_and_its_errors_are_nan(tmp_path):
    left_out = ("surface.length", "grid.hurst", "grid.spacing", "grid.roughness")
    study = small_study(
        'surface.file="line.csv"',
        "grid.normal_force=[4e-7]",
        text=without(*left_out, "study.realizations"),
    )
    path = tmp_path / "small.nc"
    run_plan(make_plan(study), path, RunOptions(Cluster("local")))
    with xr.open_dataset(path) as dataset:
        assert (dataset.realizations == 1).all()
        assert np.isfinite(dataset.mu_1).all()
        assert np.isnan(dataset.mu_1_error).all()
        assert (dataset.mu_1_bias < 1.0).all()
        assert dataset.attrs["lines"].endswith(dataset.attrs["standard_errors"])


def test_a_run_says_how_far_it_is(tmp_path, capsys):
    run(tmp_path, "grid.hurst=0.7", "grid.velocity=0.1")
    said = capsys.readouterr().err.splitlines()
    assert any(line.startswith("computing: 100%, 0 s left") for line in said)
    (tmp_path / "small.nc").unlink()
    run(tmp_path, "grid.hurst=0.7", "grid.velocity=0.1")
    said = capsys.readouterr().err.splitlines()
    assert any(line.startswith("fitting: 100%, 0 s left") for line in said)


def test_kernels_are_loaded_beforehand_where_this_machine_is_to_compute(
    scheduler, tmp_path, monkeypatch
):
    loaded, few = [], ("grid.hurst=0.7", "grid.velocity=0.1")
    monkeypatch.setattr(driver, "load_kernels", lambda _, scheme, __: loaded.append(scheme))
    run(tmp_path / "there", *few, scheduler=scheduler)
    assert loaded == []
    found = run(tmp_path / "here", *few)
    assert loaded == ["exponential", "implicit-euler"]
    found.path.unlink()
    run(tmp_path / "here", *few)  # which has only to fit
    assert loaded == ["exponential", "implicit-euler"]


def test_a_run_ends_before_llvm_would_end_it_for_lack_of_memory(tmp_path, monkeypatch):
    monkeypatch.setattr(driver, "LLVM_BYTES", 2**62)
    with pytest.raises(MemoryError):
        run(tmp_path)


def test_a_run_that_has_nothing_to_do_says_that_it_is_finished(finished, tmp_path):
    result = copied(finished, tmp_path) / finished.path.name
    status_file(result).unlink()
    again = run(result.parent).summary
    assert again.unchanged
    assert again.estimates == finished.summary.estimates != []
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
    again = run(folder, batch_seconds=1e-9)
    assert again.summary.batches == lost > 0  # a record each
    after = shards(folder)
    assert all(after[name] == before[name] for name in before if name != victim.name)
    assert again.path.read_bytes() == finished.path.read_bytes()
    assert "set aside" in capsys.readouterr().err


def test_a_folder_in_use_is_refused(tmp_path, monkeypatch):
    monkeypatch.setattr("elastomer_friction.workflow.system.lock.PROBE_SECONDS", 0.1)
    with hold(tmp_path / "store"), pytest.raises(UserError, match="in use by process"):
        run(tmp_path)
    assert not (tmp_path / "small.nc").exists()


ASKED = [{"workers": 1}, {"dashboard": True}, {"cluster": Cluster("tcp://there:1")}]


def test_this_process_does_seconds_of_work_unless_others_are_asked_for():
    assert RunOptions().here(0.9 * SECONDS_HERE)
    assert not RunOptions().here(SECONDS_HERE)
    for asked in ASKED:
        assert not RunOptions(**asked).here(0.0)


def halve(number):
    """Return half of an even number."""
    if number % 2:
        raise ValueError(number)
    return number // 2


def done_here(work, items, watch=None, retry=pytest.fail):
    """Yield (item, value) of nodes that this process computes."""
    nodes = (Node("march", item) for item in items)
    for node, value in stream(PoolHere({"march": work}), nodes, watch, retry):
        yield node.item, value


def test_items_are_done_one_after_the_other_and_the_watch_looks_on():
    looks = []
    watch = Watch(listeners=[lambda *seen: looks.append(seen)])
    assert list(done_here(halve, [2, 4, 6], watch)) == [(2, 1), (4, 2), (6, 3)]
    assert looks[0] == (1, 0)  # then once a second


def test_none_is_taken_up_once_the_watch_says_stop():
    done = []
    for item, _ in done_here(halve, [2, 4, 6], Watch(lambda: len(done) == 2)):
        done.append(item)
    assert done == [2, 4]


def test_what_raises_twice_is_replaced_by_what_the_retry_says():
    tried, asked = [], []

    def work(item):
        tried.append(item)
        return halve(item)

    def retry(node, error, alone):
        asked.append((node.item, str(error), alone))
        return [Node("march", 2 * node.item)]

    assert list(done_here(work, [2, 3, 4], retry=retry)) == [(2, 1), (4, 2), (6, 3)]
    assert tried == [2, 3, 4, 3, 6]
    assert asked == [(3, "3", False)]


def test_what_a_user_can_put_right_is_not_tried_again():
    tried = []

    def refuse(item):
        tried.append(item)
        raise UserError("no")

    assert list(done_here(refuse, [1], retry=lambda *_: [])) == []
    assert tried == [1]


def test_a_node_is_given_what_its_inputs_came_to_or_what_replaced_them():
    def retry(node, error, alone):
        return [Node("march", part) for part in (2, 4)]

    marches = [Node("march", 6), Node("march", 3)]
    nodes = [*marches, Node("fit", "sum", marches)]
    functions = {"march": halve, "fit": lambda item, *values: (item, values)}
    *_, (_, value) = stream(PoolHere(functions), nodes, retry=retry)
    assert value == ("sum", (3, 1, 2))


def test_a_run_here_starts_no_worker_and_one_that_is_asked_for_them_does(tmp_path, monkeypatch):
    opened = []

    def refuse(*_):
        opened.append(True)
        raise UserError("workers were asked for")

    monkeypatch.setattr(workers.cluster, "open_client", refuse, raising=False)
    assert run(tmp_path).summary.written
    assert not opened
    with pytest.raises(UserError, match="workers were asked for"):
        run(tmp_path / "others", workers=2)


def test_a_second_run_starts_nobody_and_fits_nothing(tmp_path, monkeypatch, capsys):
    first = run(tmp_path)
    before = first.path.stat().st_mtime_ns
    monkeypatch.setattr(driver, "open_pool", pytest.fail)
    monkeypatch.setattr(collect.Collector, "graph", pytest.fail)
    again = run(tmp_path, workers=2)
    assert (again.summary.batches, again.summary.written) == (0, True)
    assert again.summary.reused == first.plan.records
    assert "the result is there already" in again.summary.lines(again.plan)[1]
    assert again.path.stat().st_mtime_ns == before
    assert len(shards(tmp_path)) > 0
    assert "Starting" not in capsys.readouterr().err
