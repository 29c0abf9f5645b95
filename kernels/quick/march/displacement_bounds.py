"""Contact kinds of single samples and whole spans, from two steady states and the bounds of d.

The displacements of the two steady states bound those on the way from one to the other: a free u
decays by the factor E of v1 before the jump, of v2 after it; in contact u = z - d.
"""

from typing import NamedTuple

from ...compile.jit import kernel, refcount_free_kernel
from ...rheology.law import MIN_MAGNITUDE
from ..steady.spans import SPAN
from .jump_problem import SteadyState, line_rise

# Contact kinds. ALWAYS_TOUCHES requires that the sample upstream always touches.
# FORCED_UNDECIDED, only for the first sample of the line: UNDECIDED whatever the bounds.
NEVER_TOUCHES, UNDECIDED, ALWAYS_TOUCHES, FORCED_UNDECIDED = 0, 2, 3, 4


class DisplacementBounds(NamedTuple):
    """Bounds of free displacements: far - far_slack <= w <= near + near_slack."""

    near: SteadyState  # the state in which displacements decay faster
    near_is_start: bool  # whether ``near`` is the state at v1
    near_slack: float
    far_slack: float


@kernel
def displacement_bounds(problem, bounds):
    """Return the DisplacementBounds; slacks are E (near.d - d_min)+ and E (d_max - far.d)+."""
    near, far, near_is_start = problem.start, problem.end, True
    if problem.before.decay > problem.law.decay:
        near, far, near_is_start = far, near, False
    decay = problem.law.decay
    near_slack = decay * max(near.d - bounds.d_min, 0.0)
    far_slack = decay * max(bounds.d_max - far.d, 0.0)
    return DisplacementBounds(near, near_is_start, near_slack, far_slack)


@refcount_free_kernel
def decayed_displacement(decay, u):
    """Return the displacement of a free element one sample after it was u."""
    return decay.sample * u if u < -MIN_MAGNITUDE else 0.0


@refcount_free_kernel
def span_never_touches(problem, bounds, levels, b):
    """Return whether the lowest sample of a whole span lies too high to touch.

    levels : DisplacementBounds.
    """
    near = levels.near
    w = near.decay.span * near.entered[b]  # upper bound of displacements in the span
    return problem.spans.lowest[b] - w >= bounds.d_max + levels.near_slack


@refcount_free_kernel
def span_always_touches(problem, bounds, b):
    """Return whether a whole span always touches if the sample upstream of it does."""
    largest_rise = problem.end.thresholds[b] / problem.law.stiffness
    return problem.start.d > problem.start.thresholds[b] and largest_rise < bounds.advance_min


@refcount_free_kernel
def kind_of_first(problem, bounds, levels):
    """Return the contact kind of z[0], where a walk over the line ends."""
    z, (start, end) = problem.z, (problem.start, problem.end)
    u_start, u_end, w_start, w_end = start.entered[0], end.entered[0], 0.0, 0.0
    for j in range(min(SPAN, z.size) - 1, -1, -1):
        w_start = decayed_displacement(start.decay, u_start)
        w_end = decayed_displacement(end.decay, u_end)
        u_start, u_end = min(w_start, z[j] - start.d), min(w_end, z[j] - end.d)
    if z[0] - (w_start if levels.near_is_start else w_end) >= bounds.d_max + levels.near_slack:
        return NEVER_TOUCHES
    rise = line_rise(problem.law, z[0], z[1])
    touches = z[0] - w_start < start.d and rise < bounds.advance_min
    return ALWAYS_TOUCHES if touches else FORCED_UNDECIDED
