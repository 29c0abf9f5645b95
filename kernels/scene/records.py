"""Recorders of a march: traces, contact lengths, snapshots; compiled only if requested.

A recorder is a NamedTuple of arrays that a march fills, or None.
"""

from typing import NamedTuple

import numpy as np

from ..body.ground import fill_heights
from ..body.step import elements_of
from ..compile.jit import dispatch_on_type, inlined_kernel, kernel
from ..rheology.law import displacement


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
    samples_per_contact: np.ndarray  # see body/patch_width.py
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
def record_trace(trace, k, lag, acting, old, new, width):
    """Record the values of a step in row k.

    acting : its Forces. old, new : indentation before and after it, in h. width : of its patches.
    """
    trace.mu[k] = acting.mu
    trace.indentation[k] = new + lag * (old - new)
    trace.normal_force[k] = acting.normal
    trace.friction_force[k] = acting.friction
    trace.contact_fraction[k] = acting.contact_fraction
    trace.samples_per_contact[k] = width


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


@dispatch_on_type
def record_snapshot(snapshots, k, body, state, place):
    """Record frame k of a body at the end of a step; place : of the surface."""


@record_snapshot.register(Snapshots)
def _record_snapshot(snapshots, k, body, state, place):
    elements = elements_of(body, state)
    fill_heights(body.ground, place, 0, snapshots.height[k])
    snapshots.height[k] -= state.d
    snapshots.displacement[k] = displacement(body.form, elements.memory, elements.p)
