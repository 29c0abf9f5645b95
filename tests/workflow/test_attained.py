"""Judging estimates: met, missed by how much, and honest where nothing relative can be said."""

import numpy as np
import pytest

from workflow.plan.goal import Goal
from workflow.reduce.attainment import MET, MET_WHERE_DEFINED, MISSED, attained
from workflow.reduce.fits import FITTED, NO_RELAXATION, NOT_EXPONENTIAL, NOT_FINITE, UNDETERMINED

WANTED = 0.1
RATIO = np.array([1.2])


def judge(bias=0.0, mu_1=(1.0, 0.01), rate=(2.0, 0.02), status=FITTED, first=(0.01, 1e-4)):
    """Return the judgement of one task."""
    estimates = {
        "mu_1": np.array([mu_1[0]]),
        "mu_1_error": np.array([mu_1[1]]),
        "relaxation_rate": np.array([rate[0]]),
        "relaxation_rate_error": np.array([rate[1]]),
        "fit_status": np.array([status], np.int8),
        "mu": np.array([[1.0, 1.0]]),
        "deviation": np.array([[0.05, first[0]]]),
        "deviation_error": np.array([[0.0, first[1]]]),
    }
    goal = Goal(4, {"mu_1": bias, "relaxation_rate": bias}, 100.0)
    found = attained(estimates, [goal], RATIO, WANTED)
    return float(found.reached[0]), int(found.status[0]), float(found.growth[0])


def test_the_worst_estimate_counts_with_its_bias():
    reached, status, growth = judge(bias=0.02, mu_1=(1.0, 0.03), rate=(2.0, 0.1))
    assert reached == pytest.approx(0.05 + 0.02)
    assert status == MET
    assert growth == pytest.approx((0.05 / 0.08) ** 2)


def test_what_is_short_says_by_how_much():
    reached, status, growth = judge(rate=(2.0, 0.4))
    assert (reached, status, growth) == (pytest.approx(0.2), MISSED, pytest.approx(4.0))


def test_a_bias_that_is_too_large_is_missed_without_more_realizations():
    reached, status, growth = judge(bias=0.2, mu_1=(1.0, 0.04), rate=(1.0, 0.01))
    assert (reached, status) == (pytest.approx(0.24), MISSED)
    assert growth < 1.0


NAN = (np.nan, np.nan)


def test_where_nothing_relaxes_the_rest_is_judged():
    reached, status, growth = judge(rate=NAN, status=NO_RELAXATION, first=(1e-5, 1e-5))
    assert (reached, status) == (pytest.approx(0.01), MET_WHERE_DEFINED)
    assert growth < 1.0


def test_a_relaxation_that_may_be_there_is_not_given_up():
    reached, status, growth = judge(rate=NAN, status=NO_RELAXATION, first=(0.05, 0.03))
    assert (reached, status, growth) == (np.inf, MISSED, np.inf)


@pytest.mark.parametrize(
    ("status", "growth"), [(UNDETERMINED, np.inf), (NOT_FINITE, 0.0)], ids=["noise", "broken"]
)
def test_a_rate_that_is_not_known_is_missed(status, growth):
    assert judge(rate=NAN, status=status) == (np.inf, MISSED, growth)


def test_a_curve_that_is_no_exponential_has_no_rate():
    assert judge(rate=NAN, status=NOT_EXPONENTIAL)[1] == MET_WHERE_DEFINED


def test_an_exact_zero_has_no_relative_error():
    reached, status, _ = judge(mu_1=(0.0, 0.0))
    assert (reached, status) == (pytest.approx(0.01), MET_WHERE_DEFINED)
    assert judge(mu_1=(0.0, 0.1))[1] == MISSED
    estimates = {"jump": np.zeros(1), "jump_error": np.zeros(1)}
    found = attained(estimates, [Goal(4, {"jump": 0.0}, 9.0)], np.ones(1), WANTED)
    assert np.isnan(found.reached[0])
    assert found.status[0] == MET_WHERE_DEFINED


def test_a_rate_that_is_met_needs_no_excuse():
    assert judge(status=FITTED, first=(1e-9, 1e-12))[1] == MET
