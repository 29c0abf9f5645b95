"""Healing of the contact: the static peak of friction after a hold."""

from itertools import pairwise
from typing import NamedTuple

import numpy as np

from ...kernels import Hold, Programme, Slide
from .extremum import extremum


class Healing(NamedTuple):
    """Friction around the last hold, for the mean trace and its replicates, shape (replicates,)."""

    static_peak: np.ndarray  # mu at the peak after the hold
    healing: np.ndarray  # static peak minus mu before the hold
    mu_end_of_hold: np.ndarray
    peak_distance: np.ndarray  # slid since the end of the hold, in dx


def last_hold(programme: Programme) -> tuple[int, float] | None:
    """Return the index of the last hold before a slide, and the speed of the slide, or None."""
    holds = [
        (k, after.speed)
        for k, (before, after) in enumerate(pairwise(programme))
        if isinstance(before, Hold) and isinstance(after, Slide)
    ]
    return holds[-1] if holds else None


def healing(
    programme: Programme, legs: np.ndarray, distance: np.ndarray, mu: np.ndarray
) -> Healing:
    """Return the friction around the last hold of a programme, NaN without a hold.

    legs : of the samples, shape (1, samples). distance (dx), mu : shape (replicates, samples),
    the mean trace first.
    """
    hold = last_hold(programme)
    nothing = np.full(len(mu), np.nan)
    if hold is None:
        return Healing(nothing, nothing, nothing, nothing)
    k, speed = hold
    held, slid = legs[0] == k, legs[0] == k + 1
    before = np.flatnonzero(legs[0] < k)  # the last one ends the leg before the hold
    if not (held.any() and slid.any() and before.size):
        return Healing(nothing, nothing, nothing, nothing)
    end = np.flatnonzero(held)[-1]
    slipped = np.abs(distance[0, slid] - distance[0, end])
    peak, where = extremum(slipped, mu[:, slid], float(np.sign(speed)))
    return Healing(peak, peak - mu[:, before[-1]], mu[:, end], where)
