"""Rates of a run: the time that is left follows the finished batches of each variant."""

import pytest

from elastomer_friction.workflow.plan.batches import cut, missing_work, total_seconds
from elastomer_friction.workflow.run.measured_rates import MeasuredRates, Remaining
from tests.support.small import cut_batches, small_plan

PLAN = small_plan("study.realizations=4000")
WORK = cut(missing_work(PLAN, ()), 1.0)
BATCHES = list(cut_batches(PLAN, set(), 1.0))


def test_what_is_left_is_corrected_by_the_batches_of_each_variant():
    rates = MeasuredRates(PLAN)
    remaining = Remaining(WORK, rates)
    predicted = dict(remaining.predicted)
    assert remaining.seconds() == pytest.approx(total_seconds(WORK))
    assert (rates.rate(""), remaining.rate()) == (1.0, pytest.approx(1.0))
    for _ in range(1000):
        rates.enter(BATCHES[0], 3.0 * BATCHES[0].seconds)
    first, other = PLAN.variant_of_batch(BATCHES[0]).label, "coarse"
    assert (first, rates.rate(other)) == ("", 1.0)
    assert rates.rate(first) == pytest.approx(3.0, rel=0.01)
    expected = rates.rate("") * predicted[""] + predicted["coarse"]
    assert remaining.seconds() == pytest.approx(expected)
    assert 1.0 < remaining.rate() < 3.0


def test_a_short_first_batch_hardly_changes_the_rate():
    rates = MeasuredRates(PLAN)
    rates.enter(BATCHES[0], 1e-3)
    assert 0.1 < rates.rate("") < 1.0


def test_nothing_is_left_once_all_batches_are_finished():
    rates = MeasuredRates(PLAN)
    remaining = Remaining(WORK, rates)
    for batch in BATCHES:
        rates.enter(batch, 7.0 * batch.seconds)
        remaining.finish(batch)
    assert (remaining.seconds(), remaining.rate()) == (0.0, 1.0)
