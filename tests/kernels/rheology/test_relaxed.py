"""The relaxation form: the implicit Euler scheme of Kelvin, and branches in parallel."""

import numpy as np
import pytest

from elastomer_friction.kernels import SCHEMES
from elastomer_friction.kernels.rheology.law import law_of, predict, settle
from elastomer_friction.kernels.rheology.relaxed import relaxation
from elastomer_friction.kernels.rheology.spectrum import KELVIN
from tests.viscoelastic import PRONY3


@pytest.mark.parametrize("dt", np.geomspace(1e-9, 1e6, 16))
def test_without_branches_it_is_implicit_euler(dt):
    law, kelvin = law_of(relaxation(KELVIN), dt), SCHEMES["implicit-euler"](dt)
    assert (law.stiffness, law.lag) == (pytest.approx(kelvin.stiffness, rel=1e-15), 0.0)
    memory, w = np.array([[-1.0]]), np.empty(1)
    predict(law, memory, np.zeros(1), w)
    assert w == pytest.approx(-kelvin.decay, rel=1e-14)
    settle(law, memory, w, np.zeros(1), np.zeros(1))
    assert memory[0] == pytest.approx(-kelvin.decay, rel=1e-14)


def test_a_constant_rate_is_followed_exactly():
    """p of u = -t: t + sum g t_b (1 - e^(-t/t_b)), in uneven steps."""
    form = relaxation(PRONY3)
    memory, w, now, p = np.zeros((4, 1)), np.empty(1), 0.0, np.zeros(1)
    for dt in (0.01, 0.3, 1.1, 1e-5):
        now += dt
        law = law_of(form, dt)
        predict(law, memory, p, w)
        p = law.stiffness * (w + now)
        settle(law, memory, w, p, p)
        stresses = form.moduli * form.times * -np.expm1(-now / form.times)
        assert p == pytest.approx(now + stresses.sum(), rel=1e-11)
    assert memory[-1] == pytest.approx(-now, rel=1e-13)
    assert memory[:-1, 0] == pytest.approx(-stresses, rel=1e-11)
