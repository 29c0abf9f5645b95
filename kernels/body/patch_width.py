"""Resolution of contacts: the number of samples per contact patch."""

import numpy as np

from ..compile.jit import kernel, refcount_free_kernel


@kernel
def samples_per_contact(force):
    """Return the load-weighted median width of contact patches, in samples.

    force : of every sample, positive in contact, shape (n,), periodic, in any unit. A patch is a
    run of touching samples. Patches up to the median width carry at least half of the load. The
    result is n in full contact, and 0 without contact.
    """
    return median_patch_width(force, np.zeros(force.size))


@refcount_free_kernel
def median_patch_width(force, load_of_width):
    """Return the result of samples_per_contact without allocating an array.

    load_of_width : workspace, shape (n,) or more; zero before and after the call.
    """
    n, total, load = force.size, 0.0, 0.0
    first_run = run = widest = 0
    for f in force:
        if not f > 0.0:
            break
        first_run += 1
    if first_run == n:
        return float(n)
    for f in force[first_run:]:
        if f > 0.0:
            run += 1
            load += f
        elif run > 0:
            load_of_width[run] += load
            total, widest, run, load = total + load, max(widest, run), 0, 0.0
    for f in force[:first_run]:  # continue across the end of the period
        run += 1
        load += f
    load_of_width[run] += load
    total, widest, below, median = total + load, max(widest, run), 0.0, 0
    for width in range(1, widest + 1):
        below += load_of_width[width]
        load_of_width[width] = 0.0
        if median == 0 and below >= 0.5 * total:
            median = width
    return float(median)
