"""Scenes: a line taken through a programme of motion, with any material, control and start.

What is kept on the way is chosen by type: what a scene does not ask for is not compiled.
"""

from kernels.scene.run import run_scene
from kernels.scene.scene import ASKED, Saved, Scene, scene_steps, trace_stamps

__all__ = ["ASKED", "Saved", "Scene", "run_scene", "scene_steps", "trace_stamps"]
