"""Joint fit of all steps: tau, H and q_max from their rates, grad z from their jumps.

Eq. 13 gives the rate k at which friction relaxes at the speed v2 after a step. With s =
log v2, y = log k, Q = log q_max, T = log tau, y(s) is a line with a kink at s_c = -Q - T, where x
= v2 tau q_max = 1:

    y = s + Q - H max(0, s - s_c)                  as in the paper: b = x below x = 1
    y = max(s, s_c) + Q - H max(0, s - s_c)        b = 1 below x = 1, see KineticLaw

For a given kink y is linear in Q and H. All kinks of both laws are therefore tried, each with all Q
and H within three standard errors. A parameter is determined if it is equal in all these fits.
Speeds on only one side of x = 1 determine an exponent and one rate: q_max or tau below, H above.
The kink gives the third parameter.

Source: Li et al. (2014), doi:10.1038/srep05795, eqs. 10 to 16.
"""

from typing import NamedTuple

import numpy as np

from ..kinetic_law import jump_between, normalised_jump
from .estimate import MAX_CHANCE_ERRORS, Estimate
from .parting import measured_steps, no_steps_of
from .record import Record
from .step_fit import MAX_RELATIVE_ERROR, StepFit, fit_step

MIN_RELATIVE_ERROR = 1e-3  # smallest relative standard error of a rate or jump
KINK_SPACING = 2e-3  # spacing of trial kinks between the measured speeds, in log v
KINK_MARGIN = 14.0  # range of trial kinks beyond the measured speeds, in log v
HURST_FRACTIONS = np.linspace(0.0, 1.0, 9)  # trial values of H, as shares of its range at a kink
ZERO_CURVATURE = 1e-12  # relative size below which a quadratic coefficient counts as zero
MAX_HURST_ERROR = 0.15
MIN_LOG_SPEED_GAP = 0.02  # smallest difference of log v between two speeds
TRIAL_SLOPES = np.geomspace(1e-2, 1e4, 20_001)  # trial values of grad z over the largest friction


class Known(NamedTuple):
    """Known parameters in SI units; None: to be fitted."""

    relaxation_time: float | None = None
    hurst: float | None = None
    q_max: float | None = None


class Rates(NamedTuple):
    """Estimates from rates at several speeds; NaN if undetermined."""

    relaxation_time: Estimate  # s
    hurst: Estimate
    q_max: Estimate  # 1/m
    exponent: Estimate  # of the power law of k over v2 through all speeds
    at: float  # m/s, speed at the weighted mean of log v2
    rate: Estimate  # 1/s, k by the power law at the speed ``at``
    time_below_one: bool  # whether the second law, b = 1 below x = 1, fits better
    squares: float  # sum of squares over variances of the better law
    speeds: int


class _Kinks(NamedTuple):
    """Sums of squares a0 + 2 a1 H + a2 H^2 of one law, and Q = q0 + q1 H; arrays over kinks."""

    kink: np.ndarray
    a: tuple[np.ndarray, np.ndarray, np.ndarray]
    q: tuple[np.ndarray, np.ndarray]
    weight: float  # coefficient of Q^2; infinite if Q is given

    def squares(self, h: np.ndarray) -> np.ndarray:
        """Return the sums of squares at given H, shape (kinks, ...)."""
        a0, a1, a2 = (value[:, None] for value in self.a)
        return a0 + 2.0 * a1 * h + a2 * h**2


def fit_rates(fits: list[StepFit], known: Known) -> Rates | None:
    """Fit tau, H and q_max to the rates of steps; return None if no rate is known."""
    usable = [fit for fit in fits if fit.rate.known]
    if not usable:
        return None
    s = np.log([fit.step.v2 for fit in usable])
    y = np.log([fit.rate.value for fit in usable])
    share = [max(fit.rate.error / fit.rate.value, MIN_RELATIVE_ERROR) for fit in usable]
    w = np.array(share) ** -2.0
    laws = [_kinks(s, y, w, known, below) for below in (False, True)]
    bests = [_best(law, known) for law in laws]
    better = int(bests[1][0] < bests[0][0])
    squares, *values = bests[better]
    free = sum(value is None for value in known)
    scatter = max(1.0, squares / max(s.size - free, 1))  # of the rates, at least 1
    ends = np.concatenate(
        [_within(law, squares + MAX_CHANCE_ERRORS**2 * scatter, known) for law in laws]
    )
    errors = np.ptp(ends, axis=0) / (2.0 * MAX_CHANCE_ERRORS)
    h, q, t = (Estimate(*pair) for pair in zip(values, errors, strict=True))
    exponent, at, rate = _power_law(s, y, w)
    return Rates(
        relaxation_time=_exp(t, known.relaxation_time),
        hurst=h.if_below(MAX_HURST_ERROR) if known.hurst is None else Estimate(known.hurst, 0.0),
        q_max=_exp(q, known.q_max),
        exponent=exponent,
        at=at,
        rate=rate,
        time_below_one=bool(better),
        squares=squares,
        speeds=1 + int(np.sum(np.diff(np.sort(s)) > MIN_LOG_SPEED_GAP)),
    )


def _kinks(s: np.ndarray, y: np.ndarray, w: np.ndarray, known: Known, below: bool) -> _Kinks:
    """Return the sums of squares of one law. below : whether b = 1 below x = 1."""
    fine = np.arange(s.min() - 0.5, s.max() + 0.5, KINK_SPACING)
    far = np.arange(0.5, KINK_MARGIN, 0.05)
    c = np.concatenate([s.min() - far[::-1], fine, s.max() + far])
    q_given = None if known.q_max is None else np.full_like(c, np.log(known.q_max))
    if known.relaxation_time is not None:
        if q_given is not None:
            c = np.array([-np.log(known.relaxation_time) - q_given[0]])
        q_given = -c - np.log(known.relaxation_time)
    m = np.maximum(s - c[:, None], 0.0)
    r = y - np.maximum(s, c[:, None] if below else -np.inf) + 0.0 * m
    if q_given is None:
        q0, q1 = (r @ w) / w.sum(), (m @ w) / w.sum()
    else:
        q0, q1 = q_given, np.zeros_like(c)
    r, m = r - q0[:, None], m - q1[:, None]  # residuals are r + H m
    a = ((r * r) @ w, (r * m) @ w, (m * m) @ w)
    return _Kinks(c, a, (q0, q1), float(w.sum()) if q_given is None else np.inf)


def _best(law: _Kinks, known: Known) -> tuple[float, float, float, float]:
    """Return the smallest sum of squares and the H, Q and T at this minimum."""
    _, a1, a2 = law.a
    flat = a2 <= ZERO_CURVATURE * a2.max()
    h = np.clip(np.where(flat, 0.5, -a1 / np.where(flat, 1.0, a2)), 0.0, 1.0)
    if known.hurst is not None:
        h = np.full_like(h, known.hurst)
    squares = law.squares(h[:, None])[:, 0]
    k = int(np.argmin(squares))
    q = law.q[0][k] + h[k] * law.q[1][k]
    return float(squares[k]), float(h[k]), float(q), float(-law.kink[k] - q)


def _within(law: _Kinks, most: float, known: Known) -> np.ndarray:
    """Return extreme H, Q and T with a sum of squares up to ``most``, shape (n, 3)."""
    a0, a1, a2 = law.a
    steep = np.maximum(a2, ZERO_CURVATURE * max(a2.max(), 1.0))
    room = most - a0 + a1**2 / steep
    half = np.sqrt(np.clip(room, 0.0, None) / steep)
    low, high = (np.clip(-a1 / steep + side * half, 0.0, 1.0) for side in (-1.0, 1.0))
    h = low[:, None] + (high - low)[:, None] * HURST_FRACTIONS
    if known.hurst is not None:
        h = np.full_like(h, known.hurst)
    left = most - law.squares(h)
    inside = left >= -1e-9 * most
    spread = np.sqrt(np.clip(left, 0.0, None) / law.weight)
    q = law.q[0][:, None] + h * law.q[1][:, None]
    t = -law.kink[:, None] - q
    ends = [np.stack([h, q + side * spread, t - side * spread], -1) for side in (-1.0, 1.0)]
    return np.concatenate([value[inside] for value in ends])


def _power_law(s: np.ndarray, y: np.ndarray, w: np.ndarray) -> tuple[Estimate, float, Estimate]:
    """Return the exponent of k over v2, and k at the weighted mean of log v2.

    If the rates scatter about the power law by more than their standard errors, the errors are
    enlarged.
    """
    middle, mean = float(w @ s / w.sum()), float(w @ y / w.sum())
    across = float(w @ (s - middle) ** 2)
    if not across > ZERO_CURVATURE * w.sum():
        return Estimate(), float(np.exp(middle)), _exp(Estimate(mean, w.sum() ** -0.5))
    slope = float(w @ ((s - middle) * (y - mean))) / across
    rest = float(w @ (y - mean - slope * (s - middle)) ** 2)
    scatter = np.sqrt(max(1.0, rest / max(s.size - 2, 1)))
    at = _exp(Estimate(mean, scatter * w.sum() ** -0.5))
    return Estimate(slope, float(scatter * across**-0.5)), float(np.exp(middle)), at


def _exp(logarithm: Estimate, given: float | None = None) -> Estimate:
    """Convert the estimate of a logarithm to that of the number; a given number is exact."""
    if given is not None:
        return Estimate(given, 0.0)
    value = float(np.exp(np.clip(logarithm.value, -700.0, 700.0)))
    return Estimate(value, value * logarithm.error).if_below(MAX_RELATIVE_ERROR * value)


def fit_slope(fits: list[StepFit]) -> Estimate:
    """Return grad z from the jumps of steps; NaN if they do not determine it.

    At low speed the jump does not depend on the slope: it is the change of friction (eq. 10).
    """
    usable = [fit for fit in fits if fit.jump.known and fit.jump.error > 0.0 < fit.mu_1.value]
    if not usable:
        return Estimate()
    log_ratio = np.log([fit.step.ratio for fit in usable])
    mu, after = np.array([(fit.mu_1.value, friction_after(fit)) for fit in usable]).T
    jump, error = np.array([fit.jump for fit in usable]).T
    error = np.maximum(error, MIN_RELATIVE_ERROR * np.abs(jump))
    slopes = TRIAL_SLOPES * np.max(mu)
    predicted = jump_between(mu, after, log_ratio, slopes[:, None])
    squares = np.sum(((predicted - jump) / error) ** 2, axis=1)
    least = squares.min()
    scatter = max(1.0, least / max(mu.size - 1, 1))
    inside = np.log(slopes[squares <= least + MAX_CHANCE_ERRORS**2 * scatter])
    value = float(slopes[np.argmin(squares)])
    share = float(np.ptp(inside)) / (2.0 * MAX_CHANCE_ERRORS)
    return Estimate(value, value * share).if_below(MAX_RELATIVE_ERROR * value)


def friction_after(fit: StepFit) -> float:
    """Return mu_2 if the step determines it and it is positive, else mu_1, which is close to it."""
    known = fit.mu_2.known and fit.mu_2.value > 0.0
    return fit.mu_2.value if known else fit.mu_1.value


def predicted_jump(mu: np.ndarray, slope: float) -> np.ndarray:
    """Return the jump over ln(v2/v1) of a small step at the friction mu (eq. 12)."""
    return slope * normalised_jump(mu / slope)


class Fit(NamedTuple):
    """Estimates of the kinetic law and of state laws from records."""

    steps: list[StepFit]  # by eq. 6, which is Ruina's law
    ageing: list[StepFit]  # the same steps by Dieterich's law
    rates: Rates | None  # None if no step determines its rate
    slope: Estimate  # grad z
    known: Known
    description: tuple[str, ...] = ()  # descriptions of the files, in sentences


def fit_records(
    records: list[Record],
    known: Known,
    window: float | None = None,
    stiffness: float | None = None,
) -> Fit:
    """Fit all velocity steps of the records.

    known : known parameters, ``Known()`` for none. window : time used after each step, s.
    stiffness : spring constant of the machine over the normal force (1/m); None: rigid. Raises
    UserError for a record without a step, or with too few samples after it.
    """
    steps = [step for record in records for step in measured_steps(record, window)]
    fits = [fit_step(step, stiffness=stiffness) for step in steps]
    return Fit(
        steps=fits,
        ageing=[fit_step(step, "dieterich", stiffness) for step in steps],
        rates=fit_rates(fits, known),
        slope=fit_slope(fits),
        known=known,
        description=tuple(
            line for one in records for line in (*one.description, *no_steps_of(one))
        ),
    )
