"""Where steady sliding at another speed will be found, from the contacts at one speed.

Were the same samples to touch at both speeds, all displacements would be known: z - d in contact,
and behind a sample in contact what decays from there. Their sum is linear in d. At the edges of a
contact displacements are continuous, so that samples which come to touch or cease to touch change
the sum in second order only.
"""

import math

from ...compile.jit import borrowing
from .contacts import SUM


@borrowing
def indentation_ahead(once, z, d, load, touching, contacts):
    """Return about the indentation of steady sliding under the same load at another speed.

    once : what is left of a displacement after one sample, at that speed. d, load (n Fbar),
    touching (samples), contacts : of steady sliding at the speed that is known.
    """
    pieces = contacts.ends.shape[0]
    rate = -math.log(once) if once > 0.0 else 0.0
    endless = once / (1.0 - once)  # the sum of once^k over k = 1, 2, ...
    force, slope = 0.0, touching
    for i in range(pieces):
        after = i + 1 if i + 1 < pieces else 0
        force += contacts.edges[i, SUM]
        if contacts.ends[after, 2] == 0:
            bottom = contacts.ends[i, 1]
            gap = bottom - contacts.ends[after, 0] - 1
            if gap < 0:
                gap += z.size
            share = endless * (1.0 - math.exp(-rate * gap))
            force += share * (d - z[bottom])
            slope += share
    return d + (load - force) / slope
