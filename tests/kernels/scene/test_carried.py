"""Slow branches that are carried along from a start at rest."""

import numpy as np
import pytest

from elastomer_friction.kernels.half_space.body import HalfSpace
from elastomer_friction.kernels.half_space.moved_map import moved_map
from elastomer_friction.kernels.motion.legs import Hold, Oscillation, Slide
from elastomer_friction.kernels.rheology.forms import form_of
from elastomer_friction.kernels.rheology.law import displacement, rest_memory
from elastomer_friction.kernels.rheology.spectrum import Spectrum
from elastomer_friction.kernels.rheology.stretches import branch_stretches, stretch_branches
from elastomer_friction.kernels.scene.carried import carried_branches
from elastomer_friction.kernels.scene.initial_state import initial_state
from tests.kernels.half_space.test_limits import rough
from tests.kernels.scene.given import a_line, a_scene, trace

SCHEMES = ["exponential", "implicit-euler"]
ELEMENTS, M = 32, 4
SLOW = Spectrum((3.0, 10.0), (60.0, 900.0), 0.0)
WHOLE = Spectrum((10.0, *SLOW.moduli), (0.05, *SLOW.times), 0.0)
SPEED = 4.0  # a period takes 8 tau


@pytest.mark.parametrize("scheme", SCHEMES)
def test_stretches_survive_a_change_of_the_form(scheme):
    form, u = form_of(WHOLE, scheme), np.linspace(-1.0, 0.0, 5)
    stretches = np.outer([0.3, -0.2, 0.7], u) + 0.1
    memory = rest_memory(form, -u)
    assert np.allclose(branch_stretches(WHOLE, form, memory, u), 0.0, atol=1e-12)
    stretch_branches(WHOLE, form, memory, stretches)
    np.testing.assert_allclose(branch_stretches(WHOLE, form, memory, u), stretches, atol=1e-12)
    moduli = np.array(WHOLE.moduli)[np.argsort(WHOLE.times)[::-1]]
    force = -(u + moduli @ stretches)
    np.testing.assert_allclose(displacement(form, memory, force), u, atol=1e-12)


def start_of(body, scheme, speed):
    """Return (form, memory, forces) of both bodies at the start, of maps as if they were lines."""
    legs = (Slide(speed, 3.0 * ELEMENTS),)
    scene = a_scene(legs, WHOLE, M, start="relaxed", scheme=scheme)
    carried = carried_branches("relaxed", WHOLE, legs, ELEMENTS)
    form = form_of(WHOLE, scheme)
    if body == "line":
        state = initial_state(a_line(ELEMENTS), scene, form, carried)
        return form, state.memory, state.p
    space = HalfSpace.under(form, rough(ELEMENTS, M), scene.load)
    _, state, *_ = moved_map(space, scene, float, lambda law: 1e-5, carried)
    return form, state.body.memory, state.body.depth


@pytest.mark.parametrize("body", ["line", "map"])
@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("speed", [SPEED, -SPEED])
def test_stretches_are_those_of_displacements_that_move_along(body, scheme, speed):
    """Closed form: D(q) i omega t/(1 + i omega t) with omega = -q v; fast branches are relaxed."""
    form, memory, p = start_of(body, scheme, speed)
    u = displacement(form, memory, p)
    stretches = branch_stretches(WHOLE, form, memory, u)
    q = 2.0 * np.pi * M * np.fft.rfftfreq(ELEMENTS * M)
    for time, stretch in zip(sorted(WHOLE.times, reverse=True), stretches, strict=True):
        turn = -1j * q * speed * time if time in SLOW.times else 0.0 * q
        modes = np.fft.rfft(u.reshape(-1, ELEMENTS * M)) * turn / (1.0 + turn)
        expected = np.fft.irfft(modes, ELEMENTS * M).ravel()
        np.testing.assert_allclose(stretch, expected, atol=2e-3 * np.abs(u).max())


@pytest.mark.parametrize(
    "legs",
    [
        (Slide(SPEED, 0.9 * ELEMENTS),),
        (Hold(1.0), Slide(SPEED, 3.0 * ELEMENTS)),
        (Oscillation(0.0, ELEMENTS, 0.01, 3), Slide(SPEED, 3.0 * ELEMENTS)),
        (Slide(1e-3 * SPEED, 3.0 * ELEMENTS),),
    ],
    ids=["no period", "hold", "oscillation", "slow"],
)
def test_nothing_is_carried_along(legs):
    assert carried_branches("relaxed", WHOLE, legs, ELEMENTS) is None
    assert carried_branches("steady", WHOLE, (Slide(SPEED, 99.0),), ELEMENTS) is None


@pytest.mark.parametrize("scheme", SCHEMES)
def test_a_fixed_indentation_stays_given(scheme):
    line = a_line(ELEMENTS)
    legs, settings = (Slide(SPEED, 2.0 * ELEMENTS),), {"scheme": scheme, "indentation": 1.0}
    values = trace(line, legs, WHOLE, start="relaxed", **settings)
    np.testing.assert_allclose(values["trace_indentation"], 1.0, rtol=1e-12)
    late = values["trace_distance"] > 0.5 * ELEMENTS
    assert np.ptp(values["trace_mu"][late]) < 1e-2 * values["trace_mu"][-1]
