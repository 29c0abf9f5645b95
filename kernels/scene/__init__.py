"""Scenes: a line taken through a programme, with any material, control and start.

What is kept on the way is chosen by type: what a scene does not ask for is not compiled.
"""

from kernels.scene.energy import ENERGIES
from kernels.scene.records import TRACES
from kernels.scene.run import run_scene
from kernels.scene.scene import ASKED, START, Origin, Saved, Scene, scene_steps, trace_stamps

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
