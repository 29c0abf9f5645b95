"""A line under a body: its heights and slopes over the elements, which are at rest.

The functions declared here dispatch on the type of the ground: a Track at the steps of a programme
(motion/track.py), or a ShiftableLine at any place (shiftable_line.py).
"""

import numpy as np

from ..compile.jit import dispatch_inlined, dispatch_on_type, kernel
from ..motion.track import Track

CELL_SAMPLES = 16  # per stored minimum of the line


@dispatch_on_type
def lowest_heights(ground):
    """Return lower bounds of the heights, in h, in cells of CELL_SAMPLES samples of two periods."""


@kernel
def cell_minima(ground):
    """Return ``lowest_heights`` of a ground, for calls from Python too."""
    return lowest_heights(ground)


@dispatch_inlined
def first_sample(ground, place):
    """Return the number of the sample over element 0 where the line is at a place."""


@dispatch_inlined
def fill_heights(ground, place, first, z):
    """Fill z with the heights over consecutive elements, from element ``first`` on, in h."""


@dispatch_inlined
def fill_thresholds(ground, place, first, n, w, c):
    """Fill c with the heights minus w over elements from ``first`` on, up to the last of n."""


@dispatch_inlined
def fill_slopes(ground, step, lag, first, n, slope):
    """Fill slope with the slopes over elements from ``first`` on, up to the last of n, in h/dx.

    They are interpolated to where the force acts, a share ``lag`` of the step before its end.
    """


@lowest_heights.register(Track)
def _lowest(ground):
    lowest = np.full((ground.z.shape[1] + CELL_SAMPLES - 1) // CELL_SAMPLES, np.inf)
    for line in range(ground.z.shape[0]):
        for j in range(ground.z.shape[1]):
            lowest[j // CELL_SAMPLES] = min(lowest[j // CELL_SAMPLES], ground.z[line, j])
    return lowest


@first_sample.register(Track)
def _first_sample(ground, place):
    return ground.begin[place]


@fill_heights.register(Track)
def _fill_heights(ground, place, first, z):
    line, begin = ground.line[place], ground.begin[place] + first
    for i in range(z.size):
        z[i] = ground.z[line, begin + i]


@fill_thresholds.register(Track)
def _fill_thresholds(ground, place, first, n, w, c):
    z = ground.z[ground.line[place], ground.begin[place] + first :]
    for i in range(min(c.size, n - first)):
        c[i] = z[i] - w[i]


@fill_slopes.register(Track)
def _fill_slopes(ground, step, lag, first, n, slope):
    after = ground.slope[ground.line[step.after], ground.begin[step.after] + first :]
    before = ground.slope[ground.line[step.before], ground.begin[step.before] + first :]
    for i in range(min(slope.size, n - first)):
        slope[i] = after[i] + lag * (before[i] - after[i])
