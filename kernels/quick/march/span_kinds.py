"""What a sample or a span of them is, for all that two steady states and the bounds tell of it.

Displacements are bounded by those of the two steady states: where no force acts they decay with
E at one of the speeds or the other, and in contact they are z - d.
"""

from typing import NamedTuple

from ...compile.jit import kernel, refcount_free_kernel
from ...rheology.law import MIN_MAGNITUDE
from ..steady.spans import SPAN
from .given import SteadyState, a_of

FREE, OPEN, ALWAYS = 0, 1, 3  # never touches; may touch; always does if the one upstream does
FORCED = 4  # a kind: listed whatever the bounds tell


class Levels(NamedTuple):
    """Bounds of displacements by steady states: far - far_slack <= w <= near + near_slack."""

    near: SteadyState  # the state in which elements forget faster
    early: bool  # whether it is that at v1
    near_slack: float
    far_slack: float


@kernel
def levels_of(march, bounds):
    """Return the Levels: a displacement changes by no more than d does, less a step's decay."""
    near, far, early = march.start, march.end, True
    if march.before.decay > march.law.decay:
        near, far, early = far, near, False
    decay = march.law.decay
    near_slack = decay * max(near.d - bounds.low, 0.0)
    return Levels(near, early, near_slack, decay * max(bounds.high - far.d, 0.0))


@refcount_free_kernel
def reached(decay, u):
    """Return the displacement of an element one sample after u, if no force acts on it."""
    return decay.once * u if u < -MIN_MAGNITUDE else 0.0


@refcount_free_kernel
def never(march, bounds, levels, b):
    """Return whether the lowest sample of a whole span lies too high for any of it to touch."""
    near = levels.near
    w = near.decay.span * near.entered[b]  # nowhere in the span do elements lie higher
    return march.spans.lowest[b] - w >= bounds.high + levels.near_slack


@refcount_free_kernel
def always(march, bounds, b):
    """Return whether a whole span always touches, as the sample upstream of it does."""
    steep = march.end.stay[b] / march.law.stiffness  # the largest a_j
    return march.start.d > march.start.stay[b] and steep < bounds.least


@refcount_free_kernel
def kind_of_first(march, bounds, levels):
    """Return the kind of the first sample of the line, at which a walk ends."""
    z, (start, end) = march.z, (march.start, march.end)
    u, v, w, after = start.entered[0], end.entered[0], 0.0, 0.0
    for j in range(min(SPAN, z.size) - 1, -1, -1):
        w, after = reached(start.decay, u), reached(end.decay, v)
        u, v = min(w, z[j] - start.d), min(after, z[j] - end.d)
    if z[0] - (w if levels.early else after) >= bounds.high + levels.near_slack:
        return FREE
    steep = a_of(march.law, z[0], z[1])
    return ALWAYS if z[0] - w < start.d and steep < bounds.least else FORCED
