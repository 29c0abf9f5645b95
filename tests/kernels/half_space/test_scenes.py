"""Programmes on a half-space: those of a line where all waves are as stiff, and its symmetries."""

import numpy as np
import pytest

from elastomer_friction.kernels import Case, Quantities, Slide
from elastomer_friction.kernels.half_space.cases import run_case
from elastomer_friction.kernels.half_space.scenes import run_scene_on_half_space
from elastomer_friction.kernels.half_space.surface import Surface, ring_amplitudes
from elastomer_friction.kernels.scene import TRACES, run_scene
from tests.kernels.scene.given import DAMPED, EVERY_LEG, KELVIN, PRONY, SOLID, a_line, a_scene

M = 4


def rough(elements=8, m=M, seed=1):
    return Surface.drawn(np.random.default_rng(seed), ring_amplitudes(0.7, elements), elements, m)


@pytest.mark.parametrize("start", ["steady", "relaxed"])
@pytest.mark.parametrize(
    "spectrum", [KELVIN, SOLID, PRONY, DAMPED], ids=["kelvin", "solid", "prony", "damped"]
)
def test_where_all_waves_are_as_stiff_it_is_the_line(spectrum, start):
    """Every kind of leg, with ends between samples; only the mean of u is another's."""
    line = a_line(12)
    n = line.z.size
    surface = Surface.from_samples((line.z + line.datum)[None], line.slope[None], M)
    scene = a_scene(EVERY_LEG, spectrum, M, start=start, requested=("trace", "cycle_mean"))
    expected = run_scene(line, scene)
    equal = np.full((1, n // 2 + 1), M / n)
    found = run_scene_on_half_space(surface, scene, stiffness=equal)
    of_lines = "trace_samples_per_contact"  # the median of patches, and the mean on a half-space
    for name in {*TRACES, "mu_cycle_mean"} - {of_lines}:
        shift = scene.load if name == "trace_indentation" else 0.0
        np.testing.assert_allclose(found[name] + shift, expected[name], atol=6e-5, err_msg=name)


def test_a_velocity_step_is_that_of_a_case():
    surface, steps = rough(), np.arange(1, 30)
    case = Case(0.3, 0.7, (1.2,), (steps,), "exponential", PRONY)
    whole = run_case(surface, case, Quantities())
    legs = (Slide(0.7, 2.0), Slide(0.84, float(steps[-1]) / M))
    found = run_scene_on_half_space(surface, a_scene(legs, PRONY, M))["trace_mu"]
    steady = found[0]  # which takes mu from a step of the march
    np.testing.assert_allclose(found[: 2 * M + 1], steady, rtol=1e-5)
    rise = whole.curves[0] - whole.curves[0][0]
    np.testing.assert_allclose(found[2 * M + 1 :] - found[2 * M + 1], rise, atol=1e-5)


def test_snapshots_carry_the_load_where_the_surface_is():
    surface = rough()
    scene = a_scene(
        (Slide(0.7, 2.0),), PRONY, M, requested=("trace", "snapshots"), frames=np.array([0, 5])
    )
    found = run_scene_on_half_space(surface, scene)["snapshot_pressure"]
    assert found.shape == (2, *surface.z.shape)
    np.testing.assert_allclose(found.mean(axis=(1, 2)), 0.3 / 8, rtol=1e-12)
    np.testing.assert_allclose(found[1], np.roll(found[0], 5, axis=1), atol=1e-4)


def test_what_it_does_not_keep_is_refused():
    with pytest.raises(ValueError, match="a half-space has only"):
        run_scene_on_half_space(rough(), a_scene((Slide(0.7, 2.0),), requested=("energy",)))
