"""Steady sliding with internal variables: against marches, Kelvin elements, and on hard lines."""

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from elastomer_friction.kernels import SCHEMES, steady_sliding
from elastomer_friction.kernels.branches.steady_memory import (
    heights_in_order,
    steady_memory,
    turn_element,
)
from elastomer_friction.kernels.quick.tangents import powers_of_steps, tangents_of
from elastomer_friction.kernels.rheology.forms import FORMS_BY_SCHEME
from elastomer_friction.kernels.rheology.law import Elements, law_of, memory_size, rest_memory
from elastomer_friction.kernels.rheology.lookahead import lookahead_law
from elastomer_friction.kernels.rheology.retardation import retardation
from elastomer_friction.kernels.rheology.spectrum import KELVIN, Spectrum
from tests.convergence import observed_order
from tests.lines import random_line
from tests.references import sorted_root
from tests.sizes import PLAIN_PYTHON, size
from tests.viscoelastic import MATERIALS, PRONY3, SBR, Foundation, of_unit_tau

N, M, LOAD = size(40, 12), 4, 0.1


def three_modes(n, offset=0.0):
    """Return a smooth line of three modes over one period of n samples, deepest at zero."""
    x = 2.0 * np.pi * (np.arange(n) + offset) / n
    z = np.cos(x) + 0.5 * np.cos(2.0 * x + 1.0) + 0.2 * np.cos(5.0 * x + 2.0)
    return z - z.min()


@pytest.mark.parametrize("name", MATERIALS)
@pytest.mark.parametrize("scheme", FORMS_BY_SCHEME)
@pytest.mark.parametrize("speed", [3.0, -40.0])
def test_a_march_from_the_steady_state_stays_there(name, scheme, speed):
    z, _ = random_line(N, 0.7, M, 5)
    form, load = FORMS_BY_SCHEME[scheme](MATERIALS[name]), LOAD * z.size
    state = steady_memory(form, z, speed, load)
    line = Foundation(form, z, state.elements)
    direction = int(np.sign(speed))
    for _ in range(2 * M):
        line.step(direction, 1.0 / abs(speed), load=load)
        assert line.d == pytest.approx(state.d, rel=1e-10)
    assert np.roll(line.p, -line.position) == pytest.approx(state.p, abs=1e-9 * load)


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


@pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: counts are the same, and slow")
def test_thirteen_branches_cost_a_hundredth_of_marching():
    """With a hundred times as many element updates a march is still not within 1e-3."""
    z, _ = random_line(80, 0.7, M, 5)
    form, load = retardation(SBR), LOAD * z.size
    speed = 1.0 * z.size  # the slowest branch lasts 16 periods
    state = steady_memory(form, z, speed, load)
    start = sorted_root(z, load)
    p = np.maximum(0.0, start - z)
    line = Foundation(form, z, Elements(rest_memory(form, p), p, start))
    far = abs(start - state.d)
    for _ in range(100 * state.work // z.size):
        line.step(1, 1.0 / speed, load=load)
    assert abs(line.d - state.d) > 1e-3 * far


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


@pytest.mark.parametrize("name", ["standard", "Prony3"])
def test_both_schemes_converge_to_one_steady_state(name):
    refinements = np.array([1, 2, 4, 8])[: size(4, 3)]
    gaps = []
    for k in refinements * 64:
        gap = []
        for offset in (0.0, 0.3, 0.7):
            d = [
                steady_memory(form(MATERIALS[name]), three_modes(k, offset), 1.0 * k, 0.3 * k)
                for form in FORMS_BY_SCHEME.values()
            ]
            gap.append(d[0].d - d[1].d)
        gaps.append(gap)
    # Only the finest lines resolve the fastest branch.
    assert observed_order(refinements, gaps) > size(1.4, 1.2)
    assert np.abs(gaps[-1]).max() < 1e-3


def test_a_glassy_modulus_that_grows_leads_to_the_kelvin_element():
    """For one branch with g t = 1 and g -> inf the difference falls as 1 / g."""
    z = three_modes(size(256, 64))
    speed, load = 1.0 * z.size, 0.3 * z.size
    kelvin = steady_memory(retardation(KELVIN), z, speed, load).d
    glass = np.array([3e5, 1e6, 3e6])
    gaps = [
        [steady_memory(retardation(Spectrum((g,), (1.0 / g,), 0.0)), z, speed, load).d]
        for g in glass
    ]
    assert observed_order(glass, np.array(gaps) - kelvin) == pytest.approx(1.0, abs=0.1)


LINES = {
    "flat": np.zeros(50),
    "spikes": 5.0 - 5.0 * (np.arange(60) % 17 == 3) - 2.0 * (np.arange(60) == 40),
    "ties": np.array([0.0, 1.0, 1.0, 0.0, 2.0, 2.0, 0.0] * 6),
    "teeth": np.arange(40) % 2 * 1.0,
    "plateaus": np.round(3.0 * np.sin(np.arange(64) * 0.3)) + 3.0,
    "one sample": np.zeros(1),
}


@pytest.mark.parametrize("name", LINES)
@pytest.mark.parametrize("scheme", FORMS_BY_SCHEME)
def test_lines_that_are_not_smooth(name, scheme):
    z = LINES[name]
    for material in (PRONY3, SBR, MATERIALS["dashpot"]):
        for speed, load in ((1e-4, 1e-6), (0.3, 0.1), (-50.0, 3.0), (1e5, 1e-3)):
            form = FORMS_BY_SCHEME[scheme](material)
            state = steady_memory(form, z, speed, load * z.size)
            assert state.residual < 1e-7
            assert state.p.sum() == pytest.approx(load * z.size, rel=1e-6)
            assert state.p.min() >= 0.0
            assert state.elements.memory.shape == (memory_size(form), z.size)
    if name in ("flat", "one sample"):
        assert state.d == pytest.approx(load, rel=1e-6)


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


@pytest.mark.parametrize("speed", [1e-9, 1.0, 1e9])
@pytest.mark.parametrize("scheme", FORMS_BY_SCHEME)
def test_thirty_branches_over_fourteen_decades(scheme, speed):
    material = of_unit_tau(np.full(30, 0.7), np.geomspace(1e-7, 1e7, 30))
    z, _ = random_line(12, 0.5, M, 5)
    state = steady_memory(FORMS_BY_SCHEME[scheme](material), z, speed, LOAD * z.size)
    assert state.residual < 1e-9
    assert state.p.sum() == pytest.approx(LOAD * z.size, rel=1e-9)


def test_lack_of_convergence_is_an_error(monkeypatch):
    monkeypatch.setattr(f"{steady_memory.__module__}.MAX_TURNS", 1)
    with pytest.raises(ValueError, match="speed = 2 samples per tau: no steady state was found"):
        steady_memory(retardation(PRONY3), three_modes(8), 2.0, 1.0)


@pytest.mark.parametrize("scheme", FORMS_BY_SCHEME)
@pytest.mark.parametrize("speed", [1.0, 50.0, 1e4])
def test_tangents_equal_finite_differences_of_a_turn(scheme, speed):
    """At 1 sample per tau the initial state decays to rounding during the turn."""
    z, _ = random_line(N, 0.7, M, 5)
    form = FORMS_BY_SCHEME[scheme](PRONY3)
    state = steady_memory(form, z, speed, LOAD * z.size)
    law, size = lookahead_law(law_of(form, 1.0 / speed)), memory_size(form) + 1
    line, powers = (
        heights_in_order(z, np.argmin(z), -1, z.size),
        powers_of_steps(law, size + 1, z.size),
    )
    ends = []
    for j in range(size):
        for change in (1e-7, -1e-7):
            x, forces = np.zeros(powers.product.shape[0]), np.empty(z.size)
            x[size - 1] = state.d
            x[j] += change
            turn_element(law, line, x, powers, forces)
            ends.append(x[: size + 1])
    measured = (np.array(ends[::2]) - ends[1::2]) / 2e-7
    np.testing.assert_allclose(tangents_of(powers, forces)[0], measured, rtol=0, atol=1e-6)
