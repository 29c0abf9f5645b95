"""Heights and slopes of a moving line over the resting elements of a foundation, step by step.

At whole samples the line is read with an offset. At fractions of a sample it is shifted by Fourier
(fourier.py), once for all steps of a stage with the same fraction. Stages limit the memory.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from .fourier import FourierShift
from .legs import Steps

MAX_SHIFTED_SAMPLES = 1 << 21  # samples of shifted lines in a stage, at most; two always fit
MAX_SHIFTED_LINES = 512  # shifted lines in a stage, at most
MAX_STAGE_STEPS = 1 << 18  # steps of a stage, at most


class Track(NamedTuple):
    """The line before the first step of a stage and after each of its steps."""

    z: np.ndarray  # shape (lines, 2 n): two periods of every line, heights in h
    slope: np.ndarray  # slopes in the same form, in h/dx
    line: np.ndarray  # index of the shifted line, shape (S + 1,)
    begin: np.ndarray  # sample of that line at element 0, shape (S + 1,)
    dt: np.ndarray  # durations of the steps, in tau, shape (S,)
    place: np.ndarray  # displacement of the line, in dx, shape (S + 1,)
    time: np.ndarray  # in tau, shape (S + 1,)


def tracks(
    z: np.ndarray, slope: np.ndarray, m: int, steps: Steps, start: float, time: float
) -> Iterator[Track]:
    """Yield one Track for each of the consecutive stages of the steps.

    z, slope : line, shape (n,), in h and h/dx. m : samples per spacing. start, time : position and
    time before the first step, in samples and in tau.
    """
    n, shifted = z.size, None
    for piece in range(0, max(steps.dt.size, 1), MAX_STAGE_STEPS):
        some = slice(piece, piece + MAX_STAGE_STEPS)
        place = np.append(start, steps.position[some])
        times = np.cumsum(np.append(time, steps.dt[some]))
        start, time = float(place[-1]), float(times[-1])
        whole = np.floor(place)
        fraction = place - whole
        begin = (-whole % n).astype(np.int64)
        if shifted is None and fraction.any():
            shifted = FourierShift(z, slope, m)
        most = max(2, min(MAX_SHIFTED_LINES, MAX_SHIFTED_SAMPLES // n))
        for first, last in _stages(fraction, most):
            parts, line = np.unique(np.append(0.0, fraction[first : last + 1]), return_inverse=True)
            both = [(z, slope)]
            both += [shifted.by(part) for part in parts[1:]] if shifted else []
            heights, slopes = (np.tile(np.stack(values), 2) for values in zip(*both, strict=True))
            ends = slice(first, last + 1)
            dt, moved = steps.dt[some][first:last], place[ends] / m
            yield Track(heights, slopes, line[1:], begin[ends], dt, moved, times[ends])


def _stages(fraction: np.ndarray, most: int) -> list[tuple[int, int]]:
    """Return (first, last) position of stages with at most ``most`` different fractions."""
    stages = []
    first, seen_fractions = 0, {float(fraction[0])}
    for at in np.flatnonzero(np.diff(fraction)) + 1:
        if len(seen_fractions | {float(fraction[at])}) > most:
            stages.append((first, int(at) - 1))
            first, seen_fractions = int(at) - 1, {float(fraction[at - 1])}
        seen_fractions.add(float(fraction[at]))
    return [*stages, (first, fraction.size - 1)]
