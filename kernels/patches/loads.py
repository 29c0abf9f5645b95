"""Steady sliding of one line at one speed under many loads: indentations, friction, jumps.

In full contact nothing is searched for. Where no element is free, -u = d - z everywhere, so that
the load n Fbar = sum (d - z) gives d, whatever the speed; and so it is where this d lies above all
thresholds t_j of spans.py, F_N > max (z - v z') in the limit of fine samples. The sums of eqs. 4
and 5 are then those of the whole line.
"""

import numpy as np

from kernels.jit import kernel
from kernels.patches.pieces import (
    COLUMNS,
    FROM_HEIGHT,
    FROM_SLOPE,
    PRESS,
    balance,
    elastic_part,
    forces,
    median_width,
    press_pieces,
    steepest,
    sum_pieces,
)
from kernels.steady.carry import decay_of, first, room_for
from kernels.steady.sliding import elastic_guess, indentation

# What is found of every load: d over the deepest sample, mu, the share in contact, samples per
# contact, sweeps, and whether the whole line touches.
INDENTATION, MU, CONTACT, SAMPLES, SWEEPS, FULL = range(6)


@kernel
def slide(law, z, slope, spans, own, speed, loads, guesses, steps, share, others, press):
    """Return (found, jumps), shapes (loads, 6) and (loads, others).

    own : Thresholds at ``speed`` (vbar), spans : of the line. loads : n Fbar. guesses : of d, NaN
    where there is none. steps : samples per spacing. share : of the elastic part of mu that is
    corrected. others : the speeds that are jumped to, press : largest thresholds of the pressure
    at them, shape (others, spans), with that of all samples in the last column.
    """
    n = z.size
    decay = decay_of(law)
    contacts = room_for(slope, speed)
    room = np.empty((contacts.ends.shape[0], COLUMNS))
    found = np.empty((loads.size, 6))
    jumps = np.empty((loads.size, others.size))
    for i in range(loads.size):
        load = loads[i]
        d = load / n + (z[0] + spans.whole[0] / n)
        full = d > own.stay_all
        sweeps, pieces = 0, 1
        if not full:
            guess = guesses[i]
            if not guess > 0.0:
                guess = elastic_guess(z, spans.deepest, load)
            d, sweeps, pieces = indentation(decay, z, spans, own.stay, load, guess, contacts)
        listed, table = first(contacts, pieces), room[:pieces]
        if full:
            _whole_line(z, slope, spans, listed, table)
        else:
            sum_pieces(z, slope, spans, listed, table)
        mu = summed = contact = 0.0
        for k in range(-1, others.size):  # its own speed first
            there = speed if k < 0 else others[k]
            high = own.press if k < 0 else press[k]
            if full:
                table[0, PRESS] = own.press_all if k < 0 else press[k, -1]
            else:
                press_pieces(z, slope, high, listed, there, table)
            deep = balance(z, slope, listed, table, there, load)
            force = forces(z, slope, listed, table, there, deep)
            after = force.tangential / force.normal
            if k >= 0:
                jumps[i, k] = after - summed  # errors of the elastic part cancel
                continue
            mu, summed, contact = after, after, force.contact / n
            if share > 0.0:
                mu += share / load * elastic_part(z, slope, listed, force, deep, speed, steps)
                # Where a contact is narrower than a sample this alone is sure: mu is a mean slope.
                limit = steepest(slope, spans, listed)
                mu = min(max(mu, -limit), limit)
        found[i, INDENTATION], found[i, MU], found[i, CONTACT] = d, mu, contact
        found[i, SAMPLES] = n if full else median_width(z, d, decay, listed, table)
        found[i, SWEEPS], found[i, FULL] = sweeps, full
    return found, jumps


@kernel
def _whole_line(z, slope, spans, contacts, table):
    """Make one piece of the whole line, whose sums are known."""
    contacts.ends[0, 0], contacts.ends[0, 1], contacts.ends[0, 2] = z.size - 1, 0, 1
    contacts.edges[0, 0] = contacts.edges[0, 1] = 0.5
    table[0, 0] = z.size
    table[0, 1:5] = spans.whole
    table[0, FROM_HEIGHT], table[0, FROM_SLOPE] = z[0], slope[0]
