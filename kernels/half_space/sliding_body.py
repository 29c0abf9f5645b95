"""Steady sliding of a half-space: the fixed point of the steps of a march.

Direct solution. In the frame of the surface, a step has the complex compliance B = A J(zeta) for a
wave (response.py), and the gap is g = z + B p - d. Each iteration solves an elastic contact with
the real compliance M = A |J|^2/Re J and adds the displacement (B - M) p of the last pressures to
the heights. It multiplies the error by at most |1 - B/M| = sin(phi), where phi is the loss angle of
a step. The result is a fixed point of the march.

March. It is used for Kelvin elements if phi is large. The body forgets its start as exp(-t/tau).

Friction. The sum of p dz/dx over the samples has an elastic part, which vanishes only in the
integral. At low speeds and for nearly elastic materials, this part exceeds the rest. The dissipated
power does not contain it:

    mu sigma_0 = sum A q_x E*''(q_x v) |J|^2 |p_q|^2,

with |J|^2 of the step if displacements are considered exact, as in full contact or with a dashpot.
Otherwise |J|^2 is replaced by its mean with 1/|E*|^2, which holds for exact pressures. In a viscous
step, pressures jump at the edges of contacts and the sum is used. These choices are empirical.
"""

import math
from typing import NamedTuple

import numpy as np

from ..model.friction import mean_slope
from ..rheology.law import memory_size
from ..rheology.spectrum import KELVIN, Spectrum, complex_modulus
from .body import CONTACT_TOLERANCE, Body, HalfSpace, Step, rest_on, take_step
from .contact import ElasticContact, Operator, press
from .response import steady_response
from .waves import two_sided, wave_numbers

STEADY_MU_CHANGE = 1e-6  # relative change of mu per iteration or time tau that ends the search
MIN_MU_CHANGE = 1e-9  # error of mu due to CONTACT_TOLERANCE, over the steepest slope
MAX_CONTACT_TOLERANCE = 1e-3  # tolerance of contacts while mu changes fast
MAX_DIRECT_ITERATIONS = 500
MAX_MARCH_TAUS = 100  # duration of a march, in tau
MIN_MARCHED_LOSS = 1.0  # tangent of the loss angle above which Kelvin elements are marched


class SlidingBody(NamedTuple):
    """A body in steady sliding."""

    body: Body
    step: Step
    mu: float  # in h/dx
    step_mu: float  # mu as summed over the samples of a step, in h/dx
    viscous: float  # weight of pressure jumps at leading edges, from 0 to 1
    passes: int  # of the operator
    loss: np.ndarray  # weights of |p_q|^2 / A in the dissipated power, for every q_x


def slide_steadily(
    space: HalfSpace, spectrum: Spectrum, speed: float, start: Body | None = None
) -> SlidingBody:
    """Return the state of steady sliding at a signed speed (vbar).

    start : warm start, the body at another speed. Raises ValueError without convergence.
    """
    surface = space.surface
    step = Step.of(space.form, surface, speed)
    q = wave_numbers(surface.z.shape, surface.steps_per_spacing)[1][0]
    zeta = np.exp(1j * step.direction * q / surface.steps_per_spacing)
    response, memory = steady_response(step.law, memory_size(space.form), zeta)
    full_p = _full_contact_pressures(space, response)
    full = bool(full_p.min() > 0.0)
    if full:
        body, passes = _steady_body(space, memory, full_p, float(surface.z.mean())), 1
    elif spectrum == KELVIN and np.any(np.abs(response.imag) / response.real > MIN_MARCHED_LOSS):
        body, passes = _march(space, step, speed, start)
    else:
        body, passes = _solve_directly(space, step, response, memory, start)
    step_mu = mean_slope(body.p, step.weight)
    exact = 1.0 if full or spectrum.viscosity > 0.0 else 0.5
    modulus = complex_modulus(spectrum, q * speed)
    squares = exact * np.abs(response) ** 2 + (1.0 - exact) / np.abs(modulus) ** 2
    dissipative_mu = _mu_by_dissipation(space, modulus, squares, body.p)
    viscous = _jump_weight(spectrum, surface.steps_per_spacing * speed)
    mu = dissipative_mu + viscous * (step_mu - dissipative_mu)
    # The sum may have the wrong sign if contacts consist of single samples.
    if full or mu * dissipative_mu <= 0.0:
        mu = dissipative_mu
    loss = np.abs(q * modulus.imag * squares)
    return SlidingBody(body, step, mu, step_mu, viscous, passes, loss)


def _jump_weight(spectrum: Spectrum, steps: float) -> float:
    """Return the weight of pressure jumps, from 0 to 1; steps : number per tau, signed."""
    if spectrum.viscosity == 0.0:
        return 0.0
    modulus = complex(complex_modulus(spectrum, np.array(abs(steps))))
    return -math.expm1(-((modulus.imag / modulus.real) ** 2))


def _mu_by_dissipation(
    space: HalfSpace, modulus: np.ndarray, squares: np.ndarray, p: np.ndarray
) -> float:
    """Return mu (h/dx) from the dissipated power.

    modulus, squares : E*(q_x v) and mean |J|^2 for every q_x.
    """
    q = wave_numbers(p.shape, space.surface.steps_per_spacing)[1][0]
    power = (np.abs(np.fft.rfft2(p) / p.size) ** 2 * space.operator.compliance).sum(axis=0)
    lost = (power * two_sided(p.shape) * q * modulus.imag * squares).sum()
    return float(lost) / space.pressure


def _is_steady(change: float, mu: float) -> bool:
    """Return whether friction is steady; change, mu : relative to the steepest slope."""
    return change < max(STEADY_MU_CHANGE * abs(mu), MIN_MU_CHANGE)


def _tolerance_at(change: float) -> float:
    """Return the tolerance of contacts while mu changes by ``change``."""
    return max(CONTACT_TOLERANCE, min(MAX_CONTACT_TOLERANCE, change))


def _full_contact_pressures(space: HalfSpace, response: np.ndarray) -> np.ndarray:
    """Return the pressures of steady sliding in full contact, which must all be positive."""
    z = space.surface.z
    inverse = np.zeros_like(space.operator.compliance, complex)
    inverse.ravel()[1:] = 1.0 / (space.operator.compliance * response).ravel()[1:]
    return space.pressure - np.fft.irfft2(np.fft.rfft2(z) * inverse, z.shape)


def _steady_body(space: HalfSpace, memory: np.ndarray, p: np.ndarray, d: float) -> Body:
    """Return the body under steadily travelling pressures; memory : of steady_response."""
    waves = np.fft.rfft2(p) * space.operator.compliance
    fields = [np.fft.irfft2(waves * variable, p.shape).ravel() for variable in memory]
    return Body(np.array(fields), np.fft.irfft2(waves, p.shape).ravel(), p, d, 0)


def _solve_directly(
    space: HalfSpace, step: Step, response: np.ndarray, memory: np.ndarray, start: Body | None
) -> tuple[Body, int]:
    """Solve for steady sliding by iterated elastic contacts; return (body, passes).

    response, memory : of steady_response, for every q_x.
    """
    z, shape, compliance = space.surface.z, space.surface.z.shape, space.operator.compliance
    symmetric = compliance * (np.abs(response) ** 2 / response.real)
    remainder = compliance * response - symmetric
    operator = Operator.inverse(symmetric, shape[1])
    passes, tolerance, mu = 0, _tolerance_at(math.inf), math.inf
    gap, contact = z, None
    if start is not None:
        depth = operator.displaced(start.p, np.empty(shape))
        contact, passes = ElasticContact(start.p, depth, start.d, 0), 1
    steepest = float(np.abs(space.surface.slope).max())
    for _ in range(MAX_DIRECT_ITERATIONS):
        if contact is not None:
            gap = z + np.fft.irfft2(np.fft.rfft2(contact.p) * remainder, shape)
            contact, passes = contact._replace(passes=0), passes + 1
        contact = press(gap, space.pressure, operator, contact, tolerance)
        passes += contact.passes
        new = mean_slope(contact.p, step.weight)
        change, mu = abs(new - mu) / steepest, new
        if _is_steady(change, mu / steepest) and tolerance == CONTACT_TOLERANCE:
            return _steady_body(space, memory, contact.p, contact.d), passes
        tolerance = _tolerance_at(change)
    raise ValueError(
        f"no steady state was found in {MAX_DIRECT_ITERATIONS} iterations: "
        f"mu still changes by {change:.1e}"
    )


def _march(space: HalfSpace, step: Step, speed: float, start: Body | None) -> tuple[Body, int]:
    """March until mu is steady; return (body, passes). Deviations fall by a factor e in a time tau.

    An element meets the same sample again after a period, and remembers the share exp(-L/(v tau))
    of its state. After a constant phase, mu may therefore change by this share of its change a
    period ago. It may also be equal at two instants by chance. Convergence therefore requires a
    small range of mu over a time tau, and a small remembered share of its range over a period.
    """
    surface, passes = space.surface, 0
    steepest = float(np.abs(surface.slope).max())
    if start is None:
        start, passes = rest_on(space)
    body = start._replace(memory=start.memory.copy())
    period, forgetting = surface.z.shape[1], surface.steps_per_spacing * abs(speed)
    block, remembered = max(4, math.ceil(forgetting)), math.exp(-period / forgetting)
    mu, change = [mean_slope(body.p, step.weight)], math.inf
    for _ in range(MAX_MARCH_TAUS):
        tolerance = _tolerance_at(change)
        for _ in range(block):
            body, used = take_step(space, body, step, tolerance)
            passes += used
            mu.append(mean_slope(body.p, step.weight))
        moved = max(np.ptp(mu[-block - 1 :]), remembered * np.ptp(mu[-period - 1 :]))
        change = float(moved) / steepest
        if _is_steady(change, mu[-1] / steepest):
            # Jumps start from this contact.
            body, used = take_step(space, body, step, CONTACT_TOLERANCE)
            return body, passes + used
    raise ValueError(
        f"no steady state was found in {MAX_MARCH_TAUS} tau: mu still changes by {change:.1e}"
    )
