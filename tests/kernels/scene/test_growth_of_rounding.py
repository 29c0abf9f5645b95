"""Scenes under heights that differ by a part in 10^12: no kind of scene amplifies rounding."""

import math

import numpy as np
import pytest

from elastomer_friction.kernels import Hold, Oscillation, Slide
from elastomer_friction.kernels.drive import Drive, run_pulled
from elastomer_friction.kernels.half_space.scenes import (
    run_pulled_on_half_space,
    run_scene_on_half_space,
)
from elastomer_friction.kernels.scene import run_scene
from tests.kernels.half_space.test_limits import rough
from tests.kernels.scene.given import SOLID, a_line, a_scene
from tests.sizes import PLAIN_PYTHON

M = 4
SLIDES = (Slide(1.0, 3.0), Slide(2.0, 3.0))
SCENES = {  # name -> (half-space, programme, stiffness of a drive over load times rms slope)
    "programme": (False, SLIDES, None),
    "hold": (False, (Slide(1.0, 3.0), Hold(10.0), Slide(1.0, 3.0)), None),
    "oscillation": (False, (Oscillation(0.1, 0.5, 1.0, 2),), None),
    "drive": (False, (Slide(30.0, 300.0),), 0.02),
    "half-space programme": (True, SLIDES, None),
    "half-space drive": (True, SLIDES, 0.2),
}


@pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: a drive over 300 spacings")
@pytest.mark.parametrize("kind", SCENES)
def test_rounding_of_heights_does_not_grow(kind):
    """Traces agree within the tolerance of the force balance, 1e-5 of their range."""
    on_map, programme, stiffness = SCENES[kind]
    surface = rough(8, M) if on_map else a_line(20)
    scene = a_scene(programme, SOLID, M, start="relaxed" if stiffness else "steady")
    scale = 0.3 * math.sqrt(np.mean(surface.slope**2))

    def friction(factor):
        scaled = surface._replace(z=factor * surface.z, slope=factor * surface.slope)
        if stiffness:
            run = run_pulled_on_half_space if on_map else run_pulled
            values = run(scaled, scene, Drive(stiffness * scale))
        else:
            values = (run_scene_on_half_space if on_map else run_scene)(scaled, scene)
        return values["trace_friction_force"]

    exact, changed = friction(1.0), friction(1.0 + 1e-12)
    assert np.ptp(exact) > 0.0
    np.testing.assert_allclose(changed, exact, rtol=0.0, atol=1e-5 * np.ptp(exact))
