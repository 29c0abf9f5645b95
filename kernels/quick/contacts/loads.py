"""Steady sliding of one line at one speed under many loads: indentations, friction, jumps.

In full contact nothing is searched for. Where no element is free, -u = d - z everywhere, so that
the load n Fbar = sum (d - z) gives d, whatever the speed; and so it is where this d lies above all
thresholds t_j of spans.py, F_N > max (z - v z') in the limit of fine samples. The sums of eqs. 4
and 5 are then those of the whole line.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from ...model.contact import indentation_under
from ..steady.contacts import first, room_for
from ..steady.sliding import STEPS, approach, indentation
from ..steady.spans import SPAN
from ..steady.thresholds import Thresholds
from .pressed import MovingLine, pressed, room_for_pressed
from .pressure import elastic_part, friction, friction_everywhere
from .touching import list_touching, mean_rise, median_width, room_for_all, steepest

# What is found of every load: d over the deepest sample, mu, the share in contact, samples per
# contact, sweeps, whether the whole line touches, and whether it is pressed after all jumps too.
INDENTATION, MU, CONTACT, SAMPLES, SWEEPS, FULL, PRESSED = range(7)


class Speeds(NamedTuple):
    """The speed of steady sliding, and those jumped to."""

    own: float  # vbar
    thresholds: Thresholds  # at it
    others: np.ndarray  # vbar, shape (others,)
    press: np.ndarray  # shape (others, spans + 1): thresholds of the pressure, of all samples last


class Found(NamedTuple):
    """What is found, of as many rows as there are loads; of several lines one above the other."""

    table: np.ndarray  # shape (..., loads, 7): INDENTATION to PRESSED
    jumps: np.ndarray  # shape (..., loads, others): change of mu at the jumps to other speeds
    rates: np.ndarray  # of the same shape: d' after them
    entered: np.ndarray  # shape (..., loads, spans + 1), as of Contacts


class How(NamedTuple):
    """How friction is found."""

    steps: float  # samples per spacing
    share: float  # of the elastic part that is corrected
    smooth: bool  # whether the line is a function without modes above q = pi/dx
    followed: bool  # whether partial contacts will be, between the samples: d alone is found here


@kernel
def slide(decay, z, slope, spans, speeds, loads, how, into):
    """Fill ``into``, which is Found, for steady sliding of one line under all loads.

    decay, spans : of the law and of the line. loads : n Fbar.
    """
    n, own = z.size, speeds.thresholds
    contacts, rooms = room_for(slope, speeds.own), (room_for_all(n), room_for_pressed(n))
    table, jumps, rates, entered = into
    for i in range(loads.size):
        load, pieces, sweeps = loads[i], 1, 0
        d = load / n + (z[0] + spans.whole[0] / n)
        full = d > own.stay_all
        if full:
            _list_whole_line(z, d, contacts)
        else:
            near = approach(decay, z, spans, own.stay, load)
            d, sweeps, pieces = indentation(decay, z, spans, own.stay, load, near, contacts)
            sweeps += STEPS
        listed = first(contacts, pieces)
        for b in range(contacts.entered.size):
            entered[i, b] = contacts.entered[b]
        table[i, INDENTATION], table[i, SWEEPS], table[i, FULL] = d, sweeps, full
        table[i, PRESSED] = False
        if how.followed and not full:
            continue
        at = MovingLine(z, slope, spans, speeds.own, own.press)
        mu, contact, least = _weigh(
            at, speeds, listed, load, d, full, how, rooms, jumps[i], rates[i]
        )
        if how.smooth and mu <= 0.0:
            # That it takes work is sure: what the forces do while the line rises.
            mu = how.steps * mean_rise(z, d, decay, listed)
        table[i, MU] = mu
        table[i, CONTACT] = min(contact / n, 1.0)  # edges of two contacts can overlap
        table[i, SAMPLES] = median_width(z, d, decay, listed)
        table[i, PRESSED] = full and least == n


@kernel
def _weigh(at, speeds, contacts, load, d, full, how, rooms, jumps, rates):
    """Return (mu, samples under pressure, the fewest so, also after jumps) of steady sliding at d.

    Fill in jumps and rates.
    """
    touching = list_touching(at.z, at.slope, contacts, rooms[0])
    part = pressed(at, touching, d, rooms[1])
    mu, contact, own = _friction(part, full, speeds.thresholds.press_all, load, d)
    least = contact
    missing = elastic_part(part, contacts, own, how.steps) if how.share > 0.0 else 0.0
    for k in range(speeds.others.size):
        line = MovingLine(at.z, at.slope, at.spans, speeds.others[k], speeds.press[k])
        there = pressed(line, touching, own, rooms[1])
        after, count, deep = _friction(there, full, speeds.press[k, -1], load, own)
        least = min(least, count)
        jumps[k], rates[k] = after - mu, deep - own  # errors of the elastic part cancel
    if how.share > 0.0:
        # Where a contact is narrower than a sample this alone is sure: mu is a mean of slopes.
        limit = steepest(at.spans, touching)
        mu = min(max(mu + how.share / load * missing, -limit), limit)
    return mu, contact, least


@refcount_free_kernel
def _list_whole_line(z, d, contacts):
    """Make one piece of the whole line."""
    contacts.ends[0, 0], contacts.ends[0, 1], contacts.ends[0, 2] = z.size - 1, 0, 1
    contacts.edges[0, 0] = contacts.edges[0, 1] = 0.5
    for b in range(contacts.entered.size):
        above = (b + 1) * SPAN
        contacts.entered[b] = z[above if above < z.size else 0] - d


@refcount_free_kernel
def _friction(contact, full, highest, load, guess):
    """Return (mu, samples under pressure, d + d'). highest : threshold of all samples."""
    if full:
        z, slope, spans, speed, _ = contact.line
        mu, deep = friction_everywhere(z, slope, spans, speed, load)
        if deep > highest:
            return mu, float(z.size), deep
    deep, _ = indentation_under(contact, load, guess)  # d + d', with pressures (d + d') - z + v z'
    mu, count = friction(contact, deep)
    return mu, count, deep
