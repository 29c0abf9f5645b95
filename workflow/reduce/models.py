"""Alternatives to eq. 6, compared by cross-validation: stretched and two exponentials.

The samples of a curve are correlated, so that criteria that count samples (AIC, BIC) do not apply.
Instead each model is fitted to the mean of all blocks but one and predicts the block left out. Its
score is the mean squared error, averaged over blocks (M. Stone, J. R. Stat. Soc. B 36, 111 (1974)).
All fits use the known mu_2 and the whole recorded curve.
"""

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from .jackknife import errors_needed, significant
from .least_squares import Model, fit_curves

EXPONENTIAL, STRETCHED, TWO_EXPONENTIALS, UNDECIDED_MODEL = 1, 2, 3, 0
MODEL_MEANINGS = "undecided exponential stretched two_exponentials"
DECISIVE_ERRORS = 2.0  # standard errors by which a model must be better than eq. 6
GAIN_TOLERANCE = 1e-9  # gains below it are rounding

# Limits of the coefficients that samples can determine.
MIN_RELATIVE_RATE = 1e-3  # rate times the whole time: below, the curve is a constant
MAX_SECOND_PHASE = 30.0  # (rate times second time)^beta: above, later samples are rounding
DECAY_FACTOR = 58.0  # exp(-s) decreases from 95 % to 5 % while s grows by this factor
MIN_LOG_PHASE_CHANGE = 0.1  # of log (b t)^beta over the samples: below, the curve is a constant


def one_exponential(p: np.ndarray, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return A exp(-b t) (eq. 6) and its derivatives; p = (A, log b) along the last axis."""
    return stretched(np.column_stack([p, np.zeros(len(p))]), t, 2)


def stretched(p: np.ndarray, t: np.ndarray, count: int = 3) -> tuple[np.ndarray, np.ndarray]:
    """Return A exp(-(b t)^beta) and its first ``count`` derivatives; p = (A, log b, log beta)."""
    amplitude, beta = p[:, :1], np.exp(p[:, 2:])
    log_phase = beta * (p[:, 1:2] + np.log(t))
    phase = np.exp(log_phase)
    decay = np.exp(-phase)
    fall = -amplitude * phase * decay
    slopes = [decay, fall * beta, np.where(phase > 0.0, fall * log_phase, 0.0)]
    return amplitude * decay, np.stack(slopes[:count], axis=2)


def two_exponentials(p: np.ndarray, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return A exp(-b t) + B exp(-c t) and its derivatives; p = (A, log b, B, log c)."""
    (one, first), (two, second) = one_exponential(p[:, :2], t), one_exponential(p[:, 2:], t)
    return one + two, np.concatenate([first, second], axis=2)


# model -> (function for (mu - mu_2)/scale over t/span, initial guess from b span of eq. 6)
MODELS: dict[int, tuple[Model, Callable[[float], np.ndarray]]] = {
    EXPONENTIAL: (one_exponential, lambda b: np.array([1.0, np.log(b)])),
    STRETCHED: (stretched, lambda b: np.array([1.0, np.log(b), 0.0])),
    TWO_EXPONENTIALS: (
        two_exponentials,
        lambda b: np.array([0.6, np.log(2.0 * b), 0.4, np.log(0.5 * b)]),
    ),
}


class Comparison(NamedTuple):
    """Coefficients for the jackknife replicates (entry 0: all blocks), and the best model.

    Coefficients are NaN if their model is not decisively better than eq. 6, or if the blocks do not
    determine them.
    """

    best: int
    stretched_rate: np.ndarray  # b of the stretched exponential, per tau
    stretched_exponent: np.ndarray  # beta
    fast_rate: np.ndarray  # b of the faster of two exponentials
    slow_rate: np.ndarray
    fast_share: np.ndarray  # share of the amplitude
    gain_stretched: tuple[float, float]  # decrease of the score relative to eq. 6, and error
    gain_two_exponentials: tuple[float, float]


GAINS = tuple(name for name in Comparison._fields if name.startswith("gain_"))
COEFFICIENTS = tuple(name for name in Comparison._fields if name not in ("best", *GAINS))


def compare_models(
    time: np.ndarray, deviation: np.ndarray, blocks: np.ndarray, rate: float
) -> Comparison:
    """Return the comparison of the three models.

    time : shape (samples,), in tau. deviation : mu - mu_2 of the mean and of the replicates that
    leave one block out, shape (blocks + 1, samples). blocks : mu - mu_2 of each block, shape
    (blocks, samples). rate : b of eq. 6, the initial guess; NaN gives UNDECIDED_MODEL and NaN in
    all coefficients.
    """
    if not np.isfinite(rate):
        nothing = np.full(len(deviation), np.nan)
        unknown: dict[str, Any] = dict.fromkeys(COEFFICIENTS, nothing)
        unknown |= dict.fromkeys(GAINS, (np.nan, np.nan))
        return Comparison(UNDECIDED_MODEL, **unknown)
    scale, span = deviation[0, 0], time[-1]
    with np.errstate(all="ignore"):  # a diverging fit is not decisive
        fits, gains = _fits_and_gains(time / span, deviation / scale, blocks / scale, rate * span)
        b, beta = np.exp(fits[STRETCHED][:, 1:]).T
        pair = fits[TWO_EXPONENTIALS]
        rates, share = np.exp(pair[:, [1, 3]]), pair[:, 0] / (pair[:, 0] + pair[:, 2])
        swap = rates[:, 1] > rates[:, 0]  # the faster exponential comes first
        fast, slow = rates.max(axis=1), rates.min(axis=1)
        share = np.where(swap, 1.0 - share, share)
        b[~determined(time / span, b, beta)] = np.nan
        fast[~determined(time / span, fast)] = slow[~determined(time / span, slow)] = np.nan
    known = {STRETCHED: (b, beta), TWO_EXPONENTIALS: (fast, slow, share, fast - slow)}
    better = {}
    for code, values in known.items():
        gain, error = gains[code]
        needed = errors_needed(len(blocks), DECISIVE_ERRORS, 0.05)  # 5 % false positives
        if gain > max(needed * error, GAIN_TOLERANCE) and all(map(significant, values)):
            better[code] = gain
        else:
            for array in values:
                array[:] = np.nan
    return Comparison(
        max(better, key=better.__getitem__) if better else EXPONENTIAL,
        b / span,
        beta,
        fast / span,
        slow / span,
        share,
        gains[STRETCHED],
        gains[TWO_EXPONENTIALS],
    )


def determined(
    time: np.ndarray, rate: np.ndarray, exponent: np.ndarray | float = 1.0
) -> np.ndarray:
    """Return the mask of coefficients of exp(-(b t)^beta) that the samples can determine.

    A fit may diverge to coefficients on which the curve no longer depends: a decay between two
    samples, one before the first, or a constant. Such coefficients are meaningless even if all
    replicates agree on them. rate : per unit of ``time``, any shape.
    """
    with np.errstate(all="ignore"):  # a fit may have diverged
        decay = DECAY_FACTOR ** (1.0 / np.asarray(exponent))  # factor of time from 95 % to 5 %
        change = exponent * np.log(time[-1] / time[0])
        sampled = (rate * time[1]) ** exponent < MAX_SECOND_PHASE
        resolved = decay > 1.0 + rate * (time[1] - time[0])  # not between two samples
        return (
            (rate * time[-1] > MIN_RELATIVE_RATE)
            & sampled
            & resolved
            & (change > MIN_LOG_PHASE_CHANGE)
        )


def _fits_and_gains(
    t: np.ndarray, curves: np.ndarray, blocks: np.ndarray, rate: float
) -> tuple[dict[int, np.ndarray], dict[int, tuple[float, float]]]:
    """Return the fits to all curves, and the gain over eq. 6 on blocks left out, by model."""
    fits, scores = {}, {}
    for code, (model, start) in MODELS.items():
        mean = fit_curves(model, t, curves[:1], start(rate))
        fits[code] = np.concatenate([mean, fit_curves(model, t, curves[1:], mean[0])])
        predicted, _ = model(fits[code][1:], t)
        scores[code] = np.mean((blocks - predicted) ** 2, axis=1)
    gains, reference = {}, scores[EXPONENTIAL]
    for code, score in scores.items():  # 1 - score/reference over the blocks, and its error
        gain = reference - score
        error = gain.std(ddof=1) / np.sqrt(gain.size)
        gains[code] = float(gain.mean() / reference.mean()), float(error / reference.mean())
    return fits, gains
