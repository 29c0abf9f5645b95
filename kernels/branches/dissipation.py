"""Friction of steady sliding as the energy that the elements lose.

The sum of p z' over samples (eq. 5) has an elastic part that is zero in the integral alone: at
low speeds, and at high ones where the elastomer is glassy, its error is many times what is
left of the friction. The loss has no such part. Every element bears the same force in turn,

    mu F_N v = sum_k int lambda_k/J_k (dy_k/dt)^2 dt = - sum_k lambda_k int dp/dt dy_k/dt dt,

and the integral over a step is taken with its next term for functions that are smooth,
(Dp Dy + D2p D2y / 12) / dt with first and second differences of the samples.

Behind a dashpot forces jump at touch-down, which this cannot resolve. Where such a material
loses more than it stores the sum over samples is the better estimate, by measurement.
"""

import math

import numpy as np

from ..compile.jit import kernel
from ..lines.line import Line
from ..model.friction import lagged_slope, mean_slope
from ..rheology.forms import Form
from ..rheology.law import law_of
from ..rheology.prony import moments
from ..rheology.retardation import Retardation


def friction_by_loss(
    units: Retardation, form: Form, line: Line, p: np.ndarray, speed: float
) -> tuple[float, float]:
    """Return (mu, contact): friction in h/dx and the share of samples in contact.

    units : the retardation form of the material. form : that of the time scheme, the same one
    or the relaxation form. p (n,) : forces of steady sliding (steady_memory.py), in 4 G dx h.
    speed : vbar, signed.
    mu has the sign of the speed; it is NaN where nothing touches.
    """
    load = float(p.sum())
    contact = float(np.mean(p > 0.0))
    if not load > 0.0:
        return math.nan, contact
    way = math.copysign(1.0, speed)
    step = 1.0 / (line.steps_per_spacing * abs(speed))
    # Elements come to the samples from the side that the line moves to.
    met = p[::-1] if way > 0.0 else p
    lost = line.steps_per_spacing * _loss(units, np.ascontiguousarray(met), step) / load
    share = 1.0 if units.glass > 0.0 else math.exp(-(_loss_tangent(units, 1.0 / step) ** 2))
    if share < 1e-3:
        lost = 0.0
    summed = 0.0 if share == 1.0 else step_friction(form, line, p, speed)
    return way * share * lost + (1.0 - share) * summed, contact


def step_friction(form: Form, line: Line, p: np.ndarray, speed: float) -> float:
    """Return mu of steady sliding (eq. 5) as a step of the march gives it; arguments as above."""
    way = 1 if speed > 0.0 else -1
    lag = law_of(form, 1.0 / (line.steps_per_spacing * abs(speed))).lag
    weight = lagged_slope(np.ascontiguousarray(line.slope[::way]), lag)[::way]
    return mean_slope(p, weight)


def _loss_tangent(units: Retardation, omega: float) -> float:
    turn = 1j * omega * units.times
    compliance = units.glass + np.sum(units.compliances / (1.0 + turn))
    return float(-compliance.imag / compliance.real)


@kernel
def _loss(units, p, dt):
    """Return the energy that an element loses in a period of forces p (n,), dt apart in time.

    The units follow forces that are linear between the samples, and have done so for ever.
    """
    count, n = units.times.size, p.size
    decay, end, start, x = np.empty((4, count))
    for k in range(count):
        x[k] = dt / units.times[k]
        decay[k], _, at_end, at_start = moments(x[k])
        end[k], start[k] = units.compliances[k] * at_end, units.compliances[k] * at_start
    y, risen, work = np.zeros((3, count))
    for i in range(n):
        new, old = p[i], p[i - 1]
        for k in range(count):
            y[k] = decay[k] * y[k] - (end[k] * new + start[k] * old)
    for k in range(count):
        y[k] /= -math.expm1(-x[k] * n)  # what periods without end add up to
    grown = 0.0
    for i in range(n + 1):  # the step to a sample is weighed when the next one is known
        new, old = p[i % n], p[i - 1]
        bend = (new - old - grown) / 12.0 if i > 0 else 0.0
        for k in range(count):
            now = decay[k] * y[k] - (end[k] * new + start[k] * old)
            rise = now - y[k]
            work[k] += grown * risen[k] + bend * (rise - risen[k])
            y[k], risen[k] = now, rise
        grown = new - old
    return -(work / x).sum()
