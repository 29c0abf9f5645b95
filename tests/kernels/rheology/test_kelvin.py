"""The Kelvin element in both time schemes: identities of its constants, and their limits."""

import numpy as np
import pytest

from elastomer_friction.kernels import SCHEMES, Kelvin
from tests.reference_march import constants


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("dt", np.geomspace(1e-6, 30.0, 15))
def test_constants_are_those_of_the_defining_formulas(scheme, dt):
    step = SCHEMES[scheme](dt)
    # Some formulas lose digits as eps / dt; 20 Gauss nodes integrate the lag to rounding.
    lost = 1e-15 + 4e-16 / dt
    expected = constants(scheme, dt)
    assert step.decay == pytest.approx(expected[0], rel=1e-15)
    assert step[1:] == pytest.approx(expected[1:], rel=1e-12 + lost)
    # Held at u the force must be -u (eq. 2).
    assert step.stiffness * (1.0 - step.decay) == pytest.approx(1.0, rel=lost)


def test_lag_of_the_exponential_scheme_between_its_limits():
    lag = [SCHEMES["exponential"](dt).lag for dt in np.geomspace(1e-12, 1e6, 400)]
    assert lag[0] == pytest.approx(0.5, abs=1e-12)  # dt -> 0: even weight
    assert lag[-1] == pytest.approx(1e-6, rel=1e-12)  # dt -> inf: the last tau counts
    assert np.all(np.diff(lag) < 1e-12)  # falling; rounding of 1/dt - 1/expm1(dt) below 1e-3


@pytest.mark.parametrize("seam", [1e-3, 40.0])
def test_lag_is_continuous_where_its_formula_changes(seam):
    lag = SCHEMES["exponential"]
    # Two differences of 1e-9 seam apart; cancellation leaves eps / dt = 2e-13.
    assert lag(seam * (1 - 1e-9)).lag == pytest.approx(lag(seam * (1 + 1e-9)).lag, rel=3e-9)


@pytest.mark.parametrize("scheme", SCHEMES)
def test_extreme_steps_stay_finite(scheme):
    for dt in (1e-12, 1e4, 1e12):
        step = SCHEMES[scheme](dt)
        assert isinstance(step, Kelvin)
        assert np.all(np.isfinite(step))
        assert 0.0 <= step.decay < 1.0
        assert step.stiffness >= 1.0
