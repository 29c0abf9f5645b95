"""Accuracy reached by estimates, the shortfall, and estimates without a relative error."""

import numpy as np
import pytest

from elastomer_friction.workflow.plan.goal import Goal
from elastomer_friction.workflow.reduce.attainment import MET, MET_WHERE_DEFINED, MISSED, attained
from elastomer_friction.workflow.reduce.fits import (
    FITTED,
    NEGLIGIBLE,
    NO_RELAXATION,
    NOT_EXPONENTIAL,
    NOT_FINITE,
    UNDETERMINED,
)
from tests.support.runs import run

WANTED = 0.1
NAN = (np.nan, np.nan)
ZERO = (0.0, 0.0)


def judge(
    bias=0.0,
    mu_1=(1.0, 0.01),
    rate=(2.0, 0.02),
    status=FITTED,
    first=(0.01, 1e-4),
    groups=32,
    scatter=0.1,
):
    """Return the judgement of one task of 100 lines: accuracy reached, status, growth."""
    estimates = {
        "mu_1": np.array([mu_1[0]]),
        "mu_1_error": np.array([mu_1[1]]),
        "relaxation_rate": np.array([rate[0]]),
        "relaxation_rate_error": np.array([rate[1]]),
        "fit_status": np.array([status], np.int8),
        "mu": np.array([[1.0, 1.0]]),
        "deviation": np.array([[0.05, first[0]]]),
        "deviation_error": np.array([[0.0, first[1]]]),
        "degrees_of_freedom": np.array([groups - 1]),
    }
    names = ("mu_1", "relaxation_rate")
    goal = Goal(4, dict.fromkeys(names, bias), dict.fromkeys(names, scatter), 100.0)
    actual = attained(estimates, [goal], np.array([1.2]), WANTED, np.array([100]))
    return float(actual.reached[0]), int(actual.status[0]), float(actual.growth[0])


CASES = {
    "the worst estimate counts with its bias": (
        {"bias": 0.02, "mu_1": (1.0, 0.03), "rate": (2.0, 0.1)},
        (0.05 + 0.02, MET, (0.05 / 0.08) ** 2),
    ),
    "a missed accuracy has a growth": ({"rate": (2.0, 0.4)}, (0.2, MISSED, 4.0)),
    "realizations do not reduce a bias": (
        {"bias": 0.2, "mu_1": (1.0, 0.04), "rate": (1.0, 0.01)},
        (0.24, MISSED, 0.64),
    ),
    "without relaxation the other estimates count": (
        {"rate": NAN, "status": NO_RELAXATION, "first": (1e-5, 1e-5)},
        (0.01, MET_WHERE_DEFINED, 0.01),
    ),
    "an uncertain relaxation still counts": (
        {"rate": NAN, "status": NO_RELAXATION, "first": (0.015, 0.03)},
        (np.inf, MISSED, np.inf),
    ),
    "noise": ({"rate": NAN, "status": UNDETERMINED}, (np.inf, MISSED, np.inf)),
    "not finite": ({"rate": NAN, "status": NOT_FINITE}, (np.inf, MISSED, 0.0)),
    "no exponential": ({"rate": NAN, "status": NOT_EXPONENTIAL}, (0.01, MET_WHERE_DEFINED, 0.01)),
    "few groups do not show another shape": (
        {"rate": NAN, "status": NOT_EXPONENTIAL, "groups": 8},
        (np.inf, MISSED, np.inf),
    ),
    "an exact zero has no relative error": ({"mu_1": ZERO}, (0.01, MET_WHERE_DEFINED, 0.01)),
    "a zero with an error": ({"mu_1": (0.0, 0.1)}, (np.inf, MISSED, np.inf)),
    "a negligible rate": (
        {"rate": (2.0, 1.0), "status": NEGLIGIBLE},
        (0.01, MET_WHERE_DEFINED, 0.01),
    ),
    "the scatter law is not used for many groups": ({"scatter": 9.0}, (0.01, MET, 0.01)),
    "nor for eight groups": ({"scatter": 9.0, "groups": 8}, (0.01, MET, 0.01)),
    "the scatter law is used for seven groups": (
        {"scatter": 0.5, "groups": 7},  # (3 * 0.05^2 + 6 * 0.01^2)/9
        (0.03, MET, 0.09),
    ),
    "two groups that agree by chance": (
        {"groups": 2, "scatter": 2.0},  # (3 * 0.2^2 + 0.01^2)/4
        (np.sqrt(0.030025), MISSED, 3.0025),
    ),
    "few groups that differ need little more": (
        {"groups": 4, "scatter": 0.5, "mu_1": (1.0, 0.11)},  # (3 * 0.05^2 + 3 * 0.11^2)/6
        (0.11, MISSED, 1.0),
    ),
    "a met estimate is never undefined": ({"first": (1e-9, 1e-12)}, (0.01, MET, 0.01)),
}


@pytest.mark.parametrize("name", CASES)
def test_accuracy_reached_status_and_growth(name):
    estimates, expected = CASES[name]
    assert judge(**estimates) == pytest.approx(expected)


def test_the_accuracy_is_nan_without_relative_errors():
    freedom = np.array([31])
    estimates = {"jump": np.zeros(1), "jump_error": np.zeros(1), "degrees_of_freedom": freedom}
    goal = Goal(4, {"jump": 0.0}, {"jump": 0.1}, 9.0)
    actual = attained(estimates, [goal], np.ones(1), WANTED, np.ones(1))
    assert np.isnan(actual.reached[0])
    assert actual.status[0] == MET_WHERE_DEFINED


MAPS = (
    "scene.body=half-space",
    'scene.quantities=["steady", "jump"]',
    "grid.hurst=0.7",
    "grid.normal_force=3.0",
    "grid.velocity=0.02",
    "grid.spacing=6.25e-4",
    "numerics.max_realizations=64",
    "compare={}",
)


@pytest.mark.parametrize("more", [(), ("numerics.steps_per_spacing=4",)])
def test_a_met_accuracy_of_maps_is_at_least_the_error(tmp_path, more):
    """Patches of contact are smaller here than expected, so that the jump has a larger error."""
    data = run(tmp_path, f"numerics.accuracy={WANTED}", *MAPS, *more).load().squeeze()
    bias = {name: 0.0 if more else data[f"{name}_bias"] for name in ("mu_1", "jump")}
    actual = [float(data[f"{n}_error"] / abs(data[n]) + own) for n, own in bias.items()]
    # For few maps the scatter law may enlarge the errors.
    assert max(actual) <= float(data.accuracy_reached) * (1.0 + 1e-9) <= WANTED
    assert int(data.accuracy_status) == MET
