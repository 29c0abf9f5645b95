"""Jackknife over blocks of realizations: one standard error for every derived quantity.

Blocks are independent and equal in size; replicate j leaves block j out of every point at
once, so correlations between points (shared lines) are carried into whatever is derived.
Source: B. Efron, The Jackknife, the Bootstrap and Other Resampling Plans (SIAM 1982), ch. 3.
"""

import numpy as np
from scipy.special import stdtrit

SIGNIFICANCE = 3.0  # standard errors a number must exceed
CHANCE = 0.01  # with few blocks: share of nothings that may pass by chance
ROUNDING = 1e-14  # a standard error below this share of its value is rounding, not a spread


def grouped_means(blocks: np.ndarray, groups: int) -> np.ndarray:
    """Return the means over every ``groups``-th block, shape (groups, ...).

    Block i goes into group i modulo ``groups``: blocks that two points with different numbers of
    blocks have in common, and so their random lines, stay in the same group. Where groups have
    unequal numbers of blocks, what their sum deviates counts in full: the mean over groups is that
    over blocks, and its jackknife error that of equal groups, within 1 % from one block each on.
    What is equal in all blocks stays as it is, to the bit.
    """
    count = len(blocks)
    if count % groups == 0:
        means = blocks.reshape(-1, groups, *blocks.shape[1:]).mean(axis=0)
    else:
        mean = blocks.mean(axis=0)
        missing = np.zeros((-count % groups, *blocks.shape[1:]))
        deviation = np.concatenate([blocks - mean, missing]).reshape(-1, groups, *blocks.shape[1:])
        means = mean + groups / count * deviation.sum(axis=0)
    return np.where((blocks == blocks[0]).all(axis=0), blocks[0], means)


def padded(values: np.ndarray, groups: int) -> np.ndarray:
    """Return replicates as if there were ``groups`` groups, shape (..., groups + 1).

    values : shape (..., own + 1), of fewer groups. Those that are missing change nothing, the
    others as much more as keeps the standard error: points with different numbers of groups can
    enter what is derived from all, and what they have in common counts.
    """
    own = values.shape[-1] - 1
    if not 0 < own < groups:
        return values
    left_out = values[..., 1:]
    centre = left_out.mean(axis=-1, keepdims=True)
    scale = np.sqrt((own - 1) / own / ((groups - 1) / groups))
    rest = np.repeat(centre, groups - own, axis=-1)
    return np.concatenate([values[..., :1], centre + scale * (left_out - centre), rest], axis=-1)


def replicates(blocks: np.ndarray, axis: int) -> np.ndarray:
    """Return the mean followed by the leave-one-block-out means along ``axis``.

    With g blocks the axis grows to g + 1: entry 0 is the full mean. One block alone has no others,
    and stays as it is: nothing is known of its scatter.
    """
    count = blocks.shape[axis]
    if count == 1:
        return blocks
    total = blocks.sum(axis=axis, keepdims=True)
    return np.concatenate([total / count, (total - blocks) / (count - 1)], axis=axis)


def standard_error(values: np.ndarray, axis: int) -> np.ndarray:
    """Return the jackknife standard error of an estimate from its replicates along ``axis``.

    Entry 0 along the axis is the estimate itself and does not enter. NaN where it is alone.
    """
    if values.shape[axis] == 1:
        return np.full_like(np.take(values, 0, axis=axis), np.nan, dtype=float)
    left_out = np.take(values, range(1, values.shape[axis]), axis=axis)
    count = left_out.shape[axis]
    deviation = left_out - left_out.mean(axis=axis, keepdims=True)
    return np.sqrt((count - 1) / count * np.sum(deviation**2, axis=axis))


def errors_needed(blocks: int, many: float = SIGNIFICANCE, chance: float = CHANCE) -> float:
    """Return how many standard errors of that many blocks a number must exceed to count.

    Over g blocks an estimate follows Student's t with g - 1 degrees of freedom: few blocks need
    more than the ``many`` of many blocks, six for four, or chance passes more often than
    ``chance`` (two-sided).
    """
    return max(many, float(stdtrit(blocks - 1, 1.0 - 0.5 * chance)))


def significant(values: np.ndarray) -> bool:
    """Return whether an estimate, replicates of shape (blocks + 1,), differs from zero.

    NaN in the estimate or in one replicate is not significant. Nor is an estimate whose replicates
    agree to rounding: random lines always differ, so the data do not enter it, as where a fit has
    run to the same end in every replicate. Of one block alone every number that is not zero counts.
    """
    if values.size == 1:
        return bool(np.isfinite(values[0]) and values[0] != 0.0)
    with np.errstate(over="ignore", invalid="ignore"):
        error = standard_error(values, 0)
        spread = error > ROUNDING * abs(values[0])
    return bool(spread and abs(values[0]) > errors_needed(values.size - 1) * error)
