"""The march that anyone would write first: every element in every step, in numpy and in numba."""

import numpy as np
from numba import njit

SEARCH = 1e-13  # width in h at which the bisection for d ends


def numpy_march(z, weight, w, d, decay, target, steps):
    """March from (w, d); return mu, the mean over each step, shape (steps,).

    z, weight, w : shape (n,), in h. target : load over the stiffness of a step.
    """
    mu = np.empty(steps)
    for step in range(steps):
        w = decay * np.roll(np.minimum(w, z - d), -1)
        reach = w - z
        before = -1
        for turn in range(100):  # Newton, from the d before
            depth = reach + d
            touching = depth > 0.0
            count = np.count_nonzero(touching)
            if count == 0:
                d += target
                continue
            new = d - (depth[touching].sum() - target) / count
            if turn and (count == before or not new < d):
                break
            before, d = count, new
        d = new
        force = np.maximum(reach + d, 0.0)
        mu[step] = (force * weight).sum() / force.sum()
    return mu


@njit(cache=True)
def naive_march(z, weight, w, d, decay, target, steps):
    """March as ``numpy_march`` does, in plain loops, with a bisection for d."""
    n = z.size
    w = w.copy()
    mu = np.empty(steps)
    for step in range(steps):
        first = min(w[0], z[0] - d)
        for j in range(n - 1):
            w[j] = decay * min(w[j + 1], z[j + 1] - d)
        w[n - 1] = decay * first
        low, high = np.inf, 0.0
        for j in range(n):
            low = min(low, z[j] - w[j])
        high = low + target
        while high - low > SEARCH * max(1.0, abs(high)):
            d = 0.5 * (low + high)
            if d in (low, high):
                break
            total = 0.0
            for j in range(n):
                total += max(0.0, d - z[j] + w[j])
            if total > target:
                high = d
            else:
                low = d
        total = drag = 0.0
        for j in range(n):
            force = max(0.0, d - z[j] + w[j])
            total += force
            drag += force * weight[j]
        mu[step] = drag / total
    return mu
