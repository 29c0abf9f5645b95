"""Rate-and-state friction: a, b and D_c of a velocity step, for Ruina's and Dieterich's laws.

mu = mu* + a ln(v/v*) + b ln(v* theta/D_c), with the state theta after Ruina (slip law),
d theta/dt = -(v theta/D_c) ln(v theta/D_c), or after Dieterich (ageing law), d theta/dt =
1 - v theta/D_c. A jump from steady sliding at v1 to v2 = r v1 gives over the distance s

    mu - mu_2 = b ln(r) exp(-s/D_c)                     (Ruina)
    mu - mu_2 = b ln(1 + (r - 1) exp(-s/D_c))           (Dieterich)

and mu_2 - mu_1 = (a - b) ln r. With mu_2 known, b and D_c are fitted to the
decay, and a follows. Source: C. Marone, Annu. Rev. Earth Planet. Sci. 26, 643 (1998),
doi:10.1146/annurev.earth.26.1.643; A. Ruina, J. Geophys. Res. 88, 10359 (1983).
"""

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from .fits import FITTED, NO_STATE, NOT_EXPONENTIAL, NOT_FINITE, UNDETERMINED, fit_window
from .jackknife import significant
from .least_squares import fit_curves

STATE_LAWS = ("ruina", "dieterich")
MIN_STATE_SAMPLES = 4
MAX_STATE_RESIDUAL = 0.5  # over b ln r: above, the law does not describe the curve


class RateState(NamedTuple):
    """Fit of one law to one step; arrays hold the estimate, then its jackknife replicates."""

    a: np.ndarray  # in units of mu, shape (replicates,)
    b: np.ndarray
    dc: np.ndarray  # in units of the distance
    residual: float  # rms residual of the mean curve, over |b ln r|
    status: int  # see STATUS_COMMENT in fits.py; NO_STATE: b does not differ from zero


def fit_rate_state(
    distance: np.ndarray, deviation: np.ndarray, change: np.ndarray, ratio: float, law: str
) -> RateState:
    """Return the fit of one law to the friction after a velocity step by a ratio r > 0.

    distance : slid since the step, increasing from the first sample, shape (samples,). deviation :
    mu - mu_2, shape (replicates, samples), row 0 the mean curve. change : mu_2 - mu_1 of the same
    replicates. The fit window starts at the largest absolute deviation of the mean curve and ends
    where the deviation has decreased to 5 % of that.
    """
    size = len(deviation)
    if not (np.isfinite(deviation).all() and np.isfinite(change).all()):
        return _nothing(size, NOT_FINITE)
    if not ratio > 0.0 or ratio == 1.0:
        return _nothing(size, NO_STATE)
    # For b > 0 the deviation is positive after a step up.
    sign = 1.0 if ratio > 1.0 else -1.0
    if np.max(sign * deviation[0]) < np.max(-sign * deviation[0]):
        sign = -sign
    first = int(np.argmax(sign * deviation[0]))
    window = slice(first, first + fit_window(deviation[0, first:]))
    s, curves = distance[window], deviation[:, window]
    if s.size < MIN_STATE_SAMPLES:
        return _nothing(size, UNDETERMINED)
    scale, span = sign * max(abs(curves[0, 0]), 1e-300), s[-1]
    model, start = step_law(law, ratio), _start(s / span, curves[0] / scale, ratio, law)
    with np.errstate(all="ignore"):
        mean = fit_curves(model, s / span, curves[:1] / scale, start)
        others = fit_curves(model, s / span, curves[1:] / scale, mean[0])
        fits = np.concatenate([mean, others])
        b, dc = fits[:, 0] * scale, span / np.exp(fits[:, 1])
        values, _ = model(fits[:1], s / span)
    residual = float(np.sqrt(np.mean((values[0] * scale - curves[0]) ** 2)))
    a = b + change / math.log(ratio)
    relative = residual / abs(b[0] * math.log(ratio)) if b[0] else math.inf
    if not np.isfinite(fits[0]).all():
        return _nothing(size, UNDETERMINED)
    status = NO_STATE
    if significant(b):
        status = NOT_EXPONENTIAL
        if relative < MAX_STATE_RESIDUAL:
            status = FITTED if significant(dc) else UNDETERMINED
    fitted_dc = dc if status == FITTED else np.full(size, np.nan)
    return RateState(a, b, fitted_dc, relative, status)


def step_law(law: str, ratio: float) -> Callable:
    """Return the Model (see ``fit_curves``) of mu - mu_2 after a step by v2/v1 = ratio.

    Its parameters are b and ln(1/D_c), in the unit of the given distances. For times instead of
    distances the second parameter is ln(v2/D_c), and Ruina's law is eq. 6.
    """

    def model(p: np.ndarray, s: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        b, rate = p[:, :1], np.exp(p[:, 1:])
        if law == "ruina":
            shape = math.log(ratio) * np.exp(-rate * s)
            return b * shape, np.stack([shape, -b * rate * s * shape], axis=2)
        excess = (ratio - 1.0) * np.exp(-rate * s)
        shape = np.log1p(excess)
        return b * shape, np.stack([shape, -b * rate * s * excess / (1.0 + excess)], axis=2)

    return model


def state_change(law: str, phi: float, log_v: float) -> float:
    """Return d phi/dt in units of v*/D_c, for phi = ln(v* theta/D_c) at ln(v/v*) = log_v."""
    v = math.exp(log_v)
    return -v * (log_v + phi) if law == "ruina" else math.exp(-phi) - v


def _start(s: np.ndarray, curve: np.ndarray, ratio: float, law: str) -> np.ndarray:
    """Return the initial guess, from the first sample and the first one below 1/e of it."""
    low = np.flatnonzero(curve < curve[0] / math.e)
    k = int(low[0]) if low.size else s.size - 1
    rate, step = 1.0 / max(s[k] - s[0], 1e-12), math.log(ratio)
    if law == "dieterich":  # from ln(1 + (r - 1) exp(-s/D_c)) = ln(r)/e
        rate *= math.log(math.expm1(step) / math.expm1(step / math.e))
    size = step * math.exp(-min(rate * s[0], 30.0))
    return np.array([curve[0] / size, math.log(rate)])


def _nothing(size: int, status: int) -> RateState:
    nothing = np.full(size, np.nan)
    return RateState(nothing, nothing, nothing, math.nan, status)
