"""Recorders of a march: traces, contact lengths, snapshots; compiled only if requested.

A recorder is a NamedTuple of arrays that a march fills, or None.
"""

from typing import NamedTuple

import numpy as np

from ..compile.jit import inlined_kernel, kernel
from ..model.friction import weighted_sums
from .samples import samples_per_contact


class Trace(NamedTuple):
    """Values at the recorded steps, all of shape (recorded,).

    The force of a step acts before the end of the step, by its lag. Indentation, time and distance
    are interpolated to that instant. mu is NaN if nothing touches.
    """

    mu: np.ndarray  # in h/dx
    indentation: np.ndarray  # in h over the deepest point
    normal_force: np.ndarray  # in 4 G L h
    friction_force: np.ndarray  # in 4 G L h^2/dx
    contact_fraction: np.ndarray
    samples_per_contact: np.ndarray  # see samples.py
    time: np.ndarray  # in tau
    distance: np.ndarray  # of the line, in dx
    velocity: np.ndarray  # of the line, in dx/tau


TRACES = tuple(f"trace_{name}" for name in Trace._fields)
MOTION_TRACES = TRACES[-3:]  # equal for all lines with the same motion


class ContactLengths(NamedTuple):
    """Histogram of contact lengths over the recorded steps."""

    edges: np.ndarray  # of the bins, in samples, shape (bins + 1,), increasing
    counts: np.ndarray  # shape (bins,); a length on an edge counts in the bin above it


class Snapshots(NamedTuple):
    """Heights of the line and displacements, both at the elements, at the end of some steps."""

    height: np.ndarray  # of the line over the undeformed foundation, in h, shape (frames, n)
    displacement: np.ndarray  # of the elements, in h, shape (frames, n)


@kernel
def record_trace(trace, k, lag, before, now, old, new, p):
    """Record the values of a step in row k.

    before, now : slopes before and after the step, in h/dx. old, new : indentation before and after
    the step, in h. p : forces of the elements. Slopes and forces have the shape (n,).
    """
    sums = weighted_sums(-p, None, now + lag * (before - now), 0.0)
    record_forces(trace, k, lag, sums, p.size, old, new)
    trace.samples_per_contact[k] = samples_per_contact(p)


@inlined_kernel
def record_forces(trace, k, lag, sums, n, old, new):
    """Record the sums of eq. 5 over n elements; the other arguments are those of record_trace."""
    normal, tangential, touching = sums
    trace.mu[k] = tangential / normal if normal > 0.0 else np.nan
    trace.indentation[k] = new + lag * (old - new)
    trace.normal_force[k] = normal / n
    trace.friction_force[k] = tangential / n
    trace.contact_fraction[k] = touching / n


@inlined_kernel
def record_motion(trace, k, lag, track, s):
    """Record the time and distance at which the force of step s acts, and the velocity."""
    moved = track.place[s + 1] - track.place[s]
    trace.time[k] = track.time[s + 1] - lag * track.dt[s]
    trace.distance[k] = track.place[s + 1] - lag * moved
    trace.velocity[k] = moved / track.dt[s]


@kernel
def count_lengths(lengths, p):
    """Count the contacts, which are runs of pressed elements on the periodic line."""
    n = p.size
    free = 0
    while free < n and p[free] > 0.0:
        free += 1
    if free == n:
        _count_contact(lengths, n)
        return
    run = 0
    for i in range(1, n + 1):
        if p[(free + i) % n] > 0.0:
            run += 1
        elif run > 0:
            _count_contact(lengths, run)
            run = 0


@kernel
def _count_contact(lengths, length):
    """Count one contact if its length lies in a bin."""
    for b in range(lengths.counts.size):
        if lengths.edges[b] <= length < lengths.edges[b + 1]:
            lengths.counts[b] += 1.0


@kernel
def record_snapshot(snapshots, k, z, d, u):
    """Record line and displacements at the end of a step, both in h, of shape (n,)."""
    for i in range(u.size):
        snapshots.height[k, i] = z[i] - d
        snapshots.displacement[k, i] = u[i]
