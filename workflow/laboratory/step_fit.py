"""Fit of one velocity step by eq. 6, which is Ruina's law, or by Dieterich's law.

One step determines the friction before and after, the jump, and one rate k = b/tau. A state law has
the equivalent constants a = jump/ln r, b = amplitude/ln r, D_c = v2/k with r = v2/v1.

For a given rate the model mu_2 + b g(k t) is linear. Many rates are tried, and the best one is
refined by scipy's ``least_squares``. All rates whose sum of squares exceeds the minimum by less
than nine variances are compatible with the data within three standard errors. If the rate is
undetermined, e.g. because nothing relaxes or the record is too short, errors include all compatible
rates. The variance is that of the residual, times the factor for correlated noise.

Source: Li et al. (2014), doi:10.1038/srep05795, eqs. 6 and 8; the laws are in
workflow/reduce/rate_state.py.
"""

import math
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from scipy.optimize import least_squares

from ..reduce import step_law
from .estimate import MAX_CHANCE_ERRORS, Estimate, correlation_factor, mean, noise_of
from .parting import MeasuredStep
from .spring_fit import fit_behind_spring

TRIAL_RATES = 80  # number of trial rates
MIN_RATE_TIMES_SPAN = 0.1  # rate times recorded time; slower relaxation is a straight line
MAX_RATE_TIMES_INTERVAL = 1.0  # times the sampling interval; faster is part of the jump
MIN_DRIFT_SHARE = 0.1  # smallest drift before a step that counts, over the largest change after it
POOR_RESIDUAL_RATIO = 5.0  # residual over noise above which noise does not explain it
ROUNDED_CHANGE = 1e-12  # change of friction up to which it counts as rounding
MAX_RELATIVE_ERROR = 1.0 / MAX_CHANCE_ERRORS  # largest relative standard error of an estimate

NO_RELAXATION_TEXT = "no relaxation exceeds the noise"
TOO_SHORT_TEXT = "friction still relaxes at the end of the record; record for longer"
TOO_COARSE_TEXT = "friction relaxes within a few samples; sample faster"
TOO_NOISY_TEXT = "its standard error is more than a third of it"
# Estimates that are left undetermined, by the reason why the rate is undetermined.
OPEN_WITH = {
    NO_RELAXATION_TEXT: ("mu_2", "amplitude", "rate"),
    TOO_SHORT_TEXT: ("mu_2", "amplitude", "rate"),
    TOO_COARSE_TEXT: ("jump", "amplitude", "rate"),
    TOO_NOISY_TEXT: ("rate",),
}
NEITHER_TEXT = (
    "neither law fits: the machine is soft, or took long to reach the velocity; give its "
    "--stiffness, or use a stiffer machine"
)
UNSURE_TEXT = "its standard error is more than a third of the whole change of friction"

Shape = Callable[[np.ndarray, np.ndarray], tuple[np.ndarray, np.ndarray]]


class Relaxation(NamedTuple):
    """The fit of one curve, with p = (mu_2, b, log k)."""

    p: np.ndarray
    residual: np.ndarray  # fit minus data, shape (samples,)
    factor: float  # factor of variances due to correlated noise
    covariance: np.ndarray  # of p, shape (3, 3)
    rates: np.ndarray  # trial rates, increasing, shape (rates,)
    compatible: np.ndarray  # whether each rate is compatible with the data, shape (rates,)
    best: np.ndarray  # mu_2 and b at these rates, shape (rates, 2)
    covariances: np.ndarray  # of mu_2 and b at these rates, shape (rates, 2, 2)
    slack: np.ndarray  # allowed deviation of mu_2 and b in standard errors, shape (rates,)

    def error(self, weights: np.ndarray) -> float:
        """Return the standard error of a weighted sum of mu_2 and b."""
        return float(np.sqrt(weights @ self.covariance[:2, :2] @ weights))

    def spread(self, weights: np.ndarray) -> float:
        """Return the standard error over all compatible rates: a sixth of the sum's range."""
        values = self.best @ weights
        widths = self.slack * np.sqrt(np.einsum("p,kpq,q->k", weights, self.covariances, weights))
        ends = (values + widths)[self.compatible], (values - widths)[self.compatible]
        return float((ends[0].max() - ends[1].min()) / (2.0 * MAX_CHANCE_ERRORS))


def fit_relaxation_curve(t: np.ndarray, values: np.ndarray, shape: Shape) -> Relaxation:
    """Fit mu_2 + b g(k t) to values at times t > 0, both of shape (samples,), four or more.

    shape : function of p = (b, log k) and t that returns b g(k t) and its derivatives by p, as that
    of ``workflow.reduce.step_law``.
    """
    fastest = max(MAX_RATE_TIMES_INTERVAL / (t[1] - t[0]), 2.0 / t[-1])
    rates = np.geomspace(MIN_RATE_TIMES_SPAN / t[-1], fastest, TRIAL_RATES)
    squares, best, inverse = _fits_at_rates(t, values, shape, rates)
    place = int(np.argmin(squares))
    reach = np.log(rates[[0, -1]])
    log_rate = np.clip(np.log(rates[place]), reach[0] + 1e-6, reach[1] - 1e-6)
    start = np.array([*best[place], log_rate])
    solution = least_squares(
        lambda p: _model(t, shape, p)[0] - values,
        start,
        lambda p: _model(t, shape, p)[1],
        bounds=([-np.inf, -np.inf, reach[0]], [np.inf, np.inf, reach[1]]),
        x_scale="jac",
        ftol=1e-12,
        xtol=1e-12,
        gtol=None,
    )
    p, jacobian = solution.x, solution.jac
    residual = _model(t, shape, p)[0] - values
    least = float(residual @ residual)
    factor = correlation_factor(residual)
    variance = factor * max(least / (t.size - 3), ROUNDED_CHANGE**2)
    grown = (squares - least) / variance
    compatible = grown <= MAX_CHANCE_ERRORS**2
    compatible[place] = True
    return Relaxation(
        p=p,
        residual=residual,
        factor=factor,
        covariance=variance * np.linalg.pinv(jacobian.T @ jacobian, hermitian=True),
        rates=rates,
        compatible=compatible,
        best=best,
        covariances=variance * inverse,
        slack=np.sqrt(np.clip(MAX_CHANCE_ERRORS**2 - grown, 0.0, None)),
    )


def _model(t: np.ndarray, shape: Shape, p: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    values, slopes = shape(p[None, 1:], t)
    return p[0] + values[0], np.column_stack([np.ones_like(t), slopes[0]])


def _fits_at_rates(
    t: np.ndarray, values: np.ndarray, shape: Shape, rates: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the sum of squares, the best mu_2 and b, and inv(J'J) at each rate."""
    squares, best, inverses = [], [], []
    for rate in rates:
        _, jacobian = _model(t, shape, np.array([0.0, 1.0, np.log(rate)]))
        columns = jacobian[:, :2]
        inverse = np.linalg.inv(columns.T @ columns)
        solution = inverse @ (columns.T @ values)
        squares.append(float(np.sum((columns @ solution - values) ** 2)))
        best.append(solution)
        inverses.append(inverse)
    return np.array(squares), np.array(best), np.array(inverses)


class StepFit(NamedTuple):
    """Estimates of one step by one law; an undetermined estimate is NaN."""

    step: MeasuredStep
    mu_1: Estimate
    mu_2: Estimate
    jump: Estimate
    amplitude: Estimate  # mu* of eq. 6
    rate: Estimate  # k, 1/s
    why: dict[str, str]  # reasons for undetermined estimates
    drift: Estimate  # change of friction over ``step.before``, by a straight line
    levelled: bool  # whether the drift is subtracted, before and after the step
    noise: float  # standard deviation of friction from sample to sample
    rms: float  # of the residual
    factor: float  # factor of variances due to correlated noise
    curve: np.ndarray  # friction by the fit at ``step.time``
    stiffness: float | None  # 1/m, of the spring in the fit

    @property
    def drifts(self) -> bool:
        """Return whether the drift before a step exceeds its error and MIN_DRIFT_SHARE."""
        size = max(abs(self.curve - self.mu_1.value))
        return abs(self.drift.value) > max(
            MAX_CHANCE_ERRORS * self.drift.error, MIN_DRIFT_SHARE * size
        )

    def state(self) -> tuple[Estimate, Estimate, Estimate]:
        """Return a, b and D_c (m) of the law."""
        per_log = 1.0 / math.log(self.step.ratio)
        length = self.step.v2 / self.rate.value
        share = self.rate.error / self.rate.value
        a, b = self.jump.times(per_log), self.amplitude.times(per_log)
        return a, b, Estimate(length, length * share)


def fit_step(step: MeasuredStep, law: str = "ruina", stiffness: float | None = None) -> StepFit:
    """Fit one step; law : "ruina", which is eq. 6, or "dieterich".

    stiffness : of the machine (1/m), whose spring is then modelled; None: a stiff machine. If
    friction drifts before the step, the drift is subtracted before and after it, provided that this
    reduces the residual. The errors of the estimates then include that of the drift.
    """
    plain = _fitted(step, law, stiffness)
    if not abs(plain.drift.value) > MAX_CHANCE_ERRORS * plain.drift.error:
        return plain
    span = float(np.ptp(step.before_time)) * step.before.size / (step.before.size - 1)
    per_second = plain.drift.times(1.0 / span)
    level = _fitted(_levelled(step, per_second.value), law, stiffness)
    if level.rms >= plain.rms:
        return plain
    other = _fitted(_levelled(step, per_second.value + per_second.error), law, stiffness)
    return level._replace(
        step=step,
        drift=plain.drift,
        levelled=True,
        curve=level.curve + per_second.value * step.time,
        mu_1=_with_drift(level.mu_1, other.mu_1),
        mu_2=_with_drift(level.mu_2, other.mu_2),
        jump=_with_drift(level.jump, other.jump),
        amplitude=_with_drift(level.amplitude, other.amplitude),
        rate=_with_drift(level.rate, other.rate),
    )


def _levelled(step: MeasuredStep, drift: float) -> MeasuredStep:
    """Subtract a linear drift (1/s) from the friction of a step."""
    return step._replace(
        before=step.before - drift * step.before_time, after=step.after - drift * step.time
    )


def _with_drift(estimate: Estimate, off: Estimate) -> Estimate:
    """Add the error of the drift to the error of an estimate.

    off : the same estimate with the drift increased by one standard error.
    """
    more = off.value - estimate.value if off.known else estimate.error
    return Estimate(estimate.value, math.hypot(estimate.error, more))


def _fitted(step: MeasuredStep, law: str, stiffness: float | None) -> StepFit:
    """Fit one step without subtracting a drift."""
    constant = _constant(step)
    if np.ptp(step.after) <= ROUNDED_CHANGE:
        return constant
    fit = constant._replace(noise=noise_of(np.diff(step.after)), stiffness=stiffness)
    solution = _stiff(step, law, fit.mu_1) if stiffness is None else _sprung(step, law, stiffness)
    rms = float(np.sqrt(np.mean(solution.pop("residual") ** 2)))
    return fit._replace(rms=rms, **solution)


def _stiff(step: MeasuredStep, law: str, mu_1: Estimate) -> dict[str, Any]:
    """Fit a step of a stiff machine; return fields of a StepFit."""
    fit = fit_relaxation_curve(step.time, step.after, step_law(law, step.ratio))
    curve = step.after + fit.residual
    rate, reason = _rate(fit)
    solution, why = _levels(step, fit, mu_1, curve, bool(reason))
    why |= dict.fromkeys(OPEN_WITH.get(reason, ()), reason)
    solution |= {name: Estimate() for name in OPEN_WITH.get(reason, ())}
    how = {"why": why, "factor": fit.factor, "curve": curve, "residual": fit.residual}
    return {**solution, "rate": rate, **how}


def _sprung(step: MeasuredStep, law: str, stiffness: float) -> dict[str, Any]:
    """Fit a step of a compliant machine; return fields of a StepFit."""
    fit = fit_behind_spring(step, law, stiffness)
    size = float(np.max(np.abs(fit.curve - fit.mu_1.value)))
    solution = {
        name: level.if_below(MAX_RELATIVE_ERROR * size) for name, level in fit.levels.items()
    }
    rate = Estimate(step.v2 / math.exp(fit.log_length.value), fit.log_length.error)
    rate = rate._replace(error=rate.value * rate.error).if_below(MAX_RELATIVE_ERROR * rate.value)
    why = {name: UNSURE_TEXT for name in solution if not solution[name].known}
    if rate.known and rate.value * step.time[-1] < MIN_RATE_TIMES_SPAN:
        rate, why["rate"] = Estimate(), TOO_SHORT_TEXT
    elif not rate.known:
        why["rate"] = TOO_NOISY_TEXT
    how = {"why": why, "factor": fit.factor, "curve": fit.curve, "residual": fit.residual}
    return {**solution, "mu_1": fit.mu_1, "rate": rate, **how}


def _drift(values: np.ndarray) -> Estimate:
    """Return the change over evenly spaced samples by a linear fit."""
    place = np.linspace(-0.5, 0.5, values.size)
    weight = place @ place
    rise = float(place @ values / weight)
    rest = values - values.mean() - rise * place
    variance = rest @ rest / (rest.size - 2) * correlation_factor(rest)
    return Estimate(rise, math.sqrt(variance / weight))


def _constant(step: MeasuredStep) -> StepFit:
    """Return a fit with constant friction after the step; other fits replace its fields."""
    mu_1, mu_2 = mean(step.before), Estimate(float(step.after.mean()), 0.0)
    return StepFit(
        step=step,
        mu_1=mu_1,
        mu_2=mu_2,
        jump=Estimate(mu_2.value - mu_1.value, mu_1.error),
        amplitude=Estimate(),
        rate=Estimate(),
        why={"amplitude": NO_RELAXATION_TEXT, "rate": NO_RELAXATION_TEXT},
        drift=_drift(step.before),
        levelled=False,
        noise=0.0,
        rms=0.0,
        factor=1.0,
        curve=np.full_like(step.after, mu_2.value),
        stiffness=None,
    )


def _rate(fit: Relaxation) -> tuple[Estimate, str]:
    """Return the rate and, if it is undetermined, the reason."""
    slow, fast = bool(fit.compatible[0]), bool(fit.compatible[-1])
    if slow and fast:
        return Estimate(), NO_RELAXATION_TEXT
    if slow or fast:
        return Estimate(), TOO_SHORT_TEXT if slow else TOO_COARSE_TEXT
    open_to = np.log(fit.rates[fit.compatible])
    share = math.sqrt(fit.covariance[2, 2])
    if max(share, np.ptp(open_to) / (2.0 * MAX_CHANCE_ERRORS)) > MAX_RELATIVE_ERROR:
        return Estimate(), TOO_NOISY_TEXT
    rate = math.exp(fit.p[2])
    return Estimate(rate, share * rate), ""


def _levels(
    step: MeasuredStep, fit: Relaxation, mu_1: Estimate, curve: np.ndarray, any_rate: bool
) -> tuple[dict[str, Estimate], dict[str, str]]:
    """Return estimates that are linear in mu_2 and b, and the reasons for undetermined ones.

    any_rate : whether the rate is undetermined; errors then include all compatible rates.
    """
    log_ratio = math.log(step.ratio)  # g at the moment of the step, for both laws
    # The step happened between two samples, at any time with equal probability.
    timing = abs(fit.p[1] * log_ratio) * math.exp(fit.p[2]) * step.change / math.sqrt(12.0)
    size = float(np.max(np.abs(curve - mu_1.value)))  # largest change of friction
    requested = {
        "mu_2": (np.array([1.0, 0.0]), Estimate(0.0, 0.0)),
        "amplitude": (np.array([0.0, log_ratio]), Estimate(0.0, 0.0)),
        "jump": (np.array([1.0, log_ratio]), mu_1),
    }
    solution, reasons = {}, {}
    for name, (weights, less) in requested.items():
        error = fit.spread(weights) if any_rate else fit.error(weights)
        value = float(weights @ fit.p[:2]) - less.value
        late = 0.0 if name == "mu_2" else timing
        solution[name] = Estimate(value, math.hypot(error, less.error, late))
        if not solution[name].error < MAX_RELATIVE_ERROR * size:
            solution[name] = Estimate()
            reasons[name] = UNSURE_TEXT
    return solution, reasons
