"""Rate and state: a rubber of many relaxation times has a, b and D_c, the Kelvin element has not.

At the smoke scale: v1 t q_max = 0.13 and 7.5, steps down and up by a factor of two.
"""

import numpy as np
import pytest

from elastomer_friction.workflow.reduce import FITTED, NO_STATE, UNDETERMINED

pytestmark = pytest.mark.exhaustive  # its scenes compile kernels of their own

STUDY = ("rate_state",)
DOWN, UP = 0, 1
SLOW, FAST = 0, 1


@pytest.fixture
def rubber(groups):
    """Return nine branches: dims velocity, velocity_step and law."""
    return groups[""]


@pytest.fixture
def kelvin(groups):
    """Return the Kelvin element: dims velocity, velocity_step and law."""
    return groups["kelvin"]


def apart(data, name, one, other):
    """Return how many standard errors two points of a variable are apart."""
    values, errors = data[name], data[f"{name}_error"]
    return float(
        abs(values.isel(one) - values.isel(other)) / np.hypot(errors.isel(one), errors.isel(other))
    )


def test_a_rubber_has_a_state_by_either_law(rubber):
    assert (rubber.rate_state_status == FITTED).all()
    assert (rubber.rate_state_residual < 0.05).all()
    for name in ("rate_state_a", "rate_state_b", "rate_state_dc"):
        assert (rubber[name] > 3.0 * rubber[f"{name}_error"]).all()


def test_a_rubber_weakens_and_a_is_one_constant_up_and_down(rubber):
    fast = rubber.isel(velocity=FAST)
    assert (fast.rate_state_a_minus_b < -3.0 * fast.rate_state_a_minus_b_error).all()
    a = rubber.rate_state_a.sel(law="ruina")
    ratio = (a.isel(velocity_step=UP) / a.isel(velocity_step=DOWN)).values
    assert ratio == pytest.approx(1.0, abs=0.2)  # each a is known to 7 %
    own = rubber.isel(velocity=FAST).sel(law="ruina")
    assert apart(own, "rate_state_a", {"velocity_step": UP}, {"velocity_step": DOWN}) < 3.0


def test_critical_distance_of_a_rubber_is_a_length_and_not_that_of_the_finest_waves(rubber):
    """The velocity is 60 times as high; D_c of Ruina's law is the same to 50 %."""
    length = rubber.rate_state_dc.sel(law="ruina")
    assert float(length.max() / length.min()) < 2.0
    assert (length * np.pi / 1e-4 > 3.0).all()
    own = rubber.isel(velocity=FAST, law=0)
    assert apart(own, "rate_state_dc", {"velocity_step": UP}, {"velocity_step": DOWN}) < 3.0


def test_a_kelvin_element_has_no_state_at_low_speed(kelvin):
    slow = kelvin.isel(velocity=SLOW)
    up = slow.rate_state_status.isel(velocity_step=UP)
    assert up.isin([NO_STATE, UNDETERMINED]).all()  # b may be 1e-4 of a, and significant
    assert (slow.rate_state_status != FITTED).all()
    assert slow.rate_state_dc.isnull().all()
    up = slow.isel(velocity_step=UP)
    assert (abs(up.rate_state_b) < 0.01 * up.rate_state_a).all()
    assert up.rate_state_a.values == pytest.approx(float(up.rate_state_a_minus_b), rel=0.01)


def test_a_of_a_kelvin_element_is_no_constant_and_it_strengthens(kelvin):
    """The jump is about linear in the velocity, not in its logarithm."""
    assert (kelvin.rate_state_a_minus_b > 3.0 * kelvin.rate_state_a_minus_b_error).all()
    a = kelvin.isel(velocity=FAST).rate_state_a.sel(law="ruina")
    assert float(a.isel(velocity_step=UP) / a.isel(velocity_step=DOWN)) > 1.2
