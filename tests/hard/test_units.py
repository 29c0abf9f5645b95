"""Physical units from 1e-12 to 1e6: the dimensionless problem, and its results, are the same."""

import numpy as np
import pytest

from tests.support.small import small_study
from workflow.errors import UserError
from workflow.plan.plan import make_plan
from workflow.plan.problems import distinct_problems

ROUGHNESS = (1e-12, 3.7e-9, 1e-5, 1.0, 1e3)  # m
TIMES = (1e-12, 2.9e-7, 1e-3, 1.0, 1e6)  # s
LENGTHS = (1e-9, 0.01, 1e5)  # m


def problems(roughness, time, length=0.01):
    """Return the problems of the small study in other units, its dimensionless numbers kept."""
    settings = {
        "surface.length": length,
        "material.relaxation_time": time,
        "grid.roughness": roughness,
        "grid.spacing": length / 100.0,
        "grid.normal_force": [f * roughness * length / 1e-7 for f in (0.04, 0.4)],
        "grid.velocity": [v * length / time * 1e-1 for v in (0.03, 0.1)],
    }
    return distinct_problems(small_study(*(f"{k}={v}" for k, v in settings.items())))[0]


@pytest.mark.parametrize("length", LENGTHS)
@pytest.mark.parametrize("time", TIMES)
@pytest.mark.parametrize("roughness", ROUGHNESS)
def test_units_leave_the_problems_as_they_are(roughness, time, length):
    """To the bit: what rounding of the input splits, the canonical mantissa joins."""
    assert problems(roughness, time, length) == problems(1e-5, 1e-3)


@pytest.mark.parametrize(
    ("setting", "named"),
    [
        ("grid.roughness=0.0", "grid.roughness"),  # a flat line has no Fbar
        ("grid.roughness=-1e-5", "grid.roughness"),
        ("grid.roughness=nan", "grid.roughness"),
        ("grid.velocity_step=-1.0", "grid.velocity_step"),
        ("grid.hurst=1.01", "grid.hurst"),
        ("grid.normal_force=0.0", "grid.normal_force"),
        ("material.relaxation_time=1e12", "grid.velocity"),  # steps of 1e-13 tau
        ("material.relaxation_time=1e-15", "grid.velocity"),  # x = 1e-12
    ],
)
def test_what_cannot_be_resolved_is_refused_before_anything_runs(setting, named):
    with pytest.raises(UserError, match=named):
        make_plan(small_study(setting, "scene.quantities=['steady','jump']"))


def test_a_velocity_step_to_a_thousandth_and_to_a_hundredfold_is_planned():
    plan = make_plan(small_study("grid.velocity_step=[-0.999, 100.0]"))
    ratios = {p.ratio for p in distinct_problems(plan.study)[0]}
    assert np.allclose(sorted(ratios), [1e-3, 101.0], rtol=1e-11, atol=0.0)
