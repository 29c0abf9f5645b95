"""Materials, lines and scenes shared by the tests of scenes."""

import math

import numpy as np

from elastomer_friction.kernels.lines.line import Line
from elastomer_friction.kernels.motion.legs import Hold, Oscillation, Ramp, Sampled, Slide
from elastomer_friction.kernels.rheology.spectrum import KELVIN, Spectrum
from elastomer_friction.kernels.scene import SCENE_QUANTITIES, SceneCase, run_scene, scene_steps
from tests.lines import random_line
from tests.sizes import size

SOLID = Spectrum((10.0,), (0.1,), 0.0)  # a standard linear solid
PRONY = Spectrum((30.0, 5.0, 2.0), (0.01, 0.05, 0.225), 0.0)
DAMPED = Spectrum((3.0, 1.0), (0.2, 0.1), 0.3)  # branches and a dashpot
MATERIALS = {"kelvin": KELVIN, "solid": SOLID, "prony": PRONY, "damped": DAMPED}

EVERY_LEG = (  # every kind of leg, some ending between samples
    Slide(0.5, 4.3),
    Hold(2.0),
    Slide(-0.8, 3.0),
    Ramp(0.0, 0.7, 6.0),
    Oscillation(0.1, 0.02, 1.0, 1),
    Sampled((0.0, 3.0, 5.0, 7.0), (0.7, 0.0, 0.0, -0.4)),
)

PULLS = (  # legs of a drive, forwards and backwards
    Slide(1.3, 4.0),
    Hold(0.7),
    Slide(2.0, 3.0),
    Sampled((0.0, 1.0, 2.5), (2.0, 0.0, -1.5)),
    Slide(-1.5, 3.0),
)

# Quantities that are available for any motion.
ANY_MOTION = tuple(name for name in SCENE_QUANTITIES if name != "cycle_mean")


def a_line(elements=None, hurst=0.7, m=4, seed=3):
    """Return a random Line."""
    return Line.from_samples(*random_line(elements or size(60, 20), hurst, m, seed), m)


def a_scene(programme, spectrum=KELVIN, m=4, **changes):
    """Return a scene with F̄ = 0.3 or a given indentation, and with every step recorded."""
    values = {
        "spectrum": spectrum,
        "scheme": "exponential",
        "programme": programme,
        "load": math.nan if changes.get("indentation") is not None else 0.3,
        "indentation": None,
        "start": "steady",
        "requested": ("trace",),
        "recorded": np.arange(1),
        "edges": np.arange(1.0),
        "frames": np.arange(0),
    } | changes
    scene = SceneCase(**values)
    if "recorded" in changes:
        return scene
    return scene._replace(recorded=np.arange(scene_steps(scene, m).dt.size + 1))


def trace(line, programme, spectrum=KELVIN, **changes):
    """Run a scene on a line and return its values."""
    return run_scene(line, a_scene(programme, spectrum, line.steps_per_spacing, **changes))
