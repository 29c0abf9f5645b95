"""Jackknife over blocks of realizations: standard errors of derived quantities.

Blocks are independent and of equal size. Replicate j leaves out block j of all points at once, so
that errors of derived quantities include the correlations between points (shared lines).
A measured record is a single realization without blocks. Its errors are therefore estimated from
the correlation of the residuals (workflow/laboratory/estimate.py).
Source: B. Efron, The Jackknife, the Bootstrap and Other Resampling Plans (SIAM 1982), ch. 3.
"""

import numpy as np
from scipy.special import stdtrit

SIGNIFICANT_ERRORS = 3.0  # a significant value exceeds this many standard errors
FALSE_POSITIVES = 0.01  # allowed rate with few blocks, two-sided
ERROR_ROUNDING = 1e-14  # relative standard error below which replicates are equal


def grouped_means(blocks: np.ndarray, groups: int) -> np.ndarray:
    """Return the means over every ``groups``-th block, shape (groups, ...).

    Block i belongs to group i modulo ``groups``. Points with different numbers of blocks thus have
    their shared blocks, on the same lines, in the same groups. For groups of unequal size the
    deviations are scaled such that the mean over groups equals the mean over blocks, and the
    jackknife error equals that of equal groups within 1 %. Values equal in all blocks stay exactly
    equal.
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
    """Return replicates padded to ``groups`` groups, shape (..., groups + 1).

    values : shape (..., count + 1), with count < groups. Added replicates equal the mean, and the
    deviations of the others are scaled to keep the standard error. Points with different numbers of
    groups can then be combined, including their correlations.
    """
    count = values.shape[-1] - 1
    if not 0 < count < groups:
        return values
    left_out = values[..., 1:]
    centre = left_out.mean(axis=-1, keepdims=True)
    scale = np.sqrt((count - 1) / count / ((groups - 1) / groups))
    rest = np.repeat(centre, groups - count, axis=-1)
    return np.concatenate([values[..., :1], centre + scale * (left_out - centre), rest], axis=-1)


def replicates(blocks: np.ndarray, axis: int) -> np.ndarray:
    """Return the mean followed by the leave-one-block-out means along ``axis``.

    With g blocks the axis grows to g + 1: entry 0 is the full mean. A single block is returned
    unchanged, as its scatter is unknown.
    """
    count = blocks.shape[axis]
    if count == 1:
        return blocks
    total = blocks.sum(axis=axis, keepdims=True)
    return np.concatenate([total / count, (total - blocks) / (count - 1)], axis=axis)


def standard_error(values: np.ndarray, axis: int) -> np.ndarray:
    """Return the jackknife standard error of an estimate from its replicates along ``axis``.

    Entry 0 along the axis is the estimate itself and is not used. NaN without replicates.
    """
    if values.shape[axis] == 1:
        return np.full_like(np.take(values, 0, axis=axis), np.nan, dtype=float)
    left_out = np.take(values, range(1, values.shape[axis]), axis=axis)
    count = left_out.shape[axis]
    deviation = left_out - left_out.mean(axis=axis, keepdims=True)
    return np.sqrt((count - 1) / count * np.sum(deviation**2, axis=axis))


def errors_needed(
    blocks: int, many: float = SIGNIFICANT_ERRORS, chance: float = FALSE_POSITIVES
) -> float:
    """Return the number of standard errors that a significant number must exceed.

    With g blocks an estimate follows Student's t with g - 1 degrees of freedom. To keep the rate of
    false positives at ``chance`` (two-sided), few blocks need more standard errors than ``many``,
    the number for many blocks: for example six for four blocks.
    """
    return max(many, float(stdtrit(blocks - 1, 1.0 - 0.5 * chance)))


def significant(values: np.ndarray) -> bool:
    """Return whether an estimate differs from zero; values : replicates of shape (blocks + 1,).

    An estimate with NaN in any replicate is not significant. Neither is one whose replicates agree
    to rounding: it does not depend on the data, for example a fit that ends at a bound. For one
    block every nonzero number is significant.
    """
    if values.size == 1:
        return bool(np.isfinite(values[0]) and values[0] != 0.0)
    with np.errstate(over="ignore", invalid="ignore"):
        error = standard_error(values, 0)
        spread = error > ERROR_ROUNDING * abs(values[0])
    return bool(spread and abs(values[0]) > errors_needed(values.size - 1) * error)
