"""Runs of samples of which it is open whether they touch, and stretches that always do: one walk.

The gap g_j(t) = c_j(t) - d(t) above the element at sample j is negative where it touches. With
a_j and D of setting.py

    g_j(t) = a_j - D(t) + E max(g_(j+1)(t - 1), 0),

so the bounds of D bound g from sample to sample against the motion; others are in marks.py.
"""

from typing import NamedTuple

import numpy as np

from kernels.active.marks import ALL_ALWAYS, ALWAYS, FREE, OPEN, WORD, levels_of, marks_of
from kernels.active.setting import rise
from kernels.jit import kernel

LISTED = 2  # at times it touches, at times it does not, for all that the bounds tell
FORCED = 4  # a mark: listed whatever the bounds tell
SHORT = 8  # samples: what is never touched but this near is cheaper to list than to fly over
UNKNOWN = 1e200  # a bound of gaps that says nothing


class Runs(NamedTuple):
    """Runs of listed samples, in the order of the walk: from the end of the line to z[0]."""

    top: np.ndarray  # the first sample of each, with the highest number
    bottom: np.ndarray  # the last one
    distance: np.ndarray  # from the top to the sample upstream from which elements come
    sure: np.ndarray  # whether that sample always touches


class Stretches(NamedTuple):
    """Stretches [start, stop) of samples that always touch, as their upstream neighbours do."""

    start: np.ndarray
    stop: np.ndarray


@kernel
def classes_of(setting, bounds):
    """Return (Runs, Stretches) of a line; every other sample never touches within the bounds."""
    levels = levels_of(setting, bounds)
    marks = marks_of(setting, bounds, levels)
    # All round the line samples may hold each other in contact: supposed first, then seen.
    runs, stretches, high = walk(setting, bounds, levels, marks)
    if marks[0] == ALWAYS and high > 0.0:
        marks[0] = FORCED
        runs, stretches, _ = walk(setting, bounds, levels, marks)
    return runs, stretches


@kernel
def walk(setting, bounds, levels, marks):
    """Return (Runs, Stretches, high), ``high`` the upper bound of max(g, 0) at z[0].

    Where z[0] is marked as ALWAYS it is taken to be in contact, which ``high`` then tells.
    """
    n = setting.z.size
    top, bottom, distance = (
        np.empty(n // 2 + 1, np.int64),
        np.empty(n // 2 + 1, np.int64),
        np.empty(n // 2 + 1, np.int64),
    )
    sure = np.empty(n // 2 + 1, np.bool_)
    start, stop = np.empty(n // 2 + 1, np.int64), np.empty(n // 2 + 1, np.int64)
    count = blocks = 0
    words = marks.view(np.int64)
    if marks[0] == OPEN:
        marks[0] = FORCED
    # Elements come to the end of the line from z[0], or from beyond it if it never touches.
    source, from_sure, kind = n, marks[0] == ALWAYS, FREE
    low, high = 0.0, (0.0 if from_sure else UNKNOWN)  # bounds of max(g, 0) one sample before
    j = n - 1
    while j >= 0:
        mark, last, was = marks[j], j, kind
        if mark == FREE or (mark == ALWAYS and high == 0.0):
            kind, last = mark, same_until(marks, words, j)
            low, high = 0.0, (UNKNOWN if mark == FREE else 0.0)
        else:
            held = high == 0.0
            least, most, low, high = gap(setting, bounds, levels, j, low, high)
            kind = class_of(mark, held and high == 0.0, least, most)
        if kind == ALWAYS:
            if was != ALWAYS:
                stop[blocks] = j + 1
                blocks += 1
            start[blocks - 1] = last
        elif kind == LISTED:
            near = was == FREE and source - j <= SHORT and source < n
            if was != LISTED and not (near and bottom[count - 1] == source and count > 0):
                top[count] = source - 1 if near and from_sure else j
                distance[count], sure[count] = source - top[count], from_sure
                count += 1
            bottom[count - 1] = last
        if kind != FREE:
            source, from_sure = last, high == 0.0
        j = last - 1
    if marks[0] == FREE and count > 0:
        distance[0], sure[0] = source + n - top[0], from_sure
    runs = Runs(top[:count], bottom[:count], distance[:count], sure[:count])
    return runs, Stretches(start[:blocks], stop[:blocks]), high


@kernel
def same_until(marks, words, j):
    """Return the last of the samples, from j down, that have the mark of j."""
    mark = marks[j]
    word = ALL_ALWAYS if mark == ALWAYS else 0
    while j > 0 and marks[j - 1] == mark:
        j -= 1
        if j % WORD == 0:
            while j > 0 and words[j // WORD - 1] == word:
                j -= WORD
    return j


@kernel
def gap(setting, bounds, levels, j, low, high):
    """Return (least, most, low, high): bounds of g_j and of max(g_j, 0), now and in all steps.

    low, high : bounds of max(g, 0) at the sample upstream.
    """
    z, (w, d), law = setting.z, setting.start, setting.law
    a = rise(law, z[j], z[j + 1 if j + 1 < z.size else 0])
    least = max(
        a - bounds.most + law.decay * low, z[j] - levels.near[j] - levels.near_slack - bounds.high
    )
    most = min(
        a - bounds.least + law.decay * high, z[j] - levels.far[j] + levels.far_slack - bounds.low
    )
    now = z[j] - w[j] - d
    least, most = min(least, now), max(most, now)
    return least, most, max(least, 0.0), max(most, 0.0)


@kernel
def class_of(mark, held, least, most):
    """Return what becomes of a sample; ``held`` : whether it and the one upstream always touch."""
    if mark == FORCED:
        return LISTED
    if held and most < 0.0:
        return ALWAYS
    return FREE if least >= 0.0 else LISTED
