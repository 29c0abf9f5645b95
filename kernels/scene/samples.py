"""How well contacts are resolved: the number of samples per contact patch."""

import numpy as np

from ..compile.jit import kernel, refcount_free_kernel


@kernel
def samples_per_contact(force):
    """Return the median over the load of how many samples a patch of contact is wide.

    force : of every sample, positive where it touches, shape (n,), periodic; its unit is free.
    A patch is a run of touching samples; patches up to this width carry half of the load. n in
    full contact, 0 where nothing touches.
    """
    return median_over_load(force, np.zeros(force.size))


@refcount_free_kernel
def median_over_load(force, carried):
    """Return the samples per contact, as samples_per_contact does, without an array made.

    carried : room, shape (n,) or more, all zero before and after.
    """
    n, total, load = force.size, 0.0, 0.0
    begun = run = widest = 0
    for f in force:
        if not f > 0.0:
            break
        begun += 1
    if begun == n:
        return float(n)
    for f in force[begun:]:
        if f > 0.0:
            run += 1
            load += f
        elif run > 0:
            carried[run] += load
            total, widest, run, load = total + load, max(widest, run), 0, 0.0
    for f in force[:begun]:  # round the period
        run += 1
        load += f
    carried[run] += load
    total, widest, below, median = total + load, max(widest, run), 0.0, 0
    for width in range(1, widest + 1):
        below += carried[width]
        carried[width] = 0.0
        if median == 0 and below >= 0.5 * total:
            median = width
    return float(median)
