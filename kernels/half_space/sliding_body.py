"""Steady sliding: the state that a step of the march leaves as it is, found with or without it.

Directly: in the frame of the surface a step's compliance for a wave is A J(zeta), complex
(response.py), so that the contact is g = z + B p - d, B = A J. An elastic contact with
M = A |J|^2/Re J is solved, and the rest B - M of the pressures before counts as height: every
turn takes the error times |1 - B/M| = sin(phi) at most, phi the loss angle of a step. Both end
at the same state, so that a march from it stands still.

By marching, where phi is large: the body forgets its start as exp(-t/tau).

The sum of p dz/dx over the samples of a step has an elastic part that is zero in the integral
alone: at low speeds, and where the elastomer is hardly viscous, it drowns what is left. What is
lost has none,

    mu sigma_0 = sum A q_x E*''(q_x v) |J|^2 |p_q|^2,

with |J|^2 of the step where displacements are taken for exact, as in full contact and beside a
dashpot, and 1/|E*|^2 where pressures are; else the mean of both is taken. Where a step is viscous
pressures jump at the edges of contacts, and the sum is better. All that by measurement.
"""

import math
from typing import NamedTuple

import numpy as np

from ..model.friction import mean_slope
from ..rheology.law import memory_size
from ..rheology.spectrum import KELVIN, Spectrum, complex_modulus
from .body import TOLERANCE, Body, HalfSpace, Step, rest_on, take_step
from .contact import ElasticContact, Operator, press
from .response import steady_response
from .waves import two_sided, wave_numbers

SETTLED = 1e-6  # change of mu, relative to it, in a turn or in a time tau, that ends the search
LEAST = 1e-9  # the same, relative to the steepest slope: what the tolerance of a contact leaves
TURNS, BLOCKS = 500, 100  # at most: of the direct solution, and times tau of the march
FLAT = 1.0  # tangent of the loss angle from which a dashpot is marched


class SlidingBody(NamedTuple):
    """A body under steady sliding."""

    body: Body
    step: Step
    mu: float  # in h/dx
    step_mu: float  # the same, as a step of the march gives it
    viscous: float  # from 0 to 1: how far pressures jump where a contact begins
    passes: int


def slide_steadily(
    space: HalfSpace, spectrum: Spectrum, speed: float, start: Body | None = None
) -> SlidingBody:
    """Return the state of steady sliding at a signed speed (vbar).

    start : of another speed, for its pressures. Raises ValueError where it is not found.
    """
    surface = space.surface
    step = Step.of(space.form, surface, speed)
    q = wave_numbers(surface.z.shape, surface.steps_per_spacing)[1][0]
    zeta = np.exp(1j * step.way * q / surface.steps_per_spacing)
    response, memory = steady_response(step.law, memory_size(space.form), zeta)
    full = _everywhere(space, response)
    everywhere = bool(full.min() > 0.0)
    if everywhere:
        body, passes = _carried(space, memory, full, float(surface.z.mean())), 1
    elif spectrum == KELVIN and float(np.max(np.abs(response.imag) / response.real)) > FLAT:
        body, passes = _marched(space, step, speed, start)
    else:
        body, passes = _direct(space, step, response, memory, start)
    step_mu = mean_slope(body.p, step.weight)
    exact = 1.0 if everywhere or spectrum.viscosity > 0.0 else 0.5
    lost = _lost(space, complex_modulus(spectrum, q * speed), response, exact, body.p)
    viscous = _viscous(spectrum, surface.steps_per_spacing * speed)
    mu = lost if everywhere else lost + viscous * (step_mu - lost)
    if mu * lost <= 0.0:  # contacts of single samples: sliding takes work all the same
        mu = lost
    return SlidingBody(body, step, mu, step_mu, viscous, passes)


def _viscous(spectrum: Spectrum, steps: float) -> float:
    """Return how viscous a step is, from 0 to 1; steps : per tau, of either sign."""
    if spectrum.viscosity == 0.0:
        return 0.0
    modulus = complex(complex_modulus(spectrum, np.array(abs(steps))))
    return -math.expm1(-((modulus.imag / modulus.real) ** 2))


def _lost(
    space: HalfSpace, modulus: np.ndarray, response: np.ndarray, exact: float, p: np.ndarray
) -> float:
    """Return mu by what is lost (h/dx).

    modulus : E*(q_x v) for every q_x. exact : share of the estimate that takes displacements for
    exact.
    """
    q = wave_numbers(p.shape, space.surface.steps_per_spacing)[1][0]
    squares = exact * np.abs(response) ** 2 + (1.0 - exact) / np.abs(modulus) ** 2
    power = np.abs(np.fft.rfft2(p) / p.size) ** 2 * space.operator.compliance
    return float((power.sum(axis=0) * two_sided(p.shape) * q * modulus.imag * squares).sum()) / (
        space.pressure
    )


def _settled(change: float, mu: float) -> bool:
    """Return whether friction stands still, both relative to the steepest slope."""
    return change < max(SETTLED * abs(mu), LEAST)


def _closely(change: float) -> float:
    """Return how closely to solve contacts while mu still moves by so much."""
    return max(TOLERANCE, min(1e-3, change))


def _everywhere(space: HalfSpace, response: np.ndarray) -> np.ndarray:
    """Return the pressures of steady sliding in full contact, negative where there is none."""
    z = space.surface.z
    inverse = np.zeros_like(space.operator.compliance, complex)
    inverse.ravel()[1:] = 1.0 / (space.operator.compliance * response).ravel()[1:]
    return space.pressure - np.fft.irfft2(np.fft.rfft2(z) * inverse, z.shape)


def _carried(space: HalfSpace, memory: np.ndarray, p: np.ndarray, d: float) -> Body:
    """Return the body that carries pressures along; memory : of steady_response."""
    waves = np.fft.rfft2(p) * space.operator.compliance
    fields = [np.fft.irfft2(waves * each, p.shape).ravel() for each in memory]
    return Body(np.array(fields), np.fft.irfft2(waves, p.shape).ravel(), p, d, 0)


def _direct(
    space: HalfSpace, step: Step, response: np.ndarray, memory: np.ndarray, start: Body | None
) -> tuple[Body, int]:
    """Solve symmetric contacts in turn, return (body, passes).

    response, memory : of steady_response for every q_x.
    """
    z, shape, compliance = space.surface.z, space.surface.z.shape, space.operator.compliance
    symmetric = compliance * (np.abs(response) ** 2 / response.real)
    rest = compliance * response - symmetric
    operator = Operator.inverse(symmetric, shape[1])
    passes, tolerance, mu, gap, found = 0, _closely(math.inf), math.inf, z, None
    if start is not None:
        depth = operator.displaced(start.p, np.empty(shape))
        found, passes = ElasticContact(start.p, depth, start.d, 0), 1
    steepest = float(np.abs(space.surface.slope).max())
    for _ in range(TURNS):
        if found is not None:
            gap = z + np.fft.irfft2(np.fft.rfft2(found.p) * rest, shape)
            found, passes = found._replace(passes=0), passes + 1
        found = press(gap, space.pressure, operator, found, tolerance)
        passes += found.passes
        new = mean_slope(found.p, step.weight)
        change, mu = abs(new - mu) / steepest, new
        if _settled(change, mu / steepest) and tolerance == TOLERANCE:
            return _carried(space, memory, found.p, found.d), passes
        tolerance = _closely(change)
    raise ValueError(f"no steady state was found in {TURNS} turns: mu still moves by {change:.1e}")


def _marched(space: HalfSpace, step: Step, speed: float, start: Body | None) -> tuple[Body, int]:
    """March until mu stands still, return (body, passes): what is left falls by e in a time tau.

    An element meets the same sample again after a period, and remembers exp(-L/(v tau)) of it: mu
    is quiet before it changes by that share of its change a period ago. It can also be the same at
    two instants by chance. So what has to be small is the range of mu in a time tau, and what is
    remembered of its range in a period.
    """
    surface, passes = space.surface, 0
    steepest = float(np.abs(surface.slope).max())
    if start is None:
        start, passes = rest_on(space)
    body = start._replace(memory=start.memory.copy())
    period, forgetting = surface.z.shape[1], surface.steps_per_spacing * abs(speed)
    block, remembered = max(4, math.ceil(forgetting)), math.exp(-period / forgetting)
    mu, change = [mean_slope(body.p, step.weight)], math.inf
    for _ in range(BLOCKS):
        tolerance = _closely(change)
        for _ in range(block):
            body, used = take_step(space, body, step, tolerance)
            passes += used
            mu.append(mean_slope(body.p, step.weight))
        moved = max(np.ptp(mu[-block - 1 :]), remembered * np.ptp(mu[-period - 1 :]))
        change = float(moved) / steepest
        if _settled(change, mu[-1] / steepest):
            # The contact that a jump begins with.
            body, used = take_step(space, body, step, TOLERANCE)
            return body, passes + used
    raise ValueError(f"no steady state was found in {BLOCKS} tau: mu still moves by {change:.1e}")
