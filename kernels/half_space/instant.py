"""Friction at the moment of a velocity jump: displacements stand, rates jump.

Behind a dashpot pressures follow the velocity at once. With f the part of A p that is there
without any rate, and eta the viscosity, on the samples that touch

    A p = f - eta du/dt,    du/dt = -(v dz/dx + d'),    p >= 0,

and p = 0 elsewhere: one more contact problem, restricted to the set. Without a dashpot mu is
continuous and its rate jumps: what a change dv of the velocity adds to the rates of pressures is
J_g A dp/dt = dv dz/dx + dd', J_g the compliance of the glass, on the samples that touch.
"""

import numpy as np

from ..model.friction import mean_slope
from ..rheology.spectrum import Spectrum
from .body import TOLERANCE, HalfSpace, at_samples, lasting_depth
from .contact import MOST_PASSES, ElasticContact, press
from .sliding_body import SlidingBody


def friction_jumps(
    space: HalfSpace, one: SlidingBody, speed: float, ratios: tuple[float, ...]
) -> tuple[np.ndarray, int]:
    """Return (jumps of mu from ``speed`` to ratios times it in h/dx, passes of the operator).

    one : steady sliding at speed (vbar, signed).
    """
    body, slope = one.body, space.surface.slope
    viscosity, lasting = lasting_depth(space.form, body.memory)
    if viscosity == 0.0:
        return np.zeros(len(ratios)), 0
    there = at_samples(lasting, body.offset, slope.shape)
    touching = body.p > 0.0
    mu, passes = [], 0
    found = ElasticContact(body.p, at_samples(body.depth, body.offset, slope.shape), 0.0, 0)
    for each in (1.0, *ratios):
        gap = -(there + viscosity * each * speed * slope)
        start = found._replace(d=float(gap[touching].mean()), passes=0)
        found = press(gap, space.pressure, space.operator, start, TOLERANCE, touching)
        passes += found.passes
        mu.append(mean_slope(found.p, slope))
    return np.array(mu[1:]) - mu[0], passes


def initial_rates(
    space: HalfSpace,
    spectrum: Spectrum,
    one: SlidingBody,
    speed: float,
    ratios: tuple[float, ...],
) -> tuple[np.ndarray, int]:
    """Return (d mu/dt at t0+ in h/dx per tau, passes) after jumps from ``speed`` to ratios of it.

    one : steady sliding at speed, in which mu is constant. NaN behind a dashpot.
    """
    p, surface = one.body.p, space.surface
    if spectrum.viscosity > 0.0:
        return np.full(len(ratios), np.nan), 0
    glass = 1.0 / (1.0 + sum(spectrum.moduli))
    rates, passes = _pushed(space, p > 0.0, surface.slope)
    n, m = p.shape[1], surface.steps_per_spacing
    waves = np.fft.rfft(surface.slope, axis=1) * 2j * np.pi * m * np.fft.rfftfreq(n)
    if n % 2 == 0:
        waves[:, -1] = 0.0  # a sine between the samples: its slope at them is zero
    turning = float(np.sum(p * np.fft.irfft(waves, n, axis=1)))
    stiffening = float(np.sum(rates * surface.slope)) / glass
    return (np.array(ratios) - 1.0) * speed * (stiffening - turning) / float(p.sum()), passes


def _pushed(space: HalfSpace, touching: np.ndarray, push: np.ndarray) -> tuple[np.ndarray, int]:
    """Return (pressures of sum zero on a set, passes): A p is push there, but for a constant.

    Conjugate gradients, to the tolerance of a contact.
    """

    def on_the_set(values: np.ndarray) -> np.ndarray:
        return np.where(touching, values - values[touching].mean(), 0.0)

    found, left = np.zeros_like(push), on_the_set(push)
    turn, squares, passes = left, float(np.sum(left * left)), 0
    enough = TOLERANCE**2 * squares
    while squares > enough and passes < MOST_PASSES:
        pushed = on_the_set(space.operator.displaced(turn, np.empty_like(turn)))
        passes += 1
        step = squares / float(np.sum(turn * pushed))
        found, left = found + step * turn, left - step * pushed
        before, squares = squares, float(np.sum(left * left))
        turn = left + squares / before * turn
    return found, passes
