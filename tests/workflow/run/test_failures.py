"""A failing chunk is split, tried alone, recorded by point; the rest of the study is finished."""

import dataclasses

import numpy as np
import pytest

from elastomer_friction.workflow.cluster import WorkerDied
from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.run.failures import Failures
from elastomer_friction.workflow.simulate.realizations import block_means
from elastomer_friction.workflow.store.store import Store, store_folder
from tests.support.runs import run
from tests.support.shards import BATCH, held
from tests.support.small import all_records, small_plan

PLAN = small_plan()
KILLED = WorkerDied(4)


@pytest.fixture
def failures(tmp_path):
    """Return the failures of a run that goes on with one."""
    return Failures(Store(tmp_path), PLAN, 1)


@pytest.mark.parametrize("error", [ValueError("no"), KILLED])
def test_a_chunk_is_split_into_its_tasks(failures, error):
    retried = failures.replaced(BATCH, error, False)
    parts = [(batch.tasks, batch.first_block, batch.blocks) for batch in retried]
    assert parts == [((task,), 0, 4) for task in BATCH.tasks]
    assert sum(batch.seconds for batch in retried) == pytest.approx(BATCH.seconds)
    assert failures.lines() == []
    pair = dataclasses.replace(BATCH, tasks=BATCH.tasks[:2])
    assert [batch.tasks for batch in failures.replaced(pair, error, True)] == [
        (t,) for t in pair.tasks
    ]


def test_a_task_whose_worker_died_is_tried_alone_before_it_is_blamed(failures, capsys):
    (first, *_) = failures.replaced(BATCH, KILLED, False)
    assert failures.replaced(first, KILLED, False) == [first]
    assert failures.replaced(first, KILLED, True) == []
    assert (
        "its worker died 4 times, or retired before the job's walltime (blocks 0-3)"
        in capsys.readouterr().err
    )


def test_a_failure_is_recorded_by_point_and_said_at_once(failures, capsys):
    (first, *_) = failures.replaced(BATCH, ValueError("no root\nat all"), False)
    assert failures.replaced(first, ValueError("no root\nat all"), False) == []
    said = capsys.readouterr().err
    point = "hurst=0.3 normal_force=0.04 spacing=0.0001 roughness=1e-05 velocity=0.03 velocity_step"
    assert said.startswith(f"failed: {point}")
    assert said.endswith(": ValueError: no root (blocks 0-3)\n")
    assert failures.lines()[0].startswith("1 problems failed")
    again = Failures(Store(failures.store.folder), PLAN, 1)
    assert again.lines() == failures.lines()
    assert (first.tasks[0].key, 77) in again
    assert (BATCH.tasks[1].key, 0) not in again


@pytest.mark.parametrize(
    ("error", "said"),
    [
        (ModuleNotFoundError("No module named 'workflow'"), "cannot import its code: No module"),
        (RuntimeError("can't start new thread"), "can't start new thread: raise ulimit -v"),
    ],
)
def test_a_worker_that_cannot_compute_ends_the_run_without_failed_problems(failures, error, said):
    (task, *_) = failures.replaced(BATCH, ValueError(), False)
    for batch in (BATCH, task):
        with pytest.raises(UserError, match=f"^a worker {said}"):
            failures.replaced(batch, error, False)
    assert failures.lines() == []


BAD = PLAN.variants[0].tasks[1].key


def failing(batch):
    """Stand in for block_means: raise where a batch holds the bad problem."""
    if any(task.key == BAD for task in batch.tasks):
        raise ArithmeticError("no root")
    return block_means(batch)


@pytest.fixture(scope="module", params=["here", "on a cluster"])
def broken(request, tmp_path_factory):
    """Return a run in which one problem raises where it is computed; it may go on with one."""
    where = {} if request.param == "here" else {"scheduler": request.getfixturevalue("scheduler")}
    return run(tmp_path_factory.mktemp("broken"), max_failures=1, work=failing, **where)


def test_the_rest_of_the_study_is_finished_and_the_failed_point_marked(broken, finished):
    assert broken.summary.written
    assert len(broken.summary.failures) == 2
    assert "ArithmeticError: no root" in broken.summary.failures[1]
    others = {record for record in all_records(PLAN) if record[0] != BAD}
    assert held(Store(store_folder(broken.path))) == others
    whole, part, sound = finished.load(), broken.load(), PLAN.variants[0].point_task != 1
    assert np.array_equal(part.realizations > 0, sound)
    assert np.isnan(part.mu.values[~sound]).all()
    for name in ("mu_1", "jump", "mu", "fit_status", "realizations", "relaxation_rate_error"):
        values, expected = part[name].values[sound], whole[name].values[sound]
        assert np.array_equal(values, expected, equal_nan=True)


def test_a_failure_is_tried_again_when_asked_and_only_then(broken, finished):
    again = run(broken.path.parent)
    assert (again.summary.batches, again.summary.failures) == (0, broken.summary.failures)
    retried = run(broken.path.parent, retry_failed=True)
    assert (retried.summary.batches, retried.summary.failures) == (1, [])
    assert retried.path.read_bytes() == finished.path.read_bytes()


def test_no_result_is_written_after_too_many_failures(tmp_path):
    stopped = run(tmp_path, work=failing)  # one is too many unless more are allowed
    assert not stopped.summary.written
    assert not stopped.path.exists()
    assert len(stopped.summary.failures) == 2
