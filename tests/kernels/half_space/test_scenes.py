"""Scenes on a half-space, compared with cases."""

import numpy as np
import pytest

from elastomer_friction.kernels import Case, Hold, Quantities, Slide, Spectrum
from elastomer_friction.kernels.half_space.cases import run_case
from elastomer_friction.kernels.half_space.scenes import run_scene_on_half_space
from elastomer_friction.kernels.rheology.spectrum import relaxation_modulus
from tests.kernels.half_space.test_limits import rough
from tests.kernels.scene.given import PRONY, a_scene
from tests.sizes import PLAIN_PYTHON

M = 4


def test_a_velocity_step_agrees_with_a_case():
    surface, steps = rough(8, M), np.arange(1, 30)
    case = Case(0.3, 0.7, (1.2,), (steps,), "exponential", PRONY)
    whole = run_case(surface, case, Quantities())
    legs = (Slide(0.7, 2.0), Slide(0.84, float(steps[-1]) / M))
    result = run_scene_on_half_space(surface, a_scene(legs, PRONY, M))["trace_mu"]
    steady = result[0]  # mu of a step in the march
    np.testing.assert_allclose(result[: 2 * M + 1], steady, rtol=1e-5)
    rise = whole.curves[0] - whole.curves[0][0]
    np.testing.assert_allclose(result[2 * M + 1 :] - result[2 * M + 1], rise, atol=1e-5)


def test_snapshots_carry_the_load_and_move_with_the_surface():
    surface = rough(8, M)
    scene = a_scene(
        (Slide(0.7, 2.0),), PRONY, M, requested=("trace", "snapshots"), frames=np.array([0, 5])
    )
    result = run_scene_on_half_space(surface, scene)["snapshot_pressure"]
    assert result.shape == (2, *surface.z.shape)
    np.testing.assert_allclose(result.mean(axis=(1, 2)), 0.3 / 8, rtol=1e-12)
    np.testing.assert_allclose(result[1], np.roll(result[0], 5, axis=1), atol=1e-4)


def test_unavailable_quantities_are_refused():
    with pytest.raises(ValueError, match="a half-space has only"):
        run_scene_on_half_space(rough(8, M), a_scene((Slide(0.7, 2.0),), requested=("energy",)))


@pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: nine decades of time")
def test_a_contact_at_rest_ages_with_the_relaxation_modulus():
    """A E(t)/sigma_0 is constant to 10 % over nine decades, for a rubber of flat loss."""
    decades = np.arange(-9.0, 3.0)
    flat = Spectrum(tuple(0.5 + 0.0 * decades), tuple(10.0**decades), 0.0)
    legs = tuple(Hold(10.0**k) for k in range(-8, 1, 2))
    scene = a_scene(legs, flat, 8, start="fresh", load=0.05 * 16)
    values = run_scene_on_half_space(rough(16, 8), scene)
    time, area = values["trace_time"][1:], values["trace_contact_fraction"][1:]
    constant = area * relaxation_modulus(flat, time)
    inside = (time > 1e-9) & (time < 1.0)
    assert area[-1] > 2.5 * area[0]
    np.testing.assert_allclose(constant[inside], constant[inside].mean(), rtol=0.1)
    assert np.ptp(values["trace_distance"]) == 0.0
