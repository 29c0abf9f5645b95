"""Friction of elements with internal variables: in steady sliding, and at a velocity jump.

*Steady sliding.* The sum of p z' over samples (eq. 5) has an elastic part whose integral is zero.
At low speeds, and at high speeds where the elastomer is glassy, the quadrature error of that part
is many times the friction. The dissipated energy has no such part. In steady sliding every element
bears the same sequence of forces, so that

    mu F_N v = sum_k int lambda_k/J_k (dy_k/dt)^2 dt = - sum_k lambda_k int dp/dt dy_k/dt dt.

The integral over a step includes the next-order term for smooth functions:
(Dp Dy + D2p D2y / 12) / dt, with first and second differences of the samples.

With a dashpot, forces jump at touch-down, which this quadrature does not resolve. For such a
material the sum over samples is more accurate where the loss modulus exceeds the storage modulus
(measured).

*Jump.* With a dashpot, forces follow the velocity at once while displacements are continuous.
Without one the elastomer is glassy at first: forces and friction are continuous and their rates
jump.
"""

import math

import numpy as np

from ..compile.jit import kernel
from ..lines.line import Line
from ..model.friction import lagged_slope, mean_slope, quadrature
from ..rheology.forms import Form
from ..rheology.law import Elements, displacement, law_of, static_pressure
from ..rheology.prony import moments
from ..rheology.retardation import Retardation

MIN_LOSS_SHARE = 1e-3  # smallest weight with which the dissipation estimate is used


def friction_by_loss(
    units: Retardation, form: Form, line: Line, p: np.ndarray, speed: float
) -> tuple[float, float]:
    """Return (mu, contact): friction in h/dx and the share of samples in contact.

    units : the retardation form of the material. form : that of the time scheme, either the same
    or the relaxation form. p (n,) : forces of steady sliding (steady_memory.py), in 4 G dx h.
    speed : vbar, signed.
    mu has the sign of the speed; it is NaN where nothing touches.
    """
    load = float(p.sum())
    contact = float(np.mean(p > 0.0))
    if not load > 0.0:
        return math.nan, contact
    direction = math.copysign(1.0, speed)
    step = 1.0 / (line.steps_per_spacing * abs(speed))
    # Elements pass the samples against the motion of the line.
    in_passing_order = p[::-1] if direction > 0.0 else p
    loss = _period_loss(units, np.ascontiguousarray(in_passing_order), step)
    by_loss = line.steps_per_spacing * loss / load
    share = 1.0 if units.glass > 0.0 else math.exp(-(_loss_tangent(units, 1.0 / step) ** 2))
    if share < MIN_LOSS_SHARE:
        by_loss = 0.0
    by_sum = 0.0 if share == 1.0 else step_friction(form, line, p, speed)
    return direction * share * by_loss + (1.0 - share) * by_sum, contact


def step_friction(form: Form, line: Line, p: np.ndarray, speed: float) -> float:
    """Return mu of steady sliding, averaged over a step (eq. 5); see friction_by_loss."""
    direction = 1 if speed > 0.0 else -1
    lag = law_of(form, 1.0 / (line.steps_per_spacing * abs(speed))).lag
    weight = lagged_slope(np.ascontiguousarray(line.slope[::direction]), lag)[::direction]
    return mean_slope(p, weight)


def _loss_tangent(units: Retardation, omega: float) -> float:
    phase = 1j * omega * units.times
    compliance = units.glass + np.sum(units.compliances / (1.0 + phase))
    return float(-compliance.imag / compliance.real)


@kernel
def _period_loss(units, p, dt):
    """Return the energy that an element dissipates in a period of forces p (n,), dt apart in time.

    Forces are linear between the samples, and the displacements of the units are periodic.
    """
    count, n = units.times.size, p.size
    decay, end, start, x = np.empty((4, count))
    for k in range(count):
        x[k] = dt / units.times[k]
        decay[k], _, at_end, at_start = moments(x[k])
        end[k], start[k] = units.compliances[k] * at_end, units.compliances[k] * at_start
    y, rise, work = np.zeros((3, count))
    for i in range(n):
        new, old = p[i], p[i - 1]
        for k in range(count):
            y[k] = decay[k] * y[k] - (end[k] * new + start[k] * old)
    for k in range(count):
        y[k] /= -math.expm1(-x[k] * n)  # geometric series over all earlier periods
    force_step = 0.0
    for i in range(n + 1):  # a step is integrated once the next one is known
        new, old = p[i % n], p[i - 1]
        bend = (new - old - force_step) / 12.0 if i > 0 else 0.0
        for k in range(count):
            new_y = decay[k] * y[k] - (end[k] * new + start[k] * old)
            new_rise = new_y - y[k]
            work[k] += force_step * rise[k] + bend * (new_rise - rise[k])
            y[k], rise[k] = new_y, new_rise
        force_step = new - old
    return -(work / x).sum()


def friction_jump(form: Form, line: Line, elements: Elements, speed: float, ratio: float) -> float:
    """Return the jump of mu (h/dx) when steady sliding at ``speed`` changes to ``ratio * speed``.

    form : of the material (rheology/forms.py), which must have a dashpot. elements : of steady
    sliding (steady_memory.py). speed : vbar, signed. In contact p = p_0 + eta (v z' + d'), where
    p_0 is the static_pressure. With p_0 in place of d - z this is the quadrature of the Kelvin
    element.
    """
    viscosity, pressure = static_pressure(form, elements.memory)
    law = law_of(form, 1.0 / (line.steps_per_spacing * abs(speed)))
    free = displacement(form, elements.memory, elements.p) + elements.p / law.stiffness
    depth = elements.d - pressure  # height at which a Kelvin element would bear this pressure
    direction, fields = 1 if speed > 0.0 else -1, (depth, line.slope, free + depth - line.z)
    z, slope, w = (np.ascontiguousarray(field[::direction]) for field in fields)
    viscous, load = viscosity * speed, float(elements.p.sum())
    before, _, _ = quadrature(z, slope, w, elements.d, viscous, viscous, load)
    after, _, _ = quadrature(z, slope, w, elements.d, viscous, ratio * viscous, load)
    return after - before


def initial_rate(
    units: Retardation, line: Line, p: np.ndarray, speed: float, ratio: float
) -> float:
    """Return d mu/dt (h/dx per tau) at t0+ after the jump from ``speed`` to ``ratio * speed``.

    p (n,) : forces of steady sliding, in which mu is constant. The rates of the units do not jump.
    A velocity change dv adds dv (z' - mean z')/J_g to the rate of the force of each touching
    element, with the mean over these, and -dv z'' to the rate of its slope. z'' is that of the
    Fourier series. The material must not have a dashpot.
    """
    touching = p > 0.0
    slope = line.slope[touching]
    stiffening = float(np.sum((slope - slope.mean()) ** 2)) / units.glass
    turning = float(np.sum(p * _second_derivative(line)))
    return (ratio - 1.0) * speed * (stiffening - turning) / float(p.sum())


def _second_derivative(line: Line) -> np.ndarray:
    """Return z'' in h/dx^2, shape (n,)."""
    n = line.slope.size
    waves = np.fft.rfft(line.slope) * 2j * np.pi * np.fft.rfftfreq(n) * line.steps_per_spacing
    if n % 2 == 0:
        waves[-1] = 0.0  # the derivative of the shortest cosine vanishes at the samples
    return np.fft.irfft(waves, n)
