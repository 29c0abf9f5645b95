"""The indentation of steady sliding under a load, found with spans.

The force F(d) is increasing and convex (model/steady.py), so Newton's method from the right keeps
right of the root and from the left jumps there. Two steps go before that are exact where F is a
power of d: they need no good guess. Sweeps that end the search list the contacts.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from ...model.contact import excess_at, solve_indentation
from ...model.steady import steady_indentation
from .carry import Decay, carry
from .contacts import Contacts
from .spans import Spans

POWER_STEPS, STEPS = 2, 3  # of the approach, before contacts are listed
CLOSE = 1e-13  # of the load: what may be left of an excess, beyond the rounding of long sums
FEW = 512  # samples of a line that are asked where an elastic foundation would be


@kernel
def elastic_guess(z, deepest, load):
    """Return about the indentation of elastic contact, from few samples. load : n Fbar."""
    step = max(1, z.size // FEW)
    first = deepest % step
    some = np.empty((z.size - first + step - 1) // step)
    for i in range(some.size):
        some[i] = z[first + i * step]
    share = load / z.size * some.size
    d, _ = solve_indentation(some, share, z[deepest] + share / some.size)
    return d


@refcount_free_kernel
def power_step(depth, force, rate, load):
    """Return the depth after a step of Halley's method for force = load.

    rate : derivative of the force with respect to the depth. The step is exact where the force is a
    power of the depth, and elsewhere never far off.
    """
    power = depth * rate / force
    up, down = power + 1.0, power - 1.0
    return depth * ((down * force + up * load) / (up * force + down * load))


@kernel
def approach(decay, z, spans, stay, load):
    """Return d near the root under the load n Fbar. decay, z, spans, stay : as of carry."""
    d = elastic_guess(z, spans.deepest, load)
    for step in range(STEPS):
        total, slope, _, _ = carry(decay, z, spans, stay, d, None, None)
        if step < POWER_STEPS:
            deepest = z[spans.deepest]
            d = deepest + power_step(d - deepest, total, slope, load)
        else:
            d -= (total - load) / slope
    return d


class Carried(NamedTuple):
    """Elements under a line that slides steadily, by spans; arguments of carry."""

    decay: Decay
    z: np.ndarray
    spans: Spans
    stay: np.ndarray
    contacts: Contacts  # filled
    pieces: np.ndarray  # of contact, shape (1,): filled


@excess_at.register(Carried)
def _excess_of_carried(contact, load, d):
    decay, z, spans, stay, contacts, pieces = contact
    total, slope, touching, pieces[0] = carry(decay, z, spans, stay, d, contacts, None)
    return total - load, slope, touching


@kernel
def indentation(decay, z, spans, stay, load, near, contacts):
    """Return (d, sweeps, pieces) of steady sliding under the load n Fbar.

    contacts are filled with so many pieces. decay, z, spans, stay, contacts : as of carry. near : d
    as approach leaves it.
    """
    elements = Carried(decay, z, spans, stay, contacts, np.zeros(1, np.int64))
    d, sweeps, _ = steady_indentation(elements, load, near, False, z.size, CLOSE)
    return d, sweeps, elements.pieces[0]
