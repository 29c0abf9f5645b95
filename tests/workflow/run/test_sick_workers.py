"""Simulated: one sick worker among sound ones fails nothing, whatever becomes of the sound ones."""

from concurrent.futures import Future

from elastomer_friction.workflow.cluster import WorkerDied
from elastomer_friction.workflow.system import Watch
from tests.support.simulated import ERROR, Cluster, first, sick, sound, streamed, tries
from tests.support.simulated_workers import DIE


class Given(list):
    """Items that were given up."""

    def __call__(self, item, error, alone):
        self.append((item, str(error), alone))
        return []


def test_while_the_sound_worker_is_busy_for_long_nothing_is_tried_twice_by_the_sick_one(capsys):
    cluster, given = Cluster(a=sick, b=first(100.0)), Given()
    assert sorted(streamed(cluster, range(30), retry=given)) == [(i, i) for i in range(30)]
    assert given == []
    assert set(tries(cluster, "a").values()) == {1}
    assert cluster.now < 1000.0 + 100.0 + 31.0
    assert capsys.readouterr().err.count("3 consecutive batches failed there") == 1


def test_what_fails_before_the_scheduler_has_said_who_is_there_waits_for_that():
    cluster, given = Cluster(a=sick, b=first(10.0)), Given()
    request = cluster.request_snapshot

    def late():
        """Answer in three seconds."""
        answer = Future()
        cluster.after(3.0, lambda: answer.set_result(request().result()))
        return answer

    cluster.request_snapshot = late
    assert sorted(streamed(cluster, range(10), retry=given)) == [(i, i) for i in range(10)]
    assert given == []
    assert set(tries(cluster, "a").values()) == {1}


def test_who_is_left_out_is_given_nothing_any_more():
    cluster = Cluster(a=sick, b=sound)
    assert len(streamed(cluster, range(100))) == 100
    assert 3 <= len(tries(cluster, "a")) <= 10  # a window, or nearly


def test_where_the_sound_worker_dies_another_does_what_waited_for_it():
    cluster = Cluster(a=sick, b=first(1e9))
    cluster.after(5.0, cluster.join, "c", sound)
    cluster.after(5.5, cluster.die, "b")
    assert sorted(streamed(cluster, range(10))) == [(i, i) for i in range(10)]
    assert set(tries(cluster, "a").values()) == {1}
    assert cluster.unrunnable == {}  # or they would be kept for ever


def test_where_the_only_sound_worker_dies_items_fail_twice_on_the_other_and_nothing_waits():
    cluster, given = Cluster(a=sick, b=first(1e9)), Given()
    cluster.after(5.0, cluster.die, "b")
    assert streamed(cluster, range(10), retry=given) == []
    assert sorted(item for item, _, _ in given) == [*range(10)]
    assert set(tries(cluster, "a").values()) == {2}
    assert 1030.0 < cluster.now < 1045.0  # 30 s, in which another might come in its place


def test_where_the_only_sound_worker_is_started_anew_nothing_fails_twice():
    cluster, given = Cluster(a=sick, b0=first(1e9)), Given()
    cluster.after(5.0, cluster.die, "b0")
    cluster.after(25.0, cluster.join, "b1", sound)
    assert sorted(streamed(cluster, range(30), retry=given)) == [(i, i) for i in range(30)]
    assert given == []
    assert set(tries(cluster, "a").values()) == {1}


def test_a_stop_does_not_wait_for_who_may_come_again():
    cluster = Cluster(a=sick, b=first(1e9))
    cluster.after(5.0, cluster.die, "b")
    stopping = Watch(lambda: cluster.now > 1010.0)
    assert streamed(cluster, range(10), watch=stopping) == []
    assert cluster.now < 1015.0


def test_a_stop_waits_ten_seconds_for_what_runs_and_leaves_the_rest(capsys):
    cluster = Cluster(a=first(8.0), b=first(1e3))
    stopping = Watch(lambda: cluster.now > 1001.0)
    assert streamed(cluster, range(2), watch=stopping) == [(0, 0)]
    assert 1010.0 < cluster.now < 1013.0
    assert capsys.readouterr().err == "abandoned: 1 batches that did not finish in time\n"


def test_where_the_sound_worker_falls_silent_another_does_what_it_has():
    cluster = Cluster(a=sick, b=sound, c=sound)
    cluster.after(2.5, cluster.hush, "b")
    assert sorted(streamed(cluster, range(20))) == [(i, i) for i in range(20)]
    assert cluster.now < 1070.0


def test_where_the_only_sound_worker_falls_silent_nothing_waits_for_it():
    cluster, given = Cluster(a=sick, b=first(1e9)), Given()
    cluster.after(5.0, cluster.hush, "b")
    assert streamed(cluster, range(10), retry=given) == []
    assert sorted(item for item, _, _ in given) == [*range(10)]
    assert cluster.now < 1085.0  # 45 s, to be given up, and 30 s in which it might come again


def test_what_comes_of_a_silent_worker_counts_if_it_comes_first():
    cluster, given = Cluster(a=lambda item: (10.0, ERROR), b=first(20.0)), Given()
    cluster.after(5.0, cluster.hush, "b")
    cluster.after(40.0, cluster.wake, "b")
    assert sorted(streamed(cluster, [1], retry=given)) == [(1, 1)]
    assert given == []


def test_where_the_sound_worker_pauses_another_does_what_is_for_it():
    cluster = Cluster(a=sick, b=sound, c=first(10.0))
    cluster.pause("b")
    assert sorted(streamed(cluster, range(10))) == [(i, i) for i in range(10)]
    assert not tries(cluster, "b")


def test_what_two_sick_workers_fail_is_given_up_though_a_third_is_sound():
    cluster, given = Cluster(a=sick, b=sick, c=first(50.0)), Given()
    streamed(cluster, range(10), retry=given)
    for item, message, alone in given:
        assert (message, alone) == (str(ERROR), False)
        assert (tries(cluster, "a")[item], tries(cluster, "b")[item]) == (1, 1)


def test_two_workers_of_one_sick_host_count_as_one():
    cluster = Cluster(far_1=sick, far_2=sick, far_3=sick, near_1=first(50.0))
    assert sorted(streamed(cluster, range(30))) == [(i, i) for i in range(30)]


def test_the_only_worker_is_tried_twice():
    cluster, given = Cluster(a=sick), Given()
    assert streamed(cluster, range(20), retry=given) == []
    assert tries(cluster, "a") == dict.fromkeys(range(20), 2)
    outcomes = iter([ERROR, 7])
    assert streamed(Cluster(a=lambda item: (1.0, next(outcomes))), [7]) == [(7, 7)]


def test_who_joins_later_is_tried_before_an_item_is_given_up():
    cluster = Cluster(a=lambda item: (2.0, ERROR))
    cluster.after(3.0, cluster.join, "b", sound)
    assert streamed(cluster, [7]) == [(7, 7)]
    assert cluster.tried == [(7, "a"), (7, "a"), (7, "b")]


def test_what_kills_its_workers_is_blamed_alone_though_another_is_sick():
    """Whoever dies is replaced by a worker with another address, as by dask's nannies."""

    def poisoned(item):
        return 0.1, DIE if item == 3 else item

    def once_more(item, error, alone):
        once = isinstance(error, WorkerDied) and not alone
        return [item] if once else given(item, error, alone)

    cluster, given = Cluster(a=sick, b0=poisoned, c0=poisoned), Given()
    cluster.replaced = poisoned
    others = [(i, i) for i in range(20) if i != 3]
    assert sorted(streamed(cluster, range(20), retry=once_more)) == others
    ((item, message, alone),) = given
    assert (item, alone) == (3, True)
    assert "4 different workers" in message
    assert len(cluster.workers) == 3
    assert sum(tries(cluster, name)[3] for name in {name for _, name in cluster.tried}) <= 16
