"""What is in flight: silent work gets a second copy, the first result counts."""

import pytest
from distributed.scheduler import KilledWorker

from elastomer_friction.workflow.cluster.calls import Roll
from elastomer_friction.workflow.cluster.crew import Crew
from elastomer_friction.workflow.cluster.flight import Flight, Work, raise_error

A, B, C = (f"tls://127.0.0.1:{port}" for port in (1, 2, 3))


class Future:
    """Stands in for a future of dask."""

    def __init__(self, key, status="pending"):
        self.key, self.status = key, status


def crew_of(busy, beat=0.0, crew=None, silent=()):
    """Return a crew of three, with the keys that each computes."""
    crew = crew or Crew()
    heard = {address: 0.0 if address in silent else beat for address in (A, B, C)}
    crew.note(Roll(dict.fromkeys((A, B, C), 1), heard, {A: [], B: [], C: []} | busy), 1.0)
    return crew


@pytest.fixture
def flight():
    """Return two items in flight."""
    flight = Flight()
    for key in ("short", "long"):
        flight.add(Work(key), Future(key))
    crew = crew_of({A: ["short"], B: ["long"]})
    flight.note(crew)
    return flight


def copies(flight, crew):
    """Return the items that are to be computed a second time, and where."""
    return [(work.item, workers) for work, workers in flight.second_copies(crew)]


def test_what_a_silent_worker_has_is_computed_by_others_busy_or_not(flight):
    crew, busy = None, {A: ["short"], B: ["long"], C: ["other"]}
    for beat in range(1, 33):
        crew = crew_of(busy, beat, crew, silent=[A])
    assert copies(flight, crew) == [("short", [B, C])]


def test_a_result_that_does_not_come_is_computed_again(flight):
    flight.stick(["short", "unknown"])
    assert copies(flight, crew_of({A: ["short"], B: ["long"]})) == [("short", [B, C])]


def test_an_item_with_two_copies_gets_no_third_and_the_first_result_counts(flight):
    work = flight.works["short"]
    flight.add(work, Future("again"))
    flight.note(crew_of({A: ["short"], C: ["again"]}))
    assert copies(flight, crew_of({})) == []
    assert len(flight) == 3
    work.copies["again"].future.status = "finished"
    assert [future.key for future in flight.drop(work)] == ["short"]
    assert list(flight.works) == ["long"]


def test_a_copy_that_fails_leaves_the_other(flight):
    work = flight.works["short"]
    flight.add(work, Future("again"))
    assert flight.fall("short") is work
    assert list(work.copies) == ["again"]
    assert flight.fall("short") is None


def test_after_a_stop_what_no_worker_has_is_shed_and_what_silent_ones_have_left(flight):
    flight.add(Work("waiting"), Future("waiting"))
    flight.add(Work("fetched"), Future("fetched", "finished"))
    crew, busy = None, {A: ["short"], B: ["long"]}
    for beat in range(1, 8):
        crew = crew_of(busy, beat, crew, silent=[A])
    assert [work.item for work in flight.unbegun(crew)] == ["waiting"]
    assert [work.item for work in flight.lost(crew)] == ["short"]


def test_copies_for_workers_that_are_gone_are_stranded_and_others_wait(flight):
    flight.add(Work("bound"), Future("bound"), [A])
    crew = crew_of({})
    crew.note(crew.roll._replace(stranded=["short", "bound", "unknown"]), 1.0)
    ((future, error),) = flight.stranded(crew)
    assert (future.key, error.task, error.allowed_failures) == ("bound", "bound", 0)
    assert "the task was ." in str(error)  # no worker had it


HERE, THERE = "tls://10.0.0.1", "tls://10.0.0.2"
ONLY, BOTH, HOSTS = [A], [A, B], [f"{HERE}:1", f"{HERE}:2", f"{THERE}:1"]
FAILED = [(ONLY, [A], True), (ONLY, [A, A], False), (BOTH, [A, A], True), (BOTH, [A] * 5, True)]
FAILED += [(BOTH, [A, B], False), (BOTH, [B, A, A], False), (ONLY, [A, "gone"], False)]
FAILED += [(HOSTS, HOSTS[:2], True), (HOSTS, HOSTS[1:], False), (HOSTS[:2], HOSTS[:2], False)]
FAILED += [(BOTH, [""], True), (BOTH, ["", ""], False), (BOTH, [A, ""], False)]  # unknown places


@pytest.mark.parametrize(("there", "failed", "again"), FAILED)
def test_an_item_is_given_up_after_two_places_or_twice_at_the_only_one(there, failed, again):
    crew, work = Crew(), Work("item")
    crew.note(Roll(dict.fromkeys(there, 1), dict.fromkeys(there, 0.0), {}), 1.0)
    for address in failed:
        work.fail(address, OSError())
    assert work.failed == failed
    assert work.to_be_tried_again(crew) == again


def test_an_item_survives_three_deaths_of_its_workers():
    crew, work = crew_of({}), Work("item")
    for deaths in range(3):
        work.fail("", KilledWorker("key", None, deaths))
        assert work.to_be_tried_again(crew)
    work.fail("", KilledWorker("key", None, 0))
    assert (work.deaths, work.failed) == (4, [])
    assert not work.to_be_tried_again(crew)
    killed = Work("item")
    killed.fail("", KilledWorker("key", None, 3))  # as dask counts
    assert not killed.to_be_tried_again(crew)


def test_an_item_goes_where_it_did_not_fail_or_else_to_whoever_does_not_have_it():
    crew, work = crew_of({}), Work("item")
    flight = Flight()
    flight.add(work, Future("first"))
    work.copies["first"].address = A
    work.fail(B, OSError())
    assert work.workers(crew) == [C]
    crew.note(crew.roll._replace(paused=[C]), 1.0)
    assert work.workers(crew) == [B]
    crew.note(crew.roll._replace(paused=[B, C]), 1.0)
    assert work.workers(crew) == []


def test_an_item_whose_worker_died_gets_one_chance_alone():
    killed = KilledWorker("key", None, 3)
    assert raise_error(7, killed, False) == [7]
    with pytest.raises(KilledWorker):
        raise_error(7, killed, True)
