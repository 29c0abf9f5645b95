"""Mean friction under an oscillation: Coulomb's where it is one number, and where it is not."""

import numpy as np
import pytest

from elastomer_friction.studies.ultrasonic.figure import TOP, coulomb, quasi_steady

pytestmark = pytest.mark.exhaustive  # its scenes compile kernels of their own

STUDY = ("ultrasonic",)
RISING, FALLING = 49.6, 5.3  # °C, of the rubber, left and right of its largest friction
SLOW, FAST = 20.0, 2e4  # Hz


@pytest.fixture
def rubber(groups):
    return groups["rubber"]


@pytest.fixture
def kelvin(groups):
    return groups[""]


def ratio_of(data):
    return data.velocity_amplitude.values / float(data.velocity)


def test_a_small_displacement_leaves_friction_as_it_is(rubber, kelvin):
    """At 20 kHz it is below a twentieth of the shortest wave over 2 pi, whatever the velocity."""
    for data in (rubber, kelvin):
        share = data.mu_cycle_share.sel(frequency=FAST)
        assert float(abs(share - 1.0).max()) < 0.06
    assert float(abs(rubber.mu_cycle_share.sel(frequency=FAST) - 1.0).max()) < 0.01


def test_a_slow_oscillation_gives_the_mean_of_steady_friction(rubber):
    for temperature in (RISING, TOP, FALLING):
        at = rubber.sel(temperature=temperature, frequency=SLOW)
        expected = quasi_steady(rubber, temperature, ratio_of(rubber))
        error = 3.0 * at.mu_cycle_share_error.values + 0.05
        assert (abs(at.mu_cycle_share.values - expected) < error).all()


def test_coulombs_law_lies_between_friction_that_rises_and_that_falls(rubber):
    """And is near where friction depends on the velocity least."""
    ratio = ratio_of(rubber)
    above = ratio > 1.2
    law = coulomb(ratio)[above]
    slow = rubber.mu_cycle_share.sel(frequency=SLOW)
    rising, top, falling = (slow.sel(temperature=t).values[above] for t in (RISING, TOP, FALLING))
    assert (rising > 1.3 * law).all()
    assert (falling < 0.9 * law).all()
    assert abs(top - law).max() < 0.07


def test_friction_that_is_proportional_to_the_velocity_is_never_lowered(kelvin):
    """Its mean is that of the mean velocity, whatever the amplitude and the frequency."""
    warm = kelvin.mu_cycle_share.sel(temperature=kelvin.temperature.max())
    np.testing.assert_allclose(warm, 1.0, rtol=0.0, atol=0.015)
