"""The Kelvin element in both time schemes: identities of its constants, and their limits."""

import math

import numpy as np
import pytest

from kernels import SCHEMES, Kelvin
from tests.reference_march import constants

STEPS = tuple(np.geomspace(1e-6, 30.0, 15))


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("dt", STEPS)
def test_a_held_element_carries_its_elastic_force(scheme, dt):
    """Held at u the force must be -u (eq. 2): stiffness (1 - decay) = 1."""
    step = SCHEMES[scheme](dt)
    # 1 - decay loses digits as eps / dt.
    assert step.stiffness * (1.0 - step.decay) == pytest.approx(1.0, rel=1e-15 + 4e-16 / dt)


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("dt", np.geomspace(1e-3, 5.0, 9))
def test_constants_follow_from_the_defining_formulas(scheme, dt):
    # 20 Gauss nodes integrate the weight to rounding here; 1 - e^-dt costs eps / dt.
    assert SCHEMES[scheme](dt) == pytest.approx(constants(scheme, dt), rel=1e-12)


@pytest.mark.parametrize("dt", STEPS)
def test_free_decay_of_the_exponential_scheme_is_exact(dt):
    decay = SCHEMES["exponential"](dt).decay
    assert decay == pytest.approx(math.exp(-dt), rel=1e-15)
    assert SCHEMES["exponential"](2.0 * dt).decay == pytest.approx(decay**2, rel=1e-14)


def test_free_decay_of_implicit_euler_is_first_order():
    error = [
        SCHEMES["implicit-euler"](dt).decay ** round(1 / dt) - math.exp(-1) for dt in (1e-3, 5e-4)
    ]
    # Leading error dt/2 e^-1, hence halved with dt up to O(dt).
    assert error[0] / error[1] == pytest.approx(2.0, abs=0.01)


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


def test_implicit_euler_reads_the_slope_at_the_end_of_the_step():
    assert SCHEMES["implicit-euler"](0.3).lag == 0.0


@pytest.mark.parametrize("scheme", SCHEMES)
def test_extreme_steps_stay_finite(scheme):
    for dt in (1e-12, 1e4, 1e12):
        step = SCHEMES[scheme](dt)
        assert isinstance(step, Kelvin)
        assert np.all(np.isfinite(step))
        assert 0.0 <= step.decay < 1.0
        assert step.stiffness >= 1.0
