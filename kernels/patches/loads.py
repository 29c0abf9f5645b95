"""Steady sliding of one line at one speed under many loads: indentations, friction, jumps.

In full contact nothing is searched for. Where no element is free, -u = d - z everywhere, so that
the load n Fbar = sum (d - z) gives d, whatever the speed; and so it is where this d lies above all
thresholds t_j of spans.py, F_N > max (z - v z') in the limit of fine samples. The sums of eqs. 4
and 5 are then those of the whole line.
"""

from typing import NamedTuple

import numpy as np

from kernels.jit import kernel
from kernels.patches.pressure import (
    balance,
    elastic_part,
    friction,
    friction_everywhere,
    pressed,
)
from kernels.patches.touching import list_touching, median_width, room_for_all, steepest
from kernels.steady.carry import decay_of
from kernels.steady.contacts import first, room_for
from kernels.steady.sliding import elastic_guess, indentation
from kernels.steady.spans import Thresholds

# What is found of every load: d over the deepest sample, mu, the share in contact, samples per
# contact, sweeps, and whether the whole line touches.
INDENTATION, MU, CONTACT, SAMPLES, SWEEPS, FULL = range(6)


class Speeds(NamedTuple):
    """The speed of steady sliding, and those that are jumped to."""

    own: float  # vbar
    thresholds: Thresholds  # at it
    others: np.ndarray  # vbar, shape (others,)
    press: np.ndarray  # shape (others, spans + 1): thresholds of the pressure, of all samples last


@kernel
def slide(law, z, slope, spans, speeds, loads, guesses, steps, share):
    """Return (found, jumps), shapes (loads, 6) and (loads, others).

    spans : of the line. loads : n Fbar. guesses : of d, NaN where there is none. steps : samples
    per spacing. share : of the elastic part of mu that is corrected.
    """
    n, own = z.size, speeds.thresholds
    decay = decay_of(law)
    contacts, everything = room_for(slope, speeds.own), room_for_all(n)
    memory = np.empty(n)
    found = np.empty((loads.size, 6))
    jumps = np.empty((loads.size, speeds.others.size))
    for i in range(loads.size):
        load = loads[i]
        d = load / n + (z[0] + spans.whole[0] / n)
        full = d > own.stay_all
        sweeps, pieces = 0, 1
        if full:
            _list_whole_line(n, contacts)
        else:
            guess = guesses[i]
            if not guess > 0.0:
                guess = elastic_guess(z, spans.deepest, load)
            d, sweeps, pieces = indentation(decay, z, spans, own.stay, load, guess, contacts)
        listed = first(contacts, pieces)
        touching = list_touching(listed, everything)
        part = pressed(z, slope, spans, touching, speeds.own, own.press, memory)
        mu, contact, deep = _friction(part, full, own.press_all, load, d)
        for k in range(speeds.others.size):
            there = pressed(z, slope, spans, touching, speeds.others[k], speeds.press[k], memory)
            after, _, _ = _friction(there, full, speeds.press[k, -1], load, deep)
            jumps[i, k] = after - mu  # errors of the elastic part cancel
        if share > 0.0:
            part = pressed(z, slope, spans, touching, speeds.own, own.press, memory)
            mu += share / load * elastic_part(part, listed, deep, steps)
            # Where a contact is narrower than a sample this alone is sure: mu is a mean of slopes.
            limit = steepest(slope, spans, touching)
            mu = min(max(mu, -limit), limit)
        found[i, INDENTATION], found[i, MU], found[i, CONTACT] = d, mu, contact / n
        found[i, SAMPLES] = median_width(z, d, spans, decay, listed)
        found[i, SWEEPS], found[i, FULL] = sweeps, full
    return found, jumps


@kernel
def _list_whole_line(n, contacts):
    """Make one piece of the whole line."""
    contacts.ends[0, 0], contacts.ends[0, 1], contacts.ends[0, 2] = n - 1, 0, 1
    contacts.edges[0, 0] = contacts.edges[0, 1] = 0.5


@kernel
def _friction(contact, full, highest, load, guess):
    """Return (mu, samples under pressure, d + d'). highest : threshold of all samples."""
    if full:
        mu, deep = friction_everywhere(contact.z, contact.slope, contact.spans, contact.speed, load)
        if deep > highest:
            return mu, float(contact.z.size), deep
    deep = balance(contact, load, guess)
    mu, count = friction(contact, deep)
    return mu, count, deep
