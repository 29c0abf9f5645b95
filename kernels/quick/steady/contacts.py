"""The contacts of a steady state, as a sweep (carry.py) meets them: pieces of patches."""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from ...model.friction import trailing_edge_reach
from .spans import SPAN

AHEAD, BEHIND, FREE, SUM = range(4)  # columns of edges


class Contacts(NamedTuple):
    """The contacts of a steady state in pieces: patches, cut where the array or the list begins.

    The first piece has the deepest sample at its top; the others follow downstream.
    """

    ends: np.ndarray  # shape (pieces, 3): top and bottom sample, whether it joins the piece before
    edges: np.ndarray  # shape (pieces, 4): reach ahead of the top and behind the bottom, w at top,
    # and the sum of d - z
    slope: np.ndarray  # of the line, in h/dx, shape (n,)
    speed: float  # vbar of the steady state
    entered: np.ndarray  # shape (n // SPAN + 1,): u upstream of each span, and of the samples left


@kernel
def room_for(slope, speed):
    """Return Contacts with room for all pieces that a line of these slopes can have."""
    most = slope.size // 2 + 3
    entered = np.zeros(slope.size // SPAN + 1)  # the last stays as it is where no samples are left
    return Contacts(np.empty((most, 3), np.int64), np.empty((most, 4)), slope, speed, entered)


@kernel
def first(contacts, pieces):
    """Return so many pieces."""
    ends, edges = contacts.ends[:pieces], contacts.edges[:pieces]
    return Contacts(ends, edges, contacts.slope, contacts.speed, contacts.entered)


@refcount_free_kernel
def open_piece(contacts, piece, z, d, top, free, u):
    """Begin a piece of contact at sample ``top``, whose free displacement is ``free``.

    u : that of the sample ahead, which does not touch. Contact reaches there to where z - w meets
    d, linear in between. contacts : None where nothing is listed, here and below.
    """
    if contacts is not None:
        ahead = z[top + 1 if top + 1 < z.size else 0]
        c = z[top] - free
        contacts.ends[piece, 0], contacts.ends[piece, 2] = top, 0
        contacts.edges[piece, AHEAD] = (d - c) / ((ahead - u) - c)
        contacts.edges[piece, FREE] = free


@refcount_free_kernel
def leave_piece(contacts, piece, z, d, j):
    """End a piece of contact in front of sample j, which is free.

    The trailing edge lies where the pressure (d - z) + vbar z' vanishes, linear in between.
    """
    if contacts is not None:
        bottom = j + 1 if j + 1 < z.size else 0
        here = (d - z[bottom]) + contacts.speed * contacts.slope[bottom]
        behind = trailing_edge_reach(here, (d - z[j]) + contacts.speed * contacts.slope[j])
        contacts.ends[piece, 1], contacts.edges[piece, BEHIND] = bottom, behind


@refcount_free_kernel
def join_pieces(contacts, above, piece, bottom, top, free):
    """End the piece ``above`` at its ``bottom`` and go on with ``piece`` from ``top``."""
    if contacts is not None:
        contacts.ends[above, 1], contacts.edges[above, BEHIND] = bottom, 0.5
        contacts.ends[piece, 0], contacts.ends[piece, 2] = top, 1
        contacts.edges[piece, AHEAD], contacts.edges[piece, FREE] = 0.5, free


@refcount_free_kernel
def begin_sum(contacts, piece, total):
    """Begin the sum of d - z over a piece. total : -sum u over the samples before it."""
    if contacts is not None:
        contacts.edges[piece, SUM] = -total


@refcount_free_kernel
def end_sum(contacts, piece, total):
    """End the sum of d - z over a piece. total : -sum u over the samples up to its bottom."""
    if contacts is not None:
        contacts.edges[piece, SUM] += total


@refcount_free_kernel
def enter_span(contacts, b, u):
    """Note with which displacement the element enters that comes to span b from upstream."""
    if contacts is not None:
        contacts.entered[b] = u
