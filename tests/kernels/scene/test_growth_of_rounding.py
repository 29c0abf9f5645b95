"""Scenes under heights that differ by a part in 10^12: no kind of scene amplifies rounding."""

import math
from functools import partial

import numpy as np
import pytest

from elastomer_friction.kernels import Hold, Oscillation, Ramp, Slide
from elastomer_friction.kernels.drive import Drive, run_pulled
from elastomer_friction.kernels.half_space.scenes import (
    run_pulled_on_half_space,
    run_scene_on_half_space,
)
from elastomer_friction.kernels.interface.effects import Effects
from elastomer_friction.kernels.interface.layer import Layer
from elastomer_friction.kernels.interface.shear import Bell, ShearLaw
from elastomer_friction.kernels.scene import run_scene
from elastomer_friction.workflow.reduce.resolution import MAP_BIAS
from tests.kernels.half_space.test_friction_heat import WARM
from tests.kernels.half_space.test_limits import rough
from tests.kernels.scene.given import KELVIN, PRONY, PULLS, SOLID, a_line, a_scene
from tests.sizes import PLAIN_PYTHON

M = 4
SLIDES = (Slide(1.0, 3.0), Slide(2.0, 3.0))
HOLD = (Slide(1.0, 3.0), Hold(10.0), Slide(1.0, 3.0))
SHEAR = ShearLaw(Bell(0.3, 1.0, 3.0), creep_velocity=1e-3)
ON_LINE = {  # name -> (programme, material, changes of the scene, drive over load times rms slope)
    "velocity step": (SLIDES, SOLID, {}, ()),
    "dashpot": (SLIDES, KELVIN, {}, ()),
    "implicit Euler": (SLIDES, SOLID, {"scheme": "implicit-euler"}, ()),
    "relaxed start": (SLIDES, SOLID, {"start": "relaxed"}, ()),
    "fresh start": (SLIDES, SOLID, {"start": "fresh"}, ()),
    "hold": (HOLD, SOLID, {}, ()),
    "reversal": ((Slide(1.0, 3.3), Slide(-1.0, 3.0)), SOLID, {}, ()),
    "ramp": ((Ramp(0.2, 2.0, 4.0),), SOLID, {}, ()),
    "oscillation": ((Oscillation(0.1, 0.5, 1.0, 2),), SOLID, {}, ()),
    "steps of indentation": (
        (Slide(1.0, 6.0),),
        SOLID,
        {"indentation": ((0.0, 2.0, 2.001, 6.0), (0.5, 0.5, 1.0, 1.0)), "start": "relaxed"},
        (),
    ),
    "stick and slip": ((Slide(30.0, 300.0),), SOLID, {"start": "relaxed"}, (0.02,)),
    "drive that turns": (PULLS, SOLID, {}, (0.3, 0.5, 0.2)),
    "ringing mass": ((Slide(2.0, 40.0),), SOLID, {"start": "relaxed"}, (10.0, 0.5)),
}
ON_MAP = {
    "velocity step": (SLIDES, SOLID, {}, ()),
    "hold": (HOLD, SOLID, {}, ()),
    "drive": (SLIDES, SOLID, {"start": "relaxed"}, (0.2,)),
    "shear": (HOLD, SOLID, {"effects": Effects(shear=SHEAR)}, ()),
    "layer": (SLIDES, SOLID, {"effects": Effects(layer=Layer(4.0, "free", 0.5))}, ()),
    "heat": (SLIDES, PRONY, {"effects": Effects(heat=WARM)}, ()),
    "drive with shear and heat": (SLIDES, PRONY, {"effects": Effects(SHEAR, heat=WARM)}, (0.5,)),
}
SCENES = {
    (on_map, name): (on_map, *case)
    for on_map, cases in ((False, ON_LINE), (True, ON_MAP))
    for name, case in cases.items()
}


@pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: a drive over 300 spacings")
@pytest.mark.parametrize(
    ("on_map", "programme", "material", "changes", "drive"),
    SCENES.values(),
    ids=[f"{name} of a {'map' if on_map else 'line'}" for on_map, name in SCENES],
)
def test_rounding_of_heights_does_not_grow(on_map, programme, material, changes, drive):
    """Traces agree within the tolerance of the force balance, 1e-5 of their range.

    With shear, which can stick, a drive may take another sequence of steps: traces then agree
    within the error that a resolved map states.
    """
    surface = rough(8, M) if on_map else a_line(20)
    scene = a_scene(programme, material, M, **changes)
    run = run_scene_on_half_space if on_map else run_scene
    if drive:
        scale = scene.load * math.sqrt(np.mean(surface.slope**2))
        pull = run_pulled_on_half_space if on_map else run_pulled
        run = partial(pull, drive=Drive(*(scale * np.array(drive))))

    def friction(factor):
        scaled = surface._replace(z=factor * surface.z, slope=factor * surface.slope)
        return run(scaled, scene)["trace_friction_force"]

    exact, changed = friction(1.0), friction(1.0 + 1e-12)
    assert np.ptp(exact) > 0.0
    sticks = drive and "effects" in changes
    tolerance = MAP_BIAS * np.max(np.abs(exact)) if sticks else 1e-5 * np.ptp(exact)
    np.testing.assert_allclose(changed, exact, rtol=0.0, atol=tolerance)
