"""Scenes: a line taken through a programme, with any material, control and start.

What is kept on the way is chosen by type: what a scene does not ask for is not compiled.
"""

from .energy import ENERGIES
from .records import MOTION, TRACES
from .run import run_scene
from .scene_case import ASKED, START, Origin, Saved, SceneCase, scene_steps

__all__ = [
    "ASKED",
    "ENERGIES",
    "MOTION",
    "START",
    "TRACES",
    "Origin",
    "Saved",
    "SceneCase",
    "run_scene",
    "scene_steps",
]
