"""Who computes: this process what takes seconds, workers where they are asked for, alike."""

import pytest

from elastomer_friction.workflow.errors import UserError
from elastomer_friction.workflow.run import collect, workers
from elastomer_friction.workflow.run import grid_run as driver
from elastomer_friction.workflow.run.workers import SECONDS_HERE, RunOptions, stream_here
from elastomer_friction.workflow.study.cluster import Cluster
from elastomer_friction.workflow.system.watch import Watch
from tests.support.runs import run, shards

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


def test_items_are_done_one_after_the_other_and_the_watch_looks_on():
    looks = []
    watch = Watch(listeners=[lambda *seen: looks.append(seen)])
    assert list(stream_here(halve, [2, 4, 6], watch)) == [(2, 1), (4, 2), (6, 3)]
    assert looks == [(1, 0), (1, 1), (1, 1), (1, 1)]


def test_none_is_taken_up_once_the_watch_says_stop():
    done = []
    taken = iter([2, 4, 6])
    for item, _ in stream_here(halve, taken, Watch(lambda: len(done) == 2)):
        done.append(item)
    assert (done, list(taken)) == ([2, 4], [6])


def test_what_raises_twice_is_replaced_by_what_the_retry_says():
    tried, asked = [], []

    def work(item):
        tried.append(item)
        return halve(item)

    def retry(item, error, alone):
        asked.append((item, str(error), alone))
        return [2 * item]

    assert list(stream_here(work, [2, 3, 4], Watch(), retry)) == [(2, 1), (6, 3), (4, 2)]
    assert tried == [2, 3, 3, 6, 4]
    assert asked == [(3, "3", True)]
    with pytest.raises(ValueError, match="3"):
        list(stream_here(work, [3], Watch()))


def test_what_a_user_can_put_right_is_not_tried_again():
    tried = []

    def refuse(item):
        tried.append(item)
        raise UserError("no")

    with pytest.raises(UserError, match="no"):
        list(stream_here(refuse, [1], Watch()))
    assert tried == [1]


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
    monkeypatch.setattr(driver, "open_workers", pytest.fail)
    monkeypatch.setattr(collect.Collector, "fit", pytest.fail)
    again = run(tmp_path, workers=2)
    assert (again.summary.batches, again.summary.written) == (0, True)
    assert again.summary.reused == first.plan.records
    assert "the result is there already" in again.summary.lines(again.plan)[1]
    assert again.path.stat().st_mtime_ns == before
    assert len(shards(tmp_path)) > 0
    assert "Starting" not in capsys.readouterr().err
