"""How much neighbouring lines are alike, as rows of a map are: how many make one independent line.

Rows that lie closer than the waves of the surface are no independent lines, and the scatter of
their mean is not that of a row over the root of their number. Blocks of rows longer than the
correlation are nearly independent (M. Kendall's effective number; batch means).
"""

import math
from typing import NamedTuple

import numpy as np

LEAST = 0.2  # correlation of neighbours below which lines count as independent
CHANCE = 5.0  # standard deviations of the correlation of independent lines
GONE = 0.05  # correlation from which on lines have nothing more in common
LONG = 1.4  # blocks, in lengths of the correlation: they hold nine tenths of a standard error
FEWEST = 4  # blocks
SPARE = 1.25  # blocks may be so much longer to leave out fewer lines


class LineCorrelation(NamedTuple):
    """What neighbouring lines have in common."""

    correlation: float  # of the heights of neighbours
    lines: float  # that are worth one independent line: 1 + 2 sum of the correlations

    @property
    def block(self) -> int:
        """Return how many lines a block must hold."""
        return math.ceil(LONG * self.lines)

    def whole_blocks(self, lines: int, every: bool) -> tuple[int, int]:
        """Return how many of some lines are taken, and how many make a block.

        There are two blocks at least, and four where lines are so many.

        every : whether all of them must be; else a few are left out that fill no block.
        """
        longest = max(lines // FEWEST if lines >= 2 * FEWEST else lines // 2, 1)
        least = min(self.block, longest)
        if every:
            whole = [size for size in range(1, longest + 1) if lines % size == 0]
            return lines, min((size for size in whole if size >= least), default=whole[-1])
        sizes = range(least, min(int(SPARE * least), longest) + 1)
        block = max(sizes, key=lambda size: (lines // size * size, -size))
        return lines // block * block, block


def line_correlation(heights: np.ndarray) -> LineCorrelation | None:
    """Return what neighbouring lines have in common, None where they are independent.

    heights : shape (lines, n), levelled. Whether they are alike is judged by the first quarter of
    the modes, each counted alike: long waves are so few that independent lines may agree in them.
    """
    lines, samples = heights.shape
    if lines < 2:
        return None
    modes = np.fft.rfft(heights, axis=1)[:, 1 : max(samples // 8, 3)]
    power = np.mean(np.abs(modes) ** 2, axis=0)
    both = np.mean((modes[1:] * modes[:-1].conj()).real, axis=0)
    known = power > 0.0
    coherence = float(np.mean(both[known] / power[known])) if known.any() else 0.0
    if coherence < max(LEAST, CHANCE / math.sqrt(2.0 * known.sum() * (lines - 1))):
        return None
    total, first = 1.0, _correlation(heights, 1)
    for lag in range(1, lines // 2 + 1):
        correlation = _correlation(heights, lag)
        if correlation < GONE:
            break
        total += 2.0 * correlation
    return LineCorrelation(first, total)


def _correlation(heights: np.ndarray, lag: int) -> float:
    """Return the correlation of the heights of lines so many lines apart."""
    one, other = heights[:-lag], heights[lag:]
    return float(np.sum(one * other) / math.sqrt(np.sum(one**2) * np.sum(other**2)))
