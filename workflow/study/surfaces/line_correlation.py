"""Correlation of neighbouring lines, such as the rows of a map.

Rows whose distance is shorter than the waves of the surface are correlated. The standard error of
their mean then exceeds that of independent rows. Blocks wider than the correlation length are
nearly independent (M. Kendall's effective number; batch means).
"""

import math
from typing import NamedTuple

import numpy as np

MIN_CORRELATION = 0.2  # of neighbours; below it lines count as independent
CHANCE_DEVIATIONS = 5.0  # threshold of coherence, in standard deviations of independent lines
NEGLIGIBLE_CORRELATION = 0.05  # the sum over lags ends here
BLOCK_LENGTHS = 1.4  # size of a block, in correlation lengths: yields 90 % of the standard error
USUAL_MIN_BLOCKS = 4
MAX_BLOCK_GROWTH = 1.25  # factor on the block size, to leave out fewer lines


class LineCorrelation(NamedTuple):
    """Correlation of neighbouring lines and the correlation length."""

    correlation: float  # of the heights of neighbours
    lines: float  # number of lines that count as one: 1 + 2 sum of the correlations

    @property
    def block(self) -> int:
        """Return the smallest number of lines in a block."""
        return math.ceil(BLOCK_LENGTHS * self.lines)

    def whole_blocks(self, lines: int, every: bool) -> tuple[int, int]:
        """Return the number of lines to use, and the number of lines in a block.

        There are at least two blocks, and at least four from eight lines on.

        every : whether to use all lines; otherwise the lines of an incomplete block are left out.
        """
        longest = max(lines // USUAL_MIN_BLOCKS if lines >= 2 * USUAL_MIN_BLOCKS else lines // 2, 1)
        shortest = min(self.block, longest)
        if every:
            divisors = [size for size in range(1, longest + 1) if lines % size == 0]
            return lines, min((size for size in divisors if size >= shortest), default=divisors[-1])
        sizes = range(shortest, min(int(MAX_BLOCK_GROWTH * shortest), longest) + 1)
        block = max(sizes, key=lambda size: (lines // size * size, -size))
        return lines // block * block, block


def line_correlation(heights: np.ndarray) -> LineCorrelation | None:
    """Return the correlation of neighbouring lines, or None if they are independent.

    heights : shape (lines, n), levelled. The test for independence weights the first quarter of the
    modes equally, since independent lines may agree by chance in the few longest waves.
    """
    lines, samples = heights.shape
    if lines < 2:
        return None
    modes = np.fft.rfft(heights, axis=1)[:, 1 : max(samples // 8, 3)]
    power = np.mean(np.abs(modes) ** 2, axis=0)
    cross_power = np.mean((modes[1:] * modes[:-1].conj()).real, axis=0)
    known = power > 0.0
    coherence = float(np.mean(cross_power[known] / power[known])) if known.any() else 0.0
    if coherence < max(
        MIN_CORRELATION, CHANCE_DEVIATIONS / math.sqrt(2.0 * known.sum() * (lines - 1))
    ):
        return None
    total, first = 1.0, _correlation(heights, 1)
    for lag in range(1, lines // 2 + 1):
        correlation = _correlation(heights, lag)
        if correlation < NEGLIGIBLE_CORRELATION:
            break
        total += 2.0 * correlation
    return LineCorrelation(first, total)


def _correlation(heights: np.ndarray, lag: int) -> float:
    """Return the correlation of the heights of lines that are ``lag`` lines apart."""
    first, second = heights[:-lag], heights[lag:]
    return float(np.sum(first * second) / math.sqrt(np.sum(first**2) * np.sum(second**2)))
