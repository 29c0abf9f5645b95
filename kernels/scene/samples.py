"""How well contacts are resolved: the number of samples per contact patch."""

import numpy as np

from ..compile.jit import kernel


@kernel
def samples_per_contact(force):
    """Return the median over the load of how many samples a patch of contact is wide.

    force : of every sample, positive where it touches, shape (n,), periodic; its unit is free.
    A patch is a run of touching samples; patches up to this width carry half of the load. n in
    full contact, 0 where nothing touches.
    """
    n = force.size
    start = 0
    while start < n and force[start] > 0.0:
        start += 1
    if start == n:
        return float(n)
    width, carried = np.empty(n // 2 + 1, np.int64), np.empty(n // 2 + 1)
    patches = run = 0
    load = 0.0
    for k in range(1, n + 1):
        i = start + k
        f = force[i if i < n else i - n]  # the last one is free again
        if f > 0.0:
            run += 1
            load += f
        elif run > 0:
            width[patches], carried[patches] = run, load
            patches, run, load = patches + 1, 0, 0.0
    by_width = np.zeros(width[:patches].max() + 1 if patches > 0 else 1)
    total = below = 0.0
    for patch in range(patches):
        by_width[width[patch]] += carried[patch]
        total += carried[patch]
    for wide in range(1, by_width.size):
        below += by_width[wide]
        if below >= 0.5 * total:
            return float(wide)
    return 0.0
