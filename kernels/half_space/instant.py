"""Friction just after a velocity jump: displacements are continuous, and their rates jump.

With a dashpot, pressures follow the velocity at once. Let f be the part of A p that does not depend
on rates, and eta the viscosity. Then on the samples that touch

    A p = f - eta du/dt,    du/dt = -(v dz/dx + d'),    p >= 0,

and p = 0 elsewhere: a contact problem restricted to these samples. Without a dashpot, mu is
continuous and its rate jumps. If the velocity changes by dv, the rate dp/dt of the pressures on
these samples changes according to J_g A dp/dt = dv dz/dx + dd', where J_g is the glassy compliance.
"""

import numpy as np

from ..model.friction import mean_slope
from ..rheology.spectrum import Spectrum
from .body import CONTACT_TOLERANCE, HalfSpace, at_samples, lasting_depth
from .contact import MAX_PASSES, ElasticContact, press
from .patches import real_contact
from .sliding_body import SlidingBody
from .tiles import quadratic_density, tile_sums


def friction_jumps(
    space: HalfSpace,
    spectrum: Spectrum,
    one: SlidingBody,
    speed: float,
    ratios: tuple[float, ...],
    tiles: int = 0,
) -> tuple[np.ndarray, np.ndarray, int, np.ndarray]:
    """Return (jumps of mu in h/dx, jumps of real contact over L^2, passes, sums over tiles).

    The velocity jumps from ``speed`` to each of ``ratios`` times ``speed``.

    one : steady sliding at ``speed`` (vbar, signed); with a dashpot its memory must be complete.
    tiles : per side. With constant contacts A dp = -eta dv dz/dx + const, so that the jump is a
    quadratic form of dp (tiles.py). The sums have the shape (ratios, tiles, tiles).
    """
    if spectrum.viscosity == 0.0:
        none = np.zeros(len(ratios))
        return none, none, 0, np.zeros((len(ratios), tiles, tiles))
    body, slope = one.body, space.surface.slope
    viscosity, lasting = lasting_depth(space.form, body.memory)
    lasting = at_samples(lasting, body.offset, slope.shape)
    touching = body.p > 0.0
    mu, areas, passes, pressures = [], [], 0, []
    contact = ElasticContact(body.p, at_samples(body.depth, body.offset, slope.shape), 0.0, 0)
    for ratio in (1.0, *ratios):
        gap = -(lasting + viscosity * ratio * speed * slope)
        start = contact._replace(d=float(gap[touching].mean()), passes=0)
        contact = press(gap, space.pressure, space.operator, start, CONTACT_TOLERANCE, touching)
        passes += contact.passes
        mu.append(mean_slope(contact.p, slope))
        areas.append(real_contact(contact.p, one.viscous))
        pressures += [contact.p.copy()] if tiles else []
    sums = np.empty((len(ratios), tiles, tiles))
    for k, after in enumerate(pressures[1:]):
        change = quadratic_density(after - pressures[0], space.operator.compliance)
        sums[k] = tile_sums(change, tiles)
    return np.array(mu[1:]) - mu[0], np.array(areas[1:]) - areas[0], passes, sums


def initial_rates(
    space: HalfSpace,
    spectrum: Spectrum,
    one: SlidingBody,
    speed: float,
    ratios: tuple[float, ...],
) -> tuple[np.ndarray, int]:
    """Return (d mu/dt at t0+ in h/dx per tau, passes) for the same jumps as ``friction_jumps``.

    one : steady sliding at ``speed``, with constant mu. Rates are NaN with a dashpot.
    """
    p, surface = one.body.p, space.surface
    if spectrum.viscosity > 0.0:
        return np.full(len(ratios), np.nan), 0
    glass = 1.0 / (1.0 + sum(spectrum.moduli))
    rates, passes = _pressures_for(space, p > 0.0, surface.slope)
    n, m = p.shape[1], surface.steps_per_spacing
    waves = np.fft.rfft(surface.slope, axis=1) * 2j * np.pi * m * np.fft.rfftfreq(n)
    if n % 2 == 0:
        waves[:, -1] = 0.0  # the derivative of the wave of two samples is zero at samples
    curving = float(np.sum(p * np.fft.irfft(waves, n, axis=1)))
    stiffening = float(np.sum(rates * surface.slope)) / glass
    return (np.array(ratios) - 1.0) * speed * (stiffening - curving) / float(p.sum()), passes


def _pressures_for(
    space: HalfSpace, touching: np.ndarray, depth: np.ndarray
) -> tuple[np.ndarray, int]:
    """Return (pressures on the touching samples, passes) with A p = depth + constant there.

    The pressures have sum zero. They are found by conjugate gradients, to CONTACT_TOLERANCE.
    """

    def centred_on_contact(values: np.ndarray) -> np.ndarray:
        return np.where(touching, values - values[touching].mean(), 0.0)

    p, residual = np.zeros_like(depth), centred_on_contact(depth)
    direction, squares, passes = residual, float(np.sum(residual * residual)), 0
    limit = CONTACT_TOLERANCE**2 * squares
    while squares > limit and passes < MAX_PASSES:
        moved = space.operator.displaced(direction, np.empty_like(direction))
        moved = centred_on_contact(moved)
        passes += 1
        step = squares / float(np.sum(direction * moved))
        p, residual = p + step * direction, residual - step * moved
        before, squares = squares, float(np.sum(residual * residual))
        direction = residual + squares / before * direction
    return p, passes
