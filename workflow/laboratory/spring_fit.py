"""Fit of one velocity step of a compliant machine, whose spring is part of the model.

The record holds the velocity V of the load point. A spring of stiffness k, in units of the normal
force (1/m), connects it to the slider, whose velocity is v:

    d mu/dt = k (V - v)                       the spring, without inertia
    mu = mu_1 + a ln(v/v1) + b phi            with phi = ln(v1 theta/D_c), see rate_state.py

v follows from mu and phi, and scipy's ``solve_ivp`` integrates both from steady sliding at v1.
``least_squares`` fits mu_1, ln a, b, ln D_c and the moment of the step. The moment is constrained
to the time in which the velocity changed: for a stiff machine a later step and a larger a give the
same friction, so the data alone do not separate them. For an infinitely stiff machine the model
becomes eq. 6.

Source: C. Marone, Annu. Rev. Earth Planet. Sci. 26, 643 (1998),
doi:10.1146/annurev.earth.26.1.643, eqs. 3 to 6.
"""

import math
from typing import NamedTuple

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import least_squares

from ..reduce import state_change
from .estimate import Estimate, correlation_factor, mean
from .parting import MeasuredStep

LENGTH_TRIALS = np.array([0.01, 0.1, 0.5])  # of D_c over the distance slid after the step
DIRECT_EFFECT_TRIALS = np.array([0.5, 2.0])  # of a ln(v2/v1) over the largest change of friction
MAX_LOG_VELOCITY = 40.0  # largest |ln(v/v1)|
INTEGRATION_TOLERANCE = 1e-7  # relative tolerance of the integration
COARSE_SAMPLES = 200  # approximate number of samples on which starts are compared
MAX_SPRING_EVALUATIONS = 60  # largest number of evaluations in a fit


class Sprung(NamedTuple):
    """The fit of a step behind a spring."""

    curve: np.ndarray  # friction by the fit at ``step.time``
    residual: np.ndarray  # fit minus data
    factor: float  # factor of variances due to correlated noise
    mu_1: Estimate
    levels: dict[str, Estimate]  # mu_2; jump: a ln(v2/v1), if stiff; amplitude: b ln(v2/v1)
    log_length: Estimate  # of D_c in m


def fit_behind_spring(step: MeasuredStep, law: str, stiffness: float) -> Sprung:
    """Fit one step. law : "ruina" or "dieterich". stiffness : 1/m."""
    before = mean(step.before)
    size = max(before.error, 1e-12)  # error of mu_1 from sliding before the step
    spread = step.change / math.sqrt(12.0)  # standard deviation of a moment uniform in the change

    def residual(p: np.ndarray, every: int = 1) -> np.ndarray:
        after = step.after[::every]
        curve = _curve(p, step, step.time[::every], law, stiffness)
        noise = max(float(np.std(np.diff(after))) / math.sqrt(2.0), 1e-12)
        known = ((p[0] - before.value) / size, p[4] / spread)
        return np.append((curve - after) / noise, known)

    low, high = _bounds(step)
    starts = [np.clip(p, low, high) for p in _starts(step, before.value)]
    coarse = max(step.time.size // COARSE_SAMPLES, 1)
    start = min(starts, key=lambda p: float(np.sum(residual(p, coarse) ** 2)))
    options = {"bounds": (low, high), "x_scale": "jac", "diff_step": 1e-5}
    start = least_squares(
        lambda p: residual(p, coarse), start, max_nfev=MAX_SPRING_EVALUATIONS, **options
    ).x
    solution = least_squares(residual, start, max_nfev=MAX_SPRING_EVALUATIONS, **options)
    curve = _curve(solution.x, step, step.time, law, stiffness)
    rest = curve - step.after
    factor = correlation_factor(rest)
    variance = (
        factor * float(solution.fun @ solution.fun) / max(step.time.size - solution.x.size, 1)
    )
    covariance = variance * np.linalg.pinv(solution.jac.T @ solution.jac, hermitian=True)
    p, log_ratio, a = solution.x, math.log(step.ratio), math.exp(solution.x[1])
    requested = {
        "mu_1": (p[0], [1.0, 0.0, 0.0]),
        "mu_2": (p[0] + (a - p[2]) * log_ratio, [1.0, a * log_ratio, -log_ratio]),
        "amplitude": (p[2] * log_ratio, [0.0, 0.0, log_ratio]),
        "jump": (a * log_ratio, [0.0, a * log_ratio, 0.0]),
    }
    levels = {
        name: Estimate(float(value), math.sqrt(np.array(weights) @ covariance[:3, :3] @ weights))
        for name, (value, weights) in requested.items()
    }
    log_length = Estimate(float(p[3]), math.sqrt(covariance[3, 3]))
    return Sprung(curve, rest, factor, levels.pop("mu_1"), levels, log_length)


def _bounds(step: MeasuredStep) -> tuple[np.ndarray, np.ndarray]:
    """Return the bounds of mu_1, ln a, b, ln D_c (m) and the moment of the step (s)."""
    size = float(np.ptp(np.concatenate([step.before, step.after]))) / abs(math.log(step.ratio))
    least, most = step.v2 * (step.time[1] - step.time[0]) / 30.0, 30.0 * step.v2 * step.time[-1]
    half = 0.5 * step.change
    low = [-np.inf, math.log(1e-3 * size), -100.0 * size, math.log(least), -half]
    high = [np.inf, math.log(1e2 * size), 100.0 * size, math.log(most), half]
    return np.array(low), np.array(high)


def _starts(step: MeasuredStep, mu_1: float) -> list[np.ndarray]:
    log_ratio = math.log(step.ratio)
    size = max(float(np.max(np.abs(step.after - mu_1))), 1e-12) / abs(log_ratio)
    late = float(step.after[-max(step.after.size // 5, 1) :].mean())
    return [
        np.array([mu_1, math.log(a), a - (late - mu_1) / log_ratio, math.log(length), 0.0])
        for a in DIRECT_EFFECT_TRIALS * size
        for length in LENGTH_TRIALS * step.v2 * step.time[-1]
    ]


def _curve(
    p: np.ndarray, step: MeasuredStep, t: np.ndarray, law: str, stiffness: float
) -> np.ndarray:
    """Return friction at times t after the step. p : mu_1, ln a, b, ln D_c, moment of the step."""
    mu_1, log_a, b, log_length, moment = p
    a, length = math.exp(log_a), math.exp(log_length)

    def change(_: float, y: np.ndarray) -> list[float]:
        log_v = min(max((y[0] - b * y[1]) / a, -MAX_LOG_VELOCITY), MAX_LOG_VELOCITY)  # of v/v1
        v = step.v1 * math.exp(log_v)
        return [stiffness * (step.v2 - v), state_change(law, y[1], log_v) * step.v1 / length]

    times = np.maximum(t - moment, 0.0)
    span = (0.0, float(times[-1]))
    solution = solve_ivp(
        change, span, [0.0, 0.0], "LSODA", times, rtol=INTEGRATION_TOLERANCE, atol=1e-9
    )
    if solution.y.shape[1] < t.size:
        return np.full(t.size, 1e3)  # unphysical: return a value far from any data
    return mu_1 + solution.y[0]
