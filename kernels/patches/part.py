"""Steady sliding on a line, or on finer samples of a part of it: all in one call from Python."""

from typing import NamedTuple

import numpy as np

from kernels.jit import kernel
from kernels.patches.fine_line import gaps_of, interpolate, mark_missed
from kernels.patches.loads import INDENTATION, Speeds, slide
from kernels.steady.carry import decay_of
from kernels.steady.spans import Spans, Thresholds, presses_at, spans_of, thresholds_of

NONE, NOT_ANY, NOWHERE = np.empty(0), np.empty(0, bool), np.empty(0, np.int64)


class Part(NamedTuple):
    """What of a line elements slide on: all samples, or finer ones of some intervals."""

    z: np.ndarray  # of the line, as the next two
    slope: np.ndarray
    spans: Spans
    curvature: np.ndarray = NONE
    at: np.ndarray = NOWHERE  # intervals that are refined (fine_line.py); none: all as it is
    fold: int = 1  # fine samples in each
    low: np.ndarray = NOT_ANY  # which intervals are wanted, shape (n,)


@kernel
def slide_on(law, part, at_speeds, loads, guesses, how):
    """Return (Thresholds at the own speed, the Decay, what slide returns, intervals missed).

    law : for steps of one sample, or of a fine one. at_speeds : own and others, vbar; and what is
    left of displacements at those that follow. loads, guesses : as of slide, on these samples.
    Intervals that elements touch though they are no part are marked in part.low.
    """
    z, slope, spans, curvature, at, fold, low = part
    speed, others, left = at_speeds
    gaps, refined = gaps_of(law, at, fold, z.size), at.size > 0
    heights, slopes, own_spans = z, slope, spans
    if refined:
        heights, slopes = interpolate(z, slope, curvature, at, fold / how.steps, fold)
        own_spans = spans_of(heights, slopes)
    own = thresholds_of(heights, slopes, speed, law.stiffness)
    if refined:  # all of a part is never all of the line
        own = Thresholds(own.stay, own.press, np.inf, np.inf)
    decay, press = decay_of(law), presses_at(heights, slopes, others)
    speeds = Speeds(speed, own, others, press, left)
    found = slide(decay, heights, slopes, own_spans, speeds, loads, guesses, how, gaps)
    missed = 0
    if refined:
        once, d = law.decay ** float(fold), found[0][0, INDENTATION]
        missed = mark_missed(z, slope, spans, fold / how.steps, once, d, at, gaps, fold, low)
    return own, decay, found, missed
