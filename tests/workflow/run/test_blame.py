"""The workers: failures are blamed on whom they follow, others do the work."""

import pytest

from elastomer_friction.workflow.cluster import Snapshot
from elastomer_friction.workflow.run.blame import RESTART_SECONDS, Blame

A, B, C = (f"tls://127.0.0.1:{port}" for port in (1, 2, 3))
FAR = {name: f"tls://10.0.0.{name[0]}:{name[1]}" for name in ("11", "12", "21", "31")}


def blame_of(*workers, blame=None, time=0.0):
    """Return what is known of workers that are there."""
    blame = blame or Blame()
    blame.note(Snapshot(dict.fromkeys(workers, 1), workers), time)
    return blame


def test_of_a_failure_that_was_nobody_knows_where_nobody_is_blamed(capsys):
    blame = blame_of(A, B, C)
    for _ in range(5):
        blame.succeeded(B, [""])
    assert (blame.excluded, capsys.readouterr().err) == (set(), "")


def test_who_fails_in_a_row_what_others_can_do_is_left_out_and_named(capsys):
    blame = blame_of(A, B, C)
    for _ in range(2):
        blame.succeeded(B, [A])
    blame.succeeded(A, [])  # no longer in a row
    for _ in range(3):
        assert A in blame.fit()
        blame.succeeded(B, [A])
    assert blame.fit() == [B, C]
    blame.succeeded(B, [A])
    (line,) = capsys.readouterr().err.splitlines()
    assert line.startswith(f"worker {A}: 3 consecutive batches failed there")


def test_on_several_hosts_the_host_is_blamed():
    blame = blame_of(*FAR.values())
    assert blame.fit([FAR["11"]]) == [FAR["21"], FAR["31"]]
    for worker in ("11", "12", "11"):
        blame.succeeded(FAR["21"], [FAR[worker]])
    assert blame.fit() == [FAR["21"], FAR["31"]]


def test_a_worker_that_was_lost_just_now_may_come_again():
    blame = blame_of(A, B)
    blame_of(A, blame=blame, time=5.0)
    assert blame.awaited([A])
    assert not blame.awaited([])  # A is there
    assert not blame.awaited([A, B])
    blame_of(A, C, blame=blame, time=6.0)
    assert not blame.awaited([A])
    blame_of(A, blame=blame, time=5.0 + RESTART_SECONDS)
    assert blame.awaited([A])  # for C now
    blame_of(A, blame=blame, time=10.0 + 2.0 * RESTART_SECONDS)
    assert not blame.awaited([A])


HERE, THERE = "tls://10.0.0.1", "tls://10.0.0.2"
ONLY, BOTH, HOSTS = [A], [A, B], [f"{HERE}:1", f"{HERE}:2", f"{THERE}:1"]
FAILED = [(ONLY, [A], False), (ONLY, [A, A], True), (BOTH, [A, A], False), (BOTH, [A] * 5, False)]
FAILED += [(BOTH, [A, B], True), (BOTH, [B, A, A], True), (ONLY, [A, "gone"], True)]
FAILED += [(HOSTS, HOSTS[:2], False), (HOSTS, HOSTS[1:], True), (HOSTS[:2], HOSTS[:2], True)]
FAILED += [(BOTH, [""], False), (BOTH, ["", ""], True), (BOTH, [A, ""], True)]  # unknown places


@pytest.mark.parametrize(("there", "failed", "given_up"), FAILED)
def test_an_item_is_given_up_after_two_places_or_twice_at_the_only_one(there, failed, given_up):
    assert blame_of(*there).to_be_given_up(failed) == given_up
