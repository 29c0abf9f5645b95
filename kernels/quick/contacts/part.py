"""Steady sliding on lines, or on finer samples of a part of one: all in one call from Python."""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel
from ..steady.carry import decay_of
from ..steady.spans import SPAN, spans_of
from ..steady.stack import Stack, spans_in
from ..steady.thresholds import Thresholds, presses_at, thresholds_of
from .fine_line import gaps_of, interpolate, mark_missed
from .loads import INDENTATION, Found, Speeds, slide

NONE, NOT_ANY, NOWHERE = np.empty(0), np.empty(0, bool), np.empty(0, np.int64)


class Part(NamedTuple):
    """What elements slide on: all samples of some lines, or finer ones of intervals of one."""

    stack: Stack
    curvature: np.ndarray = NONE
    at: np.ndarray = NOWHERE  # intervals that are refined (fine_line.py); none: all as it is
    fold: int = 1  # fine samples in each
    low: np.ndarray = NOT_ANY  # which intervals are wanted, shape (n,)


@kernel
def slide_on(law, part, at_speeds, loads, guesses, how):
    """Return (largest thresholds of contact of the spans, the Decay, Found, intervals missed).

    law : for steps of one sample, or of a fine one. at_speeds : own and others, vbar; and what is
    left of displacements at those that follow. loads, guesses : as of slide, on these samples;
    guesses of each line. The thresholds are those of Thresholds, shape (lines, spans).
    Intervals that elements touch though they are no part are marked in part.low.
    """
    stack, curvature, at, fold, low = part
    speed, others, left = at_speeds
    refined = at.size > 0
    lines, n = stack.z.shape
    samples = at.size * fold if refined else n
    gaps, decay = gaps_of(law, at, fold, n), decay_of(law)
    found, stay = _room(lines, samples, loads, others, left), np.empty((lines, samples // SPAN))
    missed = 0
    for k in range(lines):
        z, slope, spans_of_z = stack.z[k], stack.slope[k], spans_in(stack, k)
        heights, slopes, spans = z, slope, spans_of_z
        if refined:
            heights, slopes = interpolate(z, slope, curvature, at, fold / how.steps, fold)
            spans = spans_of(heights, slopes)
        own = thresholds_of(heights, slopes, speed, law.stiffness)
        if refined:  # all of a part is never all of the line
            own = Thresholds(own.stay, own.press, np.inf, np.inf)
        speeds = Speeds(speed, own, others, presses_at(heights, slopes, others), left)
        into = _of_line(found, k)
        slide(decay, heights, slopes, spans, speeds, loads, guesses[k], how, gaps, into)
        for b in range(own.stay.size):
            stay[k, b] = own.stay[b]
        if refined:
            once, d = law.decay ** float(fold), into.table[0, INDENTATION]
            missed += mark_missed(
                z, slope, spans_of_z, fold / how.steps, once, d, at, gaps, fold, low
            )
    return stay, decay, found, missed


@kernel
def _room(lines, samples, loads, others, left):
    """Return Found of so many lines, empty."""
    shape = lines, loads.size, others.size
    return Found(
        np.empty((lines, loads.size, 6)),
        np.empty(shape),
        np.empty(shape),
        np.empty((lines, loads.size, samples // SPAN + 1)),
        np.empty((lines, loads.size, left.size)),
    )


@kernel
def _of_line(found, k):
    """Return what is found of line k: rows of all."""
    return Found(found.table[k], found.jumps[k], found.rates[k], found.entered[k], found.ahead[k])
