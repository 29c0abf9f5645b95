"""Scenes: a line taken through a programme, with any material, control and start.

What is kept on the way is chosen by type: what a scene does not ask for is not compiled.
"""

from elastomer_friction.kernels.scene.energy import ENERGIES
from elastomer_friction.kernels.scene.records import TRACES
from elastomer_friction.kernels.scene.run import run_scene
from elastomer_friction.kernels.scene.scene import (
    ASKED,
    START,
    Origin,
    Saved,
    Scene,
    scene_steps,
    trace_stamps,
)

__all__ = [
    "ASKED",
    "ENERGIES",
    "START",
    "TRACES",
    "Origin",
    "Saved",
    "Scene",
    "run_scene",
    "scene_steps",
    "trace_stamps",
]
