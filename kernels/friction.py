"""Friction of a contact state: eq. 5 by quadrature at an instant, or as mean over a step."""

import numpy as np

from kernels.jit import kernel

LEAST_COVERED = 0.01  # of a sample: keeps every touching sample in the load balance


@kernel
def quadrature(z, slope, c, d, formed, speed, load):
    """Return (mu, rate, contact): friction and indentation rate at one instant.

    In contact the pressure is p = (d - z) + vbar z' + d' (eq. 3 with the indentation rate
    kept). The load balance sum p = load over p > 0 (eq. 4) gives the rate d' exactly, eq. 5
    the friction. ``speed`` may differ from ``formed``, the one that led to the steady state
    (c, d): then this is the moment t0+ after a velocity jump, and mu - mu_1 is the exact jump.

    z, slope, c : shape (n,). d : indentation. formed, speed : vbar. load : n Fbar.
    mu in h/dx, rate in h/tau, contact : share of the line in contact.
    """
    n = z.size
    pressure = np.empty(n)
    weight = np.empty(n)
    lever = np.empty(n)
    touching = 0
    for j in range(n):
        if c[j] < d:
            weight[touching] = _covered(z, slope, c, d, formed, j)
            pressure[touching] = (d - z[j]) + speed * slope[j]
            lever[touching] = slope[j]
            touching += 1
    rate = _indentation_rate(pressure[:touching], weight[:touching], load)
    normal = tangential = contact = 0.0
    for i in range(touching):
        p = pressure[i] + rate
        if p > 0.0:
            normal += weight[i] * p
            tangential += weight[i] * p * lever[i]
            contact += weight[i]
    return tangential / normal, rate, contact / n


@kernel
def _covered(z, slope, c, d, formed, j):
    """Return how much of touching sample j the contact covers: 1 but at its edges.

    Pressure may be finite at an edge, so a whole or no sample there is an error of first order.
    The leading edge lies where d - c changes sign, the trailing edge where the pressure
    (d - z) + vbar z' of the steady state vanishes; both by linear interpolation.
    """
    ahead = j + 1 if j + 1 < z.size else 0
    behind = j - 1 if j > 0 else z.size - 1
    covered = 1.0
    if not c[ahead] < d:
        covered += (d - c[j]) / (c[ahead] - c[j]) - 0.5
    if not c[behind] < d:
        here = (d - z[j]) + formed * slope[j]
        fall = here - ((d - z[behind]) + formed * slope[behind])
        covered += min(max(here / fall, -0.5), 1.5) - 0.5 if fall > 0.0 else 0.0
    return max(covered, LEAST_COVERED)


@kernel
def _indentation_rate(pressure, weight, load):
    """Return the root of sum_i weight_i max(0, pressure_i + rate) = load."""
    rate = -pressure.min()  # a first guess with every element pressed, on either side
    previous = -1
    right = False
    while True:
        total = 0.0
        share = 0.0
        count = 0
        for i in range(pressure.size):
            p = pressure[i] + rate
            if p > 0.0:
                total += weight[i] * p
                share += weight[i]
                count += 1
        if count == 0:  # all pressures are equal
            new = rate + load / weight.sum()
            if not new > rate:
                return rate
            rate = new
            continue
        new = rate - (total - load) / share
        if count == previous or (right and not new < rate):
            return new
        previous = count if new < rate or right else -1
        right = True
        rate = new


@kernel
def lagged_slope(slope, lag):
    """Return the slope read ``lag`` of a step before its end, shape (n,): see schemes.py."""
    n = slope.size
    weight = np.empty(n)
    for j in range(n):
        weight[j] = slope[j] + lag * (slope[j + 1 if j + 1 < n else 0] - slope[j])
    return weight


@kernel
def step_average(weight, c, d):
    """Return the friction averaged over a step: its forces times the slope where they act.

    weight : lagged slope, c : contact thresholds, both of shape (n,). mu in h/dx.
    """
    total = 0.0
    friction = 0.0
    for j in range(c.size):
        depth = d - c[j]
        if depth > 0.0:
            total += depth
            friction += depth * weight[j]
    return friction / total
