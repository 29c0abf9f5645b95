"""Scenes: a line taken through a programme, with any material, control and start.

Recorders dispatch on types, so quantities that a scene does not request are not compiled.
"""

from .carried import MAX_REMEMBERED, carried_branches
from .energy import ENERGIES
from .records import MOTION_TRACES, TRACES
from .run import run_scene
from .scene_case import SCENE_QUANTITIES, ZERO_ORIGIN, Origin, SavedState, SceneCase, scene_steps
