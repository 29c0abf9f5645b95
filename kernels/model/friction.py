"""Friction of a contact state: eq. 5 by quadrature at an instant, or as the mean over a step.

Eq. 5 is summed here, sample by sample, and in two places of quick/ with precomputed sums over many
samples: contacts/loads.py for a line that is pressed everywhere, and march/active.py as the mean
over a step.
Source: Li et al. (2014), eqs. 3 to 5, doi:10.1038/srep05795.
"""

import math
from typing import NamedTuple

import numpy as np

from ..compile.jit import kernel
from .contact import solve_indentation

MIN_COVERAGE = 0.01  # least share of a touching sample in contact: keeps it in the load balance
MIN_EDGE_REACH, MAX_EDGE_REACH = -0.5, 1.5  # samples; a trailing edge farther off is not resolved


class ContactSamples(NamedTuple):
    """The touching samples of a line at one instant."""

    weight: np.ndarray  # share of each sample that is in contact
    depth: np.ndarray  # z - d of each, in h
    slope: np.ndarray  # of each, in h/dx


@kernel
def quadrature(z, slope, w, d, formed, speed, load):
    """Return (mu, rate, contact): friction and indentation rate at one instant.

    In contact the pressure is p = (d - z) + vbar z' + d' (eq. 3 with the indentation rate
    kept). The load balance sum p = load over p > 0 (eq. 4) gives the rate d' exactly, and eq. 5
    gives the friction. If ``speed`` differs from ``formed``, the speed of the steady state (w, d),
    the instant is t0+ after a velocity jump, and mu - mu_1 is the exact jump.

    z, slope, w : shape (n,). d : indentation. formed, speed : vbar. load : n Fbar.
    mu in h/dx, rate in h/tau, contact : share of the line in contact.
    """
    mu, rate, contact = pressed_friction(contact_samples(z, slope, w, d, formed), speed, load)
    return mu, rate, min(contact / z.size, 1.0)  # two edges can overlap


@kernel
def contact_samples(z, slope, w, d, formed):
    """Return the ContactSamples of a steady state (w, d) at the speed ``formed``, vbar."""
    at = _touching(z, w, d)
    weight, depth, slopes = np.empty(at.size), np.empty(at.size), np.empty(at.size)
    for i in range(at.size):
        j = at[i]
        weight[i] = _covered(z, slope, w, d, formed, j)
        depth[i], slopes[i] = z[j] - d, slope[j]
    return ContactSamples(weight, depth, slopes)


@kernel
def pressed_friction(touching, speed, load):
    """Return (mu, d', number of pressed samples) of ContactSamples; see ``quadrature``."""
    threshold = touching.depth - speed * touching.slope  # minus the pressure where d' = 0
    # The first guess presses all elements but that of the highest threshold.
    rate, _ = solve_indentation(threshold, load, threshold.max(), touching.weight)
    normal, tangential, count = weighted_sums(threshold, touching.weight, touching.slope, rate)
    return tangential / normal, rate, count


@kernel
def _touching(z, w, d):
    """Return the samples at which the line touches."""
    at = np.empty(z.size, np.int64)
    count = 0
    for j in range(z.size):
        if z[j] - w[j] < d:
            at[count] = j
            count += 1
    return at[:count]


def sliding_friction(line, state, speed, load):
    """Return mu of steady sliding (eq. 5), in h/dx, from the samples of a line.

    state : of steady sliding at the speed vbar under the load n Fbar (steady.py). Two bounds are
    used: |mu| is at most the steepest slope in contact, and mu is positive on a line without modes
    above q = pi/dx.
    """
    z, slope, (w, d), steps = line.z, line.slope, state, line.steps_per_spacing
    mu, rate, _ = quadrature(z, slope, w, d, speed, speed, load)
    share = correction_share(steps, speed)
    if share > 0.0:
        missing = elastic_correction(z, slope, w, d, speed, rate, steps)
        steepest = np.abs(slope[_touching(z, w, d)]).max()
        mu = min(max(mu + share / load * missing, -steepest), steepest)
    if line.band_limited and mu <= 0.0:
        rise = np.roll(z, -1) - z  # of the line at an element, in a step
        mu = steps * step_average(rise, z - w, d)
    return mu


def correction_share(steps: float, speed: float) -> float:
    """Return the share of the elastic part of mu that is corrected.

    Measured: the correction reduces the error of friction if the time per sample is longer than
    tau, and increases it otherwise.
    """
    share = math.exp(-((steps * speed) ** 2))
    return share if share >= 1e-3 else 0.0


@kernel
def elastic_correction(z, slope, w, d, speed, rate, steps):
    """Return the correction to the sum of p z' of ``quadrature`` in steady sliding.

    The elastic part int (D - z) z' dx = [-(D - z)^2 / 2], D = d + d', is exact here, in the cell
    around each sample. Unlike friction, the error of its sum over samples does not fall with the
    speed; below one sample per tau it exceeds friction. A sample at an unresolved edge is not
    corrected. rate : d' from ``quadrature`` at ``speed``. steps : samples per spacing.
    """
    missing = 0.0
    for j in _touching(z, w, d):
        ahead, behind = (j + 1) % z.size, (j - 1) % z.size
        after, before = 0.5 * (z[j] + z[ahead]), 0.5 * (z[j] + z[behind])
        if not z[ahead] - w[ahead] < d:
            after = z[j] + _reach(z, slope, w, d, speed, j, ahead) * (z[ahead] - z[j])
        if not z[behind] - w[behind] < d:
            reach = _reach(z, slope, w, d, speed, j, behind)
            if not MIN_EDGE_REACH < reach < MAX_EDGE_REACH:
                continue
            before = z[j] + reach * (z[behind] - z[j])
        deep = d + rate
        covered = _covered(z, slope, w, d, speed, j)
        missing += 0.5 * steps * (after - before) * ((deep - before) + (deep - after))
        missing += covered * speed * slope[j] ** 2
        p = (deep - z[j]) + speed * slope[j]
        if p > 0.0:  # the contribution to the sum
            missing -= covered * p * slope[j]
    return missing


@kernel
def _reach(z, slope, w, d, formed, j, k):
    """Return the extent of contact, in samples, from touching sample j towards free neighbour k.

    The leading edge lies where z - w crosses d. The trailing edge lies where the pressure
    (d - z) + vbar z' of the steady state vanishes. Both are interpolated linearly.
    """
    if k == (j + 1) % z.size:
        c = z[j] - w[j]
        return (d - c) / ((z[k] - w[k]) - c)
    here = (d - z[j]) + formed * slope[j]
    return trailing_edge_reach(here, (d - z[k]) + formed * slope[k])


@kernel
def trailing_edge_reach(here, there):
    """Return the extent of contact, in samples, from a touching sample to zero pressure behind it.

    The pressure is interpolated linearly; an unresolved extent is clipped. here, there : pressure
    at that sample and at its free neighbour.
    """
    fall = here - there
    return min(max(here / fall, MIN_EDGE_REACH), MAX_EDGE_REACH) if fall > 0.0 else 0.5


@kernel
def _covered(z, slope, w, d, formed, j):
    """Return the share of touching sample j that is in contact: 1 except at edges.

    The pressure may be finite at an edge, so counting whole samples would be a first-order error.
    """
    covered = 1.0
    for k in ((j + 1) % z.size, (j - 1) % z.size):
        if not z[k] - w[k] < d:
            covered += _reach(z, slope, w, d, formed, j, k) - 0.5
    return max(covered, MIN_COVERAGE)


@kernel
def lagged_slope(slope, lag):
    """Return the slopes at the instant when the force of a step acts (n,), by linear interpolation.

    slope : at the samples of a period, shape (n,), in h/dx. lag : in steps (rheology/law.py).
    """
    n = slope.size
    weight = np.empty(n)
    for j in range(n):
        weight[j] = slope[j] + lag * (slope[j + 1 if j + 1 < n else 0] - slope[j])
    return weight


@kernel
def step_average(weight, c, d):
    """Return mu averaged over a step, in h/dx: eq. 5 with its forces and the lagged slopes.

    weight : lagged slope, in h/dx. c : contact thresholds, in h. Both have the shape (n,).
    d : indentation, in h.
    """
    normal, tangential, _ = weighted_sums(c, None, weight, d)
    return tangential / normal


@kernel
def steady_step_average(z, slope, state, lag):
    """Return mu of the steps of steady sliding, in h/dx, at which a march in these steps ends.

    z, slope : the line, shape (n,). state : of steady sliding (rheology/law.py). lag : in steps.
    """
    c = np.empty(z.size)
    for j in range(z.size):  # a loop: numba takes seconds to compile array expressions
        c[j] = z[j] - state.w[j]
    return step_average(lagged_slope(slope, lag), c, state.d)


@kernel
def weighted_sums(threshold, covered, slope, d):
    """Return the sums of eq. 5: of forces, of forces times slopes, and the number of samples.

    The forces are p = d - threshold, where positive. covered : share of each sample in contact,
    which weights all sums, or None for 1. threshold, covered, slope : shape (n,).
    """
    normal = tangential = contact = 0.0
    for i in range(threshold.size):
        p = d - threshold[i]
        if p > 0.0:
            share = 1.0 if covered is None else covered[i]
            normal += share * p
            tangential += share * p * slope[i]
            contact += share
    return normal, tangential, contact


def mean_slope(p, slope):
    """Return mu by eq. 5 from known forces p >= 0 and the slopes of the line.

    This function is not a kernel: numpy sums in pairs, which keeps more digits.
    """
    return float(np.sum(p * slope) / p.sum())
