"""Static friction after a hold: the peak on sliding again, and the friction that the hold left."""

from itertools import pairwise
from typing import NamedTuple

import numpy as np

from ....kernels import Hold, Programme, Slide
from .peak import extremum


class Healing(NamedTuple):
    """Of the mean trace, then of its jackknife replicates; each of shape (replicates,)."""

    static_peak: np.ndarray  # mu
    healing: np.ndarray  # mu: the static peak over the friction before the hold
    mu_end_of_hold: np.ndarray
    peak_distance: np.ndarray  # slid since the end of the hold, in dx


def last_hold(programme: Programme) -> tuple[int, float] | None:
    """Return the number of the last hold that is followed by a slide, and the speed of that."""
    found = [
        (k, after.speed)
        for k, (before, after) in enumerate(pairwise(programme))
        if isinstance(before, Hold) and isinstance(after, Slide)
    ]
    return found[-1] if found else None


def healing(programme: Programme, stamps: dict[str, np.ndarray], mu: np.ndarray) -> Healing:
    """Return what the last hold of a programme did; NaN where there is none.

    stamps : of the kept samples (kernels/scene.py), each of shape (samples,), distance in dx.
    mu : shape (replicates, samples), the mean trace first.
    """
    found = last_hold(programme)
    nothing = np.full(len(mu), np.nan)
    if found is None:
        return Healing(nothing, nothing, nothing, nothing)
    k, speed = found
    held, slid = stamps["leg"] == k, stamps["leg"] == k + 1
    before = np.flatnonzero(stamps["leg"] < k)  # the last of them ends the slide before the hold
    if not (held.any() and slid.any() and before.size):
        return Healing(nothing, nothing, nothing, nothing)
    end = np.flatnonzero(held)[-1]
    distance = np.abs(stamps["distance"][slid] - stamps["distance"][end])
    peak, where = extremum(distance, mu[:, slid], float(np.sign(speed)))
    return Healing(peak, peak - mu[:, before[-1]], mu[:, end], where)
