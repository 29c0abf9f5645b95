"""Persson's theory at the points of a study, for the rough surface that both bodies share."""

from functools import lru_cache, partial

import numpy as np

from ...kernels import IsotropicSpectrum, equivalent_of_cut
from ...kernels.half_space.persson import (
    Waves,
    persson_theory,
    waves_of_line,
    waves_of_map,
    waves_of_rings,
    waves_of_self_affine,
)
from ..plan import nominal_pressure
from ..simulate import LineShape, Task
from ..study import HALF_SPACE, Surface
from .blocks import Estimates

RINGS = 400  # of a measured spectrum
CUT_KINDS = ("measured", "random-phase")  # lines that are cuts through the rough surface


def persson_values(tasks: list[Task], lines: Surface, roughness: float) -> Estimates:
    """Return friction and contact area at v1 by Persson's theory, for the study's spectrum.

    roughness : of lines of a measured spectrum, m.
    """
    theory = np.empty((len(tasks), 2))
    waves_of = lru_cache(maxsize=100)(partial(_waves, lines, roughness))
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


def _waves(
    lines: Surface, roughness: float, hurst: float, elements: int, shape: LineShape
) -> Waves:
    """Return the waves of the rough surface, which are the same for both bodies."""
    if lines.power is not None:
        return _waves_of_spectrum(lines.power, lines, roughness, lines.length / elements)
    if lines.profile is None or lines.spectrum is None:
        modes = shape.rolloff, shape.cutoff
        return waves_of_self_affine(hurst, elements, *modes, lines.normalisation)
    spectrum = lines.spectrum / lines.profile.roughness
    if lines.body == HALF_SPACE:
        return waves_of_map(spectrum, elements)
    if lines.lines in CUT_KINDS:
        spectrum = equivalent_of_cut(spectrum)
    return waves_of_line(spectrum, elements)


def _waves_of_spectrum(
    power: IsotropicSpectrum, lines: Surface, roughness: float, spacing: float
) -> Waves:
    """Return all waves of a measured spectrum up to the cut-off, including those longer than L."""
    last = 2.0 * np.pi / max(lines.least_wave, 2.0 * spacing)
    heights, slopes = power.moments_below(np.geomspace(power.q[0], last, RINGS + 1))
    ring_power = np.diff(heights)
    q = np.sqrt(np.diff(slopes) / ring_power)
    return waves_of_rings(q * spacing, ring_power / roughness**2)
