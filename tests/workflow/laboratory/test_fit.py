"""Records in, everything that they determine out."""

import pytest

from elastomer_friction.workflow.laboratory.together import Known, fit_records
from tests.workflow.laboratory.given import HURST, Q_MAX, SLOPE, TAU, record, records


def test_the_law_that_made_the_records_is_found_again():
    fit = fit_records(records([3e-3, 6e-3, 0.03, 0.1, 0.4]), Known())
    assert fit.rates is not None
    found = (fit.rates.relaxation_time, fit.rates.hurst, fit.rates.q_max, fit.slope)
    for each, true in zip(found, (TAU, HURST, Q_MAX, SLOPE), strict=True):
        assert abs(each.value - true) < 4.0 * each.error
        assert each.error < 0.2 * true
    assert not fit.rates.time_below_one
    assert [step.law for step in fit.ageing] == ["dieterich"] * 5


def test_what_is_known_and_the_window_are_taken():
    fit = fit_records([record()], Known(relaxation_time=TAU), window=1.0)
    assert fit.rates is not None
    assert fit.rates.relaxation_time == (TAU, 0.0)
    assert fit.steps[0].step.time[-1] <= 1.0
    assert fit.known.relaxation_time == pytest.approx(TAU)


def test_where_nothing_relaxes_there_are_no_rates():
    assert fit_records([record(jump=0.02)], Known()).rates is None
