"""Contact patches of a steadily sliding line, recorded in pieces by a sweep (span_sweep.py).

The functions called by a sweep accept None in place of the ContactPieces and then record nothing.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from ...model.friction import trailing_edge_reach
from .spans import SPAN

LEADING, TRAILING, JOINED = range(3)  # columns of ends
LEADING_REACH, TRAILING_REACH, FREE_DISPLACEMENT, DEPTH_SUM = range(4)  # columns of edges


class ContactPieces(NamedTuple):
    """The contact patches of a steady state, cut at the end of the array and at the deepest sample.

    The first piece has the deepest sample at its leading edge; the others follow downstream.
    """

    ends: np.ndarray  # shape (pieces, 3): leading sample, which has the highest index; trailing
    # sample; 1 if the piece continues the one before it
    edges: np.ndarray  # shape (pieces, 4): extent of contact ahead of the leading sample and behind
    # the trailing one, in samples; w at the leading sample; sum of d - z over the piece
    slope: np.ndarray  # of the line, in h/dx, shape (n,)
    speed: float  # vbar of the steady state
    entered: np.ndarray  # shape (n // SPAN + 1,): u of elements that enter each span and the tail


@kernel
def allocate_pieces(slope, speed):
    """Return ContactPieces with room for all pieces that a line of these slopes can have."""
    most = slope.size // 2 + 3
    entered = np.zeros(slope.size // SPAN + 1)  # the last stays 0 without a tail
    return ContactPieces(np.empty((most, 3), np.int64), np.empty((most, 4)), slope, speed, entered)


@kernel
def first_pieces(contacts, count):
    """Return the first ``count`` pieces."""
    ends, edges = contacts.ends[:count], contacts.edges[:count]
    return ContactPieces(ends, edges, contacts.slope, contacts.speed, contacts.entered)


@refcount_free_kernel
def open_piece(contacts, piece, z, d, leading, free, u):
    """Begin a piece at the sample ``leading``, whose free displacement is ``free``.

    u : displacement at the sample ahead, which does not touch. The leading edge lies where the
    linear interpolation of z - w equals d.
    """
    if contacts is not None:
        ahead = z[leading + 1 if leading + 1 < z.size else 0]
        c = z[leading] - free
        contacts.ends[piece, LEADING], contacts.ends[piece, JOINED] = leading, 0
        contacts.edges[piece, LEADING_REACH] = (d - c) / ((ahead - u) - c)
        contacts.edges[piece, FREE_DISPLACEMENT] = free


@refcount_free_kernel
def close_piece(contacts, piece, z, d, j):
    """End a piece upstream of sample j, which is free.

    The trailing edge lies where the linearly interpolated pressure (d - z) + vbar z' vanishes.
    """
    if contacts is not None:
        trailing = j + 1 if j + 1 < z.size else 0
        here = (d - z[trailing]) + contacts.speed * contacts.slope[trailing]
        reach = trailing_edge_reach(here, (d - z[j]) + contacts.speed * contacts.slope[j])
        contacts.ends[piece, TRAILING], contacts.edges[piece, TRAILING_REACH] = trailing, reach


@refcount_free_kernel
def join_pieces(contacts, upstream, piece, trailing, leading, free):
    """End the piece ``upstream`` at ``trailing`` and continue it as ``piece`` from ``leading``."""
    if contacts is not None:
        contacts.ends[upstream, TRAILING], contacts.edges[upstream, TRAILING_REACH] = trailing, 0.5
        contacts.ends[piece, LEADING], contacts.ends[piece, JOINED] = leading, 1
        contacts.edges[piece, LEADING_REACH] = 0.5
        contacts.edges[piece, FREE_DISPLACEMENT] = free


@refcount_free_kernel
def begin_depth_sum(contacts, piece, total):
    """Begin the sum of d - z over a piece. total : -sum u over the samples before it."""
    if contacts is not None:
        contacts.edges[piece, DEPTH_SUM] = -total


@refcount_free_kernel
def end_depth_sum(contacts, piece, total):
    """End the sum of d - z over a piece. total : -sum u up to its trailing sample."""
    if contacts is not None:
        contacts.edges[piece, DEPTH_SUM] += total


@refcount_free_kernel
def record_entry(contacts, b, u):
    """Record the displacement u with which the element enters span b from upstream."""
    if contacts is not None:
        contacts.entered[b] = u
