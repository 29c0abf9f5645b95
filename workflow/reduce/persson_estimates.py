"""Persson's theory at the points of a study, for the rough surface that both bodies share."""

from functools import lru_cache, partial

import numpy as np

from ...kernels import equivalent_of_cut
from ...kernels.half_space.persson import (
    Waves,
    persson_theory,
    waves_of_line,
    waves_of_map,
    waves_of_self_affine,
)
from ..plan import nominal_pressure
from ..simulate import LineShape, Task
from ..study import HALF_SPACE, Surface
from .blocks import Estimates

CUT_KINDS = ("measured", "random-phase")  # lines that are cuts through the rough surface


def persson_values(tasks: list[Task], lines: Surface) -> Estimates:
    """Return friction and contact area at v1 by Persson's theory, for the study's spectrum."""
    theory = np.empty((len(tasks), 2))
    waves_of = lru_cache(maxsize=100)(partial(_waves, lines))
    for row, task in enumerate(tasks):
        problem = task.problem
        waves = waves_of(*problem[:2], problem.surface)
        theory[row] = persson_theory(
            waves,
            problem.spectrum,
            nominal_pressure(problem),
            problem.ends[0],
            problem.effects.layer,
        )
    return {"mu_persson": theory[:, 0], "area_persson": theory[:, 1]}


def _waves(lines: Surface, hurst: float, elements: int, shape: LineShape) -> Waves:
    """Return the waves of the rough surface, which are the same for both bodies."""
    if lines.profile is None or lines.spectrum is None:
        modes = shape.rolloff, shape.cutoff
        return waves_of_self_affine(hurst, elements, *modes, lines.normalisation)
    spectrum = lines.spectrum / lines.profile.roughness
    if lines.body == HALF_SPACE:
        return waves_of_map(spectrum, elements)
    if lines.lines in CUT_KINDS:
        spectrum = equivalent_of_cut(spectrum)
    return waves_of_line(spectrum, elements)
