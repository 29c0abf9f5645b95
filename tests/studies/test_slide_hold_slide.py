"""Slide, hold, slide: a Kelvin element heals in tau, a broad spectrum until its longest time.

So at a fixed place, which the stiffest spring is; on softer ones the line creeps on in the hold.
"""

import numpy as np
import pytest

from elastomer_friction.studies.slide_hold_slide.figure import LONGEST_TIME, TAU, law

pytestmark = pytest.mark.exhaustive  # its scenes compile kernels of their own

STUDY = ("slide_hold_slide",)


@pytest.fixture(scope="module")
def slow(groups):
    """Return both materials at the lower velocity and a fixed place."""
    return {name: data.isel(velocity=0, stiffness=-1) for name, data in groups.items()}


@pytest.fixture(scope="module")
def fast(groups):
    """Return both materials at the higher velocity and a fixed place."""
    return {name: data.isel(velocity=1, stiffness=-1) for name, data in groups.items()}


def test_a_kelvin_element_heals_in_tau(fast):
    healing = fast[""].healing / fast[""].healing[-1]
    assert healing[0] < 0.2
    late = healing.isel(hold=fast[""].hold.values >= 20.0 * TAU)
    assert late.values == pytest.approx(1.0, abs=1e-2)
    assert float(fast[""].healing[-1]) > 3.0 * float(fast[""].healing_error[-1])


def test_a_broad_spectrum_heals_until_its_longest_time(slow, fast):
    for point in (slow["rubber"], fast["rubber"]):
        within = point.healing.isel(hold=point.hold.values < LONGEST_TIME)
        assert (np.diff(within) > 0.0).all()
        over = point.healing.isel(hold=point.hold.values > 15.0 * LONGEST_TIME)
        assert over[-1] == pytest.approx(float(over[0]), rel=1e-2)
        assert over[0] > 1.2 * within[-1]


def test_holds_follow_the_law_of_dieterich_with_what_the_step_says(slow):
    point = slow["rubber"]
    holds = point.hold.values
    rise, _ = law(point, holds)
    ratio = point.healing.values / rise
    within = (holds > 1e-3) & (holds < LONGEST_TIME)
    assert within.sum() >= 3
    assert ratio[within] == pytest.approx(1.0, abs=0.35)
    assert ratio[-1] < 0.8  # the law goes on


def test_friction_decays_in_a_hold_at_a_fixed_place(fast):
    left = {name: p.mu_end_of_hold / (p.static_peak - p.healing) for name, p in fast.items()}
    hold = fast[""].hold.values
    some = (hold > 5.0 * TAU) & (hold < 20.0 * TAU)
    assert (left[""].values[some] < 0.01).all()
    assert (left["rubber"].values[some] > 0.02).all()
    assert abs(left["rubber"].values[-1]) < 1e-3


def test_on_a_softer_spring_more_friction_is_left_and_less_is_healed(groups):
    data = groups["rubber"]
    middle = (data.hold.values > 1e-3) & (data.hold.values < LONGEST_TIME)
    left = data.mu_end_of_hold.isel(hold=middle).transpose("stiffness", ...).values
    assert (np.diff(left, axis=0) < 0.0).all()
    healed = data.healing.isel(hold=data.hold.values > TAU).transpose("stiffness", ...).values
    assert (np.diff(healed, axis=0) > 0.0).all()


def test_a_kelvin_element_heals_on_no_soft_spring(groups):
    late = groups[""].healing.isel(velocity=1, hold=-1)
    assert abs(float(late[0])) < 0.2 * float(late[-1])
