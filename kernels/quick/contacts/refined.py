"""Steady sliding where contacts are narrow: the line is refined where it can touch.

At light load and high speed an element stays behind the line and only the front of the highest
peaks touches, over less than a sample. The line is a smooth function known by its heights and
slopes, so it is interpolated where it lies below the indentation; all else is out of contact, and
elements fly over it (steady/carry.py). Fine samples there stand for a finer line throughout.
"""

import math
from typing import NamedTuple

import numpy as np

from ...lines.line import Line
from ...model.friction import corrected_share
from ...rheology.kelvin import SCHEMES
from ...rheology.law import State
from ..steady.spans import SPAN
from ..steady.stack import Stack, spans_of_line
from .fine_line import curvatures, mark_touchable, marked
from .loads import CONTACT, INDENTATION, MU, SAMPLES, SWEEPS, How
from .part import NONE, Part, slide_on

LEAST_STEPS = 4  # samples per spacing, eight in the shortest wave: heights in between to 1e-3
NARROW = 24.0  # samples per contact; in wider ones quadrature keeps 2 % of the jump
FINE = 48.0  # samples per contact that are aimed at; half of it will do
MOST_FOLD = 2**17  # fine samples for one
MOST_SAMPLES = 2_000_000  # fine ones of all
MARGIN = 2e-3  # of the indentation: intervals that are nearer to touching are refined
TRIED = 12


class Refined(NamedTuple):
    """Steady sliding on finer samples of the stretches that can touch."""

    fold: int  # fine samples for one of the line
    samples: float  # fine ones per contact
    d: float  # over the deepest sample of the line, in h
    mu: float  # in h/dx
    contact: float  # share of the line
    jumps: np.ndarray  # shape (others,): change of mu at the moment of a jump
    updates: int  # of elements


def curvatures_of(line: Line) -> np.ndarray | None:
    """Return z'' (in h/dx^2, shape (n,)), or None where it is not known between the samples."""
    if not line.band_limited or line.steps_per_spacing < LEAST_STEPS:
        return None
    return curvatures(line.z, line.slope, 1.0 / line.steps_per_spacing)


def refined(
    line: Line,
    stack: Stack,
    curvature: np.ndarray,
    speeds: tuple[float, ...],
    scheme: str,
    load: float,
    state: State,
    samples: float,
) -> Refined | None:
    """Return steady sliding on a refined line, or None where what could touch is too long.

    stack, curvature : of the line. speeds : vbar, of sliding and then those that are jumped to.
    load : n Fbar. state, samples : of steady sliding on the line as it is, and the samples per
    contact.
    """
    steps, n = line.steps_per_spacing, line.z.size
    low = mark_touchable(line.z, line.slope, spans_of_line(stack, 0), state, 1.0 / steps, MARGIN)
    fold, near = finer(samples), state.d
    at_speeds = speeds[0], np.array(speeds[1:]), NONE
    for _ in range(TRIED):
        at = marked(low, SPAN // math.gcd(SPAN, fold))  # so that fine samples make whole spans
        if fold > MOST_FOLD or at.size * fold > MOST_SAMPLES:
            return None
        law = SCHEMES[scheme](1.0 / (steps * fold * speeds[0]))
        fine = float(steps * fold)
        part = Part(stack, curvature, at, fold, low)
        how = How(fine, corrected_share(fine, speeds[0]), True)
        loads, guesses = np.array([load * fold]), np.array([[near]])
        _, _, under, missed = slide_on(law, part, at_speeds, loads, guesses, how)
        found = under.table[0, 0]
        near = float(found[INDENTATION])
        if missed:
            continue
        if found[SAMPLES] >= 0.5 * FINE:
            contact = found[CONTACT] * at.size / n
            updates = int(found[SWEEPS]) * at.size * fold
            return Refined(
                fold, found[SAMPLES], near, found[MU], contact, under.jumps[0, 0], updates
            )
        fold *= finer(found[SAMPLES])
    return None


def finer(samples: float) -> int:
    """Return how many times finer samples must be for FINE of them per contact: 2, 4, 6, 8, 12 ...

    A power of two, or three quarters of one: a few of them make whole spans.
    """
    power = 2 ** max(1, math.ceil(math.log2(FINE / samples)))
    between = 3 * power // 4
    return between if power >= 8 and between * samples >= FINE else power
