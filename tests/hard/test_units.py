"""Physical units from 1e-12 to 1e6: the dimensionless problem does not change."""

import pytest

from elastomer_friction.workflow.plan.plan import make_plan
from elastomer_friction.workflow.plan.problems import distinct_problems
from tests.support.small import small_study


def problems(roughness, time, length=0.01):
    """Return the problems of the small study in other units with equal dimensionless numbers."""
    settings = {
        "surface.length": length,
        "material.relaxation_time": time,
        "grid.roughness": roughness,
        "grid.spacing": length / 100.0,
        "grid.normal_force": [f * roughness * length / 1e-7 for f in (0.04, 0.4)],
        "grid.velocity": [v * length / time * 1e-1 for v in (0.03, 0.1)],
    }
    return distinct_problems(small_study(*(f"{k}={v}" for k, v in settings.items())))[0]


@pytest.mark.parametrize("length", [1e-9, 0.01, 1e5])  # m
@pytest.mark.parametrize("time", [1e-12, 2.9e-7, 1e-3, 1.0, 1e6])  # s
@pytest.mark.parametrize("roughness", [1e-12, 3.7e-9, 1e-5, 1.0, 1e3])  # m
def test_units_leave_the_problems_as_they_are(roughness, time, length):
    """Problems are bitwise equal, as rounding to a canonical mantissa removes input rounding."""
    assert problems(roughness, time, length) == problems(1e-5, 1e-3)


def test_a_velocity_step_to_a_thousandth_and_to_a_hundredfold_is_planned():
    plan = make_plan(small_study("grid.velocity_step=[-0.999, 100.0]"))
    ratios = {p.ratio for p in distinct_problems(plan.study)[0]}
    assert sorted(ratios) == pytest.approx([1e-3, 101.0], rel=1e-11)
