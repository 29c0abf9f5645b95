"""Steady sliding with internal variables: against marches, Kelvin elements, and on hard lines."""

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from elastomer_friction.kernels import SCHEMES, steady_sliding
from elastomer_friction.kernels.branches.steady_memory import steady_memory
from elastomer_friction.kernels.rheology.forms import FORMS_BY_SCHEME
from elastomer_friction.kernels.rheology.law import Elements, rest_memory
from elastomer_friction.kernels.rheology.retardation import retardation
from elastomer_friction.kernels.rheology.spectrum import KELVIN, Spectrum
from tests.lines import random_line
from tests.references import sorted_root
from tests.sizes import size
from tests.viscoelastic import MATERIALS, PRONY3, Foundation

N, M, LOAD = size(40, 12), 4, 0.1


def three_modes(n, offset=0.0):
    """Return a smooth line of three modes over one period of n samples, deepest at zero."""
    x = 2.0 * np.pi * (np.arange(n) + offset) / n
    z = np.cos(x) + 0.5 * np.cos(2.0 * x + 1.0) + 0.2 * np.cos(5.0 * x + 2.0)
    return z - z.min()


@pytest.mark.parametrize("name", ["Prony3", "dashpot"])
def test_a_march_from_rest_reaches_the_steady_state(name):
    z = three_modes(48)
    form, load = retardation(MATERIALS[name]), LOAD * z.size
    speed = 2.0 * z.size  # the longest relaxation time lasts a few periods
    start = sorted_root(z, load)
    p = np.maximum(0.0, start - z)
    line = Foundation(form, z, Elements(rest_memory(form, p), p, start))
    state = steady_memory(form, z, speed, load)
    far = abs(start - state.d)
    for _ in range(24 * z.size):
        line.step(1, 1.0 / speed, load=load)
    assert line.d == pytest.approx(state.d, abs=1e-4 * far)


@pytest.mark.parametrize("speed", [0.1, 3.0, 80.0])
def test_one_unit_is_the_kelvin_element(speed):
    z, _ = random_line(N, 0.7, M, 5)
    load = LOAD * z.size
    (w, d), _ = steady_sliding(SCHEMES["exponential"](1.0 / speed), z, load)
    elements = steady_memory(retardation(KELVIN), z, speed, load).elements
    assert elements.d == pytest.approx(d, rel=1e-13)
    assert np.array_equal(elements.p > 0.0, z - w < d)
    assert elements.memory[0] == pytest.approx(np.minimum(w, z - d), abs=1e-12)


@pytest.mark.parametrize("name", MATERIALS)
def test_given_indentation_carries_the_load_that_produces_it(name):
    z, _ = random_line(N, 0.7, M, 5)
    form = retardation(MATERIALS[name])
    under_load = steady_memory(form, z, 5.0, LOAD * z.size)
    at_d = steady_memory(form, z, 5.0, np.nan, under_load.d)
    assert at_d.p.sum() == pytest.approx(LOAD * z.size, rel=1e-10)
    above = steady_memory(form, z, 5.0, np.nan, -1.0).elements
    assert not above.p.any()
    assert not above.memory.any()


@settings(max_examples=size(150, 10))
@example([2.0], [(0.0, 0.0)] * 4 + [(3.0, 0.0)], 0.0, -6.0, 1.0, "exponential")  # 1e-6 below 2
@example([0.0] * 30, [(0.0, 0.0), (1.0, -2.0)], 0.0, -1.0, 1.0, "implicit-euler")  # flat
@example([1.0, 0.0] * 15, [(0.0, 0.0), (1.0, -2.0)], 4.0, -3.0, -1.0, "implicit-euler")  # teeth
@given(
    st.lists(st.floats(0.0, 5.0), min_size=1, max_size=30),
    st.lists(st.tuples(st.floats(-2, 3), st.floats(-4, 4)), min_size=1, max_size=6),
    st.floats(-4, 4),
    st.floats(-6, 3),
    st.sampled_from([1.0, -1.0]),
    st.sampled_from(list(FORMS_BY_SCHEME)),
)
def test_any_line_and_material(z, branches, speed, load, direction, scheme):
    """For any arguments the state is periodic and carries the load."""
    z = np.array(z)
    spectrum = Spectrum(tuple(10.0**g for g, _ in branches), tuple(10.0**t for _, t in branches), 0)
    state = steady_memory(
        FORMS_BY_SCHEME[scheme](spectrum), z, direction * 10.0**speed, 10.0**load * z.size
    )
    assert state.residual < 1e-7
    assert state.p.sum() == pytest.approx(10.0**load * z.size, rel=1e-6)
    assert state.p.min() >= 0.0


def test_lack_of_convergence_is_an_error(monkeypatch):
    monkeypatch.setattr(f"{steady_memory.__module__}.MAX_TURNS", 1)
    with pytest.raises(ValueError, match="speed = 2 samples per tau: no steady state was found"):
        steady_memory(retardation(PRONY3), three_modes(8), 2.0, 1.0)
