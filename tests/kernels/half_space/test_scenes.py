"""Scenes on a half-space, against lines for equal stiffness of all waves, and against cases."""

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
def test_a_half_space_of_equal_stiffness_follows_the_line(spectrum, start):
    """The programme has every kind of leg and ends between samples. Only the mean of u differs."""
    line = a_line(12)
    n = line.z.size
    surface = Surface.from_samples((line.z + line.datum)[None], line.slope[None], M)
    scene = a_scene(EVERY_LEG, spectrum, M, start=start, requested=("trace", "cycle_mean"))
    expected = run_scene(line, scene)
    equal = np.full((1, n // 2 + 1), M / n)
    result = run_scene_on_half_space(surface, scene, stiffness=equal)
    of_lines = "trace_samples_per_contact"  # median on a line, mean on a half-space
    for name in {*TRACES, "mu_cycle_mean"} - {of_lines}:
        shift = scene.load if name == "trace_indentation" else 0.0
        np.testing.assert_allclose(result[name] + shift, expected[name], atol=6e-5, err_msg=name)


def test_a_velocity_step_agrees_with_a_case():
    surface, steps = rough(), np.arange(1, 30)
    case = Case(0.3, 0.7, (1.2,), (steps,), "exponential", PRONY)
    whole = run_case(surface, case, Quantities())
    legs = (Slide(0.7, 2.0), Slide(0.84, float(steps[-1]) / M))
    result = run_scene_on_half_space(surface, a_scene(legs, PRONY, M))["trace_mu"]
    steady = result[0]  # mu of a step of the march
    np.testing.assert_allclose(result[: 2 * M + 1], steady, rtol=1e-5)
    rise = whole.curves[0] - whole.curves[0][0]
    np.testing.assert_allclose(result[2 * M + 1 :] - result[2 * M + 1], rise, atol=1e-5)


def test_snapshots_carry_the_load_and_move_with_the_surface():
    surface = rough()
    scene = a_scene(
        (Slide(0.7, 2.0),), PRONY, M, requested=("trace", "snapshots"), frames=np.array([0, 5])
    )
    result = run_scene_on_half_space(surface, scene)["snapshot_pressure"]
    assert result.shape == (2, *surface.z.shape)
    np.testing.assert_allclose(result.mean(axis=(1, 2)), 0.3 / 8, rtol=1e-12)
    np.testing.assert_allclose(result[1], np.roll(result[0], 5, axis=1), atol=1e-4)


def test_unavailable_quantities_are_refused():
    with pytest.raises(ValueError, match="a half-space has only"):
        run_scene_on_half_space(rough(), a_scene((Slide(0.7, 2.0),), requested=("energy",)))
