"""Measured lines as a study uses them: heights of one period each, all sampled alike."""

import hashlib
from typing import NamedTuple

import numpy as np


class Profile(NamedTuple):
    """Prepared lines of one measurement, in m; row i is the line of realization i."""

    heights: np.ndarray  # shape (lines, n), read only; one element per sample
    length: float  # m, of the period: n steps
    measured_length: float  # m, of a line as it was measured: half the period if mirrored
    notes: str  # where the lines come from and what was done to them
    digest: str  # of heights and length: what a stored result depends on

    @property
    def spacing(self) -> float:
        """Return the distance of samples, and of elements (m)."""
        return self.length / self.heights.shape[1]

    @property
    def roughness(self) -> float:
        """Return the rms height about the mean line of each, over all lines (m)."""
        return float(np.sqrt(np.mean(np.var(self.heights, axis=1))))


def make_profile(heights: np.ndarray, length: float, copies: int, notes: str) -> Profile:
    """Return the profile of prepared ``heights``, shape (lines, n), of a period ``length`` (m).

    copies : how often the measured length goes into the period; 2 for mirrored lines.
    """
    own = np.array(heights, dtype=float, order="C")
    own.setflags(write=False)
    told = hashlib.sha256(own.tobytes() + np.array([length, *own.shape]).tobytes())
    return Profile(own, length, length / copies, notes, told.hexdigest())
