"""Steady sliding of a half-space: the fixed point of the steps of a march.

Direct solution. In the frame of the surface, a step has the complex compliance B = A J(zeta) for a
wave (response.py), and the gap is g = z + B p - d. Each iteration solves the elastic contact of
heights z + y with the real compliance M = A |J|^2/Re J. At the solution (B - M) p = y; the
difference is the error. Replacing y by (B - M) p multiplies the error by at most |1 - B/M| =
sin(phi), where phi is the loss angle of a step. The error falls faster if y becomes the combination
of the last (B - M) p with the least error on the contact: D. G. Anderson, J. ACM 12, 547 (1965),
doi:10.1145/321296.321305. The tolerance of contacts is proportional to the error. In full contact,
pressures deviate by the error over |B/M| = cos(phi), so that the limit of the error is proportional
to the smallest cos(phi). The result is a fixed point of the march.

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

from ..compile.jit import kernel
from ..model.friction import mean_slope
from ..rheology.law import memory_size
from ..rheology.spectrum import KELVIN, Spectrum, complex_modulus
from .body import CONTACT_TOLERANCE, Body, HalfSpace, Step, rest_on, take_step
from .contact import ElasticContact, press
from .modal_operator import convolved
from .response import steady_response
from .waves import two_sided, wave_numbers

MAX_DIRECT_ERROR = 2e-7  # rms on the contact, over the rms of A p and the smallest cos(phi)
COMBINED = 5  # number of last displacements
FIRST_TOLERANCE = 0.1  # of contacts in a direct solution, relative to the rms of A p
TOLERANCE_PER_ERROR, MIN_TOLERANCE_RATIO = 0.5, 0.1  # over the last error and the last tolerance
STEADY_MU_CHANGE = 1e-6  # relative change of mu per time tau that ends a march
MIN_MU_CHANGE = 1e-9  # error of mu due to CONTACT_TOLERANCE, over the steepest slope
MAX_CONTACT_TOLERANCE = 1e-3  # tolerance of contacts in a march while mu changes fast
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
    space: HalfSpace,
    spectrum: Spectrum,
    speed: float,
    start: Body | None = None,
    variables: int | None = None,
) -> SlidingBody:
    """Return the state of steady sliding at a signed speed (vbar).

    start : warm start, the body at another speed. variables : number of internal variables in the
    memory of the body, slowest first, or None for all; a march keeps all. Raises ValueError
    without convergence.
    """
    surface = space.surface
    step = Step.of(space.form, surface, speed)
    q = wave_numbers(surface.z.shape, surface.steps_per_spacing)[1][0]
    zeta = np.exp(1j * step.direction * q / surface.steps_per_spacing)
    response, memory = steady_response(step.law, memory_size(space.form), zeta)
    memory = memory[:variables]
    full_p = _full_contact_pressures(space, response)
    full = bool(full_p.min() > 0.0)
    if full:
        body, passes = _steady_body(space, memory, full_p, float(surface.z.mean())), 1
    elif spectrum == KELVIN and np.any(np.abs(response.imag) / response.real > MIN_MARCHED_LOSS):
        body, passes = _march(space, step, speed, start)
    else:
        body, passes = _solve_directly(space, response, memory, start)
    step_mu = mean_slope(body.p, step.weight)
    exact = 1.0 if full or spectrum.viscosity > 0.0 else 0.5
    modulus = complex_modulus(spectrum, q * speed)
    squares = exact * np.abs(response) ** 2 + (1.0 - exact) / np.abs(modulus) ** 2
    dissipative_mu = _mu_by_dissipation(space, modulus, squares, body.p)
    viscous = jump_weight(spectrum, surface.steps_per_spacing * speed)
    mu = dissipative_mu + viscous * (step_mu - dissipative_mu)
    # The sum may have the wrong sign if contacts consist of single samples.
    if full or mu * dissipative_mu <= 0.0:
        mu = dissipative_mu
    if space.stepped:
        mu = step_mu
    loss = np.abs(q * modulus.imag * squares)
    return SlidingBody(body, step, mu, step_mu, viscous, passes, loss)


def jump_weight(spectrum: Spectrum, steps: float) -> float:
    """Return the weight of pressure jumps, from 0 to 1; steps : samples per tau, signed."""
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
    fields = np.empty((len(memory), p.size))
    for field, variable in zip(fields, memory, strict=True):
        field[:] = np.fft.irfft2(waves * variable, p.shape).ravel()
    return Body(fields, np.fft.irfft2(waves, p.shape).ravel(), p, d, 0)


def _solve_directly(
    space: HalfSpace, response: np.ndarray, memory: np.ndarray, start: Body | None
) -> tuple[Body, int]:
    """Solve for steady sliding by iterated elastic contacts; return (body, passes).

    response, memory : of steady_response, for every q_x.
    """
    z, compliance = space.surface.z, space.operator.compliance
    symmetric = compliance * (np.abs(response) ** 2 / response.real)
    remainder = compliance * response - symmetric
    operator = space.operator.of_compliance(symmetric)
    contact, y, passes = None, np.zeros_like(z), 0
    if start is not None:
        depth = operator.displaced(start.p, np.empty_like(z))
        contact, passes = ElasticContact(start.p, depth, start.d, 0), 2
        y = convolved(start.p, remainder, operator.modes, y)
    limit = MAX_DIRECT_ERROR * float(np.min(response.real / np.abs(response)))
    tolerance = FIRST_TOLERANCE
    displacements, errors = np.empty((2, COMBINED, *z.shape))
    for iteration in range(MAX_DIRECT_ITERATIONS):
        contact = press(z + y, space.pressure, operator, contact, tolerance)
        passes, contact = passes + contact.passes + 1, contact._replace(passes=0)
        last, known = iteration % COMBINED, min(iteration + 1, COMBINED)
        convolved(contact.p, remainder, operator.modes, displacements[last])
        np.subtract(displacements[last], y, out=errors[last])
        there = errors[:known].reshape(known, -1)[:, np.flatnonzero(contact.p)]
        error = float(there[last].std() / np.sqrt(np.mean(contact.depth**2)))
        if max(error, tolerance) <= limit:
            return _steady_body(space, memory, contact.p, contact.d), passes
        _combine(displacements, _least_error_weights(there, last), y)
        least = max(TOLERANCE_PER_ERROR * limit, MIN_TOLERANCE_RATIO * tolerance)
        tolerance = min(FIRST_TOLERANCE, max(least, TOLERANCE_PER_ERROR * error))
    raise ValueError(
        f"no steady state was found in {MAX_DIRECT_ITERATIONS} iterations: "
        f"the gap is still wrong by {error:.1e} of the depth"
    )


def _least_error_weights(errors: np.ndarray, last: int) -> np.ndarray:
    """Return weights (k,) of sum 1 that minimise the weighted sum of errors (k, samples).

    Means of errors are ignored. last : row of the last error.
    """
    errors = errors - errors.mean(axis=1, keepdims=True)
    differences = errors - errors[last]
    # BLAS would sum in an order that depends on its threads.
    products = np.einsum("ik,jk->ij", differences, differences)
    weights = np.linalg.lstsq(products, -np.einsum("ik,k->i", differences, errors[last]))[0]
    weights[last] = 0.0
    weights[last] = 1.0 - weights.sum()
    return weights


@kernel
def _combine(fields, weights, out):
    """Fill out (rows, n) with the weighted sum of the first fields; weights : shape (k,)."""
    for y in range(out.shape[0]):
        for x in range(out.shape[1]):
            total = 0.0
            for k in range(weights.size):
                total += weights[k] * fields[k, y, x]
            out[y, x] = total


def _march(space: HalfSpace, step: Step, speed: float, start: Body | None) -> tuple[Body, int]:
    """March until mu is steady; return (body, passes). Deviations fall by a factor e in a time tau.

    An element meets the same sample again after a period, and remembers the share exp(-L/(v tau))
    of its state. A constant mu may therefore change again, by this share of its change a period
    ago. It may also be equal at two instants by chance. Convergence therefore requires a small
    range of mu over a time tau, and a small remembered share of its range over a period.
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
