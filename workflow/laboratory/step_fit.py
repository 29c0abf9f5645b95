"""Fit one velocity step by eq. 6, which is Ruina's law, or by Dieterich's.

One step determines the friction before and after, the jump, and one rate k = b/tau. A state law
says the same in other words: a = jump/ln r, b = amplitude/ln r, D_c = v2/k with r = v2/v1. What a
step determines is asked of all rates that are compatible with the data within three standard
errors, not of the best one alone: where nothing relaxes, or more slowly than was recorded, any
rate will do.
Source: Li et al. (2014), doi:10.1038/srep05795, eqs. 6 and 8; the laws stand in
workflow/reduce/scenes/rate_state.py.
"""

import math
from typing import NamedTuple

import numpy as np

from ..reduce import step_law
from .errors import DEVIATIONS, Estimate, correlation_factor, mean
from .relaxation import Relaxation, fit_relaxation_curve
from .steps import Step

LARGEST_SHARE = 1.0 / DEVIATIONS  # of a number that its standard error may be

NOTHING = "nothing relaxes that stands out from the noise"
TOO_SHORT = "friction still relaxes where the record ends; a longer one is needed"
TOO_COARSE = "friction relaxes within a few samples; it must be sampled faster"
TOO_NOISY = "its standard error is more than a third of it"
# What else is open where the rate is: a relaxation may go on for ever, or be over at once.
OPEN_WITH = {
    NOTHING: ("mu_2", "amplitude", "rate"),
    TOO_SHORT: ("mu_2", "amplitude", "rate"),
    TOO_COARSE: ("jump", "amplitude", "rate"),
    TOO_NOISY: ("rate",),
}
UNSURE = "its standard error is more than a third of all that happens"


class StepFit(NamedTuple):
    """What one step determines by one law; an estimate that it does not determine is NaN."""

    step: Step
    law: str
    mu_1: Estimate
    mu_2: Estimate
    jump: Estimate
    amplitude: Estimate  # mu* of eq. 6
    rate: Estimate  # k, 1/s
    why: dict[str, str]  # of estimates that are not determined, why
    drift: Estimate  # change of friction over ``step.before``, by a straight line
    rms: float  # of the residual
    factor: float  # on the variances, as the noise is correlated
    curve: np.ndarray  # friction by the fit at ``step.time``

    def state(self) -> tuple[Estimate, Estimate, Estimate]:
        """Return a, b and D_c (m) of the law."""
        per_log = 1.0 / math.log(self.step.ratio)
        length = self.step.v2 / self.rate.value
        share = self.rate.error / self.rate.value
        a, b = self.jump.times(per_log), self.amplitude.times(per_log)
        return a, b, Estimate(length, length * share)


def fit_step(step: Step, law: str = "ruina") -> StepFit:
    """Fit one step; law : "ruina", which is eq. 6, or "dieterich"."""
    fit = fit_relaxation_curve(step.time, step.after, step_law(law, step.ratio))
    curve = step.after + fit.residual
    mu_1 = mean(step.before)
    rate, why = _rate(fit)
    found, reasons = _levels(step, fit, mu_1, curve, bool(why))
    reasons |= dict.fromkeys(OPEN_WITH.get(why, ()), why)
    found |= {name: Estimate() for name in OPEN_WITH.get(why, ()) if name != "rate"}
    return StepFit(
        step=step,
        law=law,
        mu_1=mu_1,
        rate=rate,
        why=reasons,
        drift=_drift(step.before),
        rms=float(np.sqrt(np.mean(fit.residual**2))),
        factor=fit.factor,
        curve=curve,
        **found,
    )


def _rate(fit: Relaxation) -> tuple[Estimate, str]:
    """Return the rate, or none and why."""
    slow, fast = bool(fit.compatible[0]), bool(fit.compatible[-1])
    if slow and fast:
        return Estimate(), NOTHING
    if slow or fast:
        return Estimate(), TOO_SHORT if slow else TOO_COARSE
    open_to = np.log(fit.rates[fit.compatible])
    share = math.sqrt(fit.covariance[2, 2])
    if max(share, np.ptp(open_to) / (2.0 * DEVIATIONS)) > LARGEST_SHARE:
        return Estimate(), TOO_NOISY
    rate = math.exp(fit.p[2])
    return Estimate(rate, share * rate), ""


def _levels(
    step: Step, fit: Relaxation, mu_1: Estimate, curve: np.ndarray, any_rate: bool
) -> tuple[dict[str, Estimate], dict[str, str]]:
    """Return what is linear in mu_2 and b, and why some of it is not determined.

    any_rate : the rate is open, and errors are those over all rates that it may have.
    """
    log_ratio = math.log(step.ratio)  # g at the moment of the step, of either law
    # The step came at some time, equally likely, between two samples.
    timing = abs(fit.p[1] * log_ratio) * math.exp(fit.p[2]) * step.change / math.sqrt(12.0)
    size = float(np.max(np.abs(curve - mu_1.value)))  # of what happens at all
    asked = {
        "mu_2": (np.array([1.0, 0.0]), Estimate(0.0, 0.0)),
        "amplitude": (np.array([0.0, log_ratio]), Estimate(0.0, 0.0)),
        "jump": (np.array([1.0, log_ratio]), mu_1),
    }
    found, reasons = {}, {}
    for name, (weights, less) in asked.items():
        error = fit.spread(weights) if any_rate else fit.error(weights)
        value = float(weights @ fit.p[:2]) - less.value
        late = 0.0 if name == "mu_2" else timing
        found[name] = Estimate(value, math.hypot(error, less.error, late))
        if not found[name].error < LARGEST_SHARE * size:
            found[name] = Estimate()
            reasons[name] = UNSURE
    return found, reasons


def _drift(values: np.ndarray) -> Estimate:
    """Return the rise of a straight line over values, shape (samples,)."""
    place = np.linspace(-0.5, 0.5, values.size)
    weight = place @ place
    rise = float(place @ values / weight)
    rest = values - values.mean() - rise * place
    variance = rest @ rest / (values.size - 2) * correlation_factor(rest)
    return Estimate(rise, math.sqrt(variance / weight))
