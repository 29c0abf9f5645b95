"""One step of Kelvin units in series: the Kelvin element, its moments, what decays."""

import numpy as np
import pytest
from scipy.integrate import quad

from elastomer_friction.kernels import SCHEMES
from elastomer_friction.kernels.rheology.law import law_of, predict, settle
from elastomer_friction.kernels.rheology.prony import moments
from elastomer_friction.kernels.rheology.retardation import Retardation, retardation
from elastomer_friction.kernels.rheology.spectrum import KELVIN


@pytest.mark.parametrize("dt", np.geomspace(1e-9, 1e9, 19))
def test_one_unit_is_the_kelvin_element(dt):
    law, kelvin = law_of(retardation(KELVIN), dt), SCHEMES["exponential"](dt)
    assert law.decay[0] == pytest.approx(kelvin.decay, rel=1e-15)
    assert law.stiffness == pytest.approx(kelvin.stiffness, rel=1e-14)
    assert law.lag == pytest.approx(kelvin.lag, rel=1e-11)
    assert (law.linear, law.stale[0]) == (0.0, 0.0)


@pytest.mark.parametrize("x", [1e-12, 1e-4, 0.0999, 0.1001, 3.0, 50.0, 1e8])
def test_moments_are_those_of_a_linear_force(x):
    """Weights of the force at the end and at the start, integrated with e^-(x - s)."""
    gone, end, start = moments(x)
    assert gone == pytest.approx(-np.expm1(-x), rel=1e-15)
    assert end + start == pytest.approx(gone, rel=1e-13)
    if x < 100.0:
        expected, _ = quad(lambda s: np.exp(-(1.0 - s) * x) * x * s, 0.0, 1.0, epsrel=1e-13)
        assert end == pytest.approx(expected, rel=1e-11)


def test_a_linear_force_is_followed_exactly():
    """y of a unit under p = t, against -J (t - lambda (1 - e^(-t/lambda))), in uneven steps."""
    form = Retardation(1.0, np.array([0.7, 0.3]), np.array([2.0, 0.1]))
    memory, p, w, now = np.zeros((2, 1)), np.zeros(1), np.empty(1), 0.0
    for dt in (0.01, 0.3, 1.1, 1e-5):
        now += dt
        law, new = law_of(form, dt), np.array([now])
        assert law.linear == 1.0
        predict(law, memory, p, w)
        settle(law, memory, w, p, new)
        p = new
    lag = form.times * -np.expm1(-now / form.times)
    assert memory[:, 0] == pytest.approx(-form.compliances * (now - lag), rel=1e-13)


def test_what_is_left_of_a_state_is_never_subnormal():
    law = law_of(retardation(KELVIN), 1.0)
    memory, w, p = np.array([[-1.0]]), np.empty(1), np.zeros(1)
    for _ in range(1000):
        predict(law, memory, p, w)
        settle(law, memory, w, p, p)
        assert memory[0, 0] == 0.0 or abs(memory[0, 0]) > 1e-201
    assert memory[0, 0] == 0.0
