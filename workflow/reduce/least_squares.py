"""Nonlinear least squares of many curves at once, after Levenberg and Marquardt.

One call fits a curve and all its jackknife replicates in plain numpy, with the same bits in every
process. scipy's ``leastsq`` is not reproducible: if columns of the Jacobian are nearly dependent,
as for two exponentials fitted to one, MINPACK (scipy 1.15 to 1.17) uses one number past the end of
the Jacobian for pivoting (docs/decisions.md).
Source: D. W. Marquardt, J. Soc. Ind. Appl. Math. 11, 431 (1963).
"""

from typing import NamedTuple, Protocol

import numpy as np

MAX_ITERATIONS = 200
SQUARES_TOLERANCE = 1e-14  # relative decrease of the sum of squares at convergence
DAMPING = (1e-3, 1e-12, 1e12)  # first, smallest and largest, relative to the diagonal of J'J
DAMPING_FACTOR = 10.0


class Model(Protocol):
    """Function that is fitted to curves, and its derivatives."""

    def __call__(self, p: np.ndarray, t: np.ndarray, /) -> tuple[np.ndarray, np.ndarray]:
        """Return values (curves, samples) and derivatives (curves, samples, parameters).

        p : parameters, shape (curves, parameters). t : times, shape (samples,).
        """


class _Fit(NamedTuple):
    """Fits of curves at given parameters."""

    p: np.ndarray
    squares: np.ndarray  # sum of squares, shape (curves,)
    gradient: np.ndarray  # J'r
    hessian: np.ndarray  # J'J


def fit_curves(model: Model, t: np.ndarray, curves: np.ndarray, start: np.ndarray) -> np.ndarray:
    """Return the parameters that fit each row of ``curves`` best, shape (curves, parameters).

    start : initial guess, shape (parameters,) or (curves, parameters). A fit that diverges returns
    the best parameters that it reached.
    """
    guess = np.broadcast_to(start, (len(curves), np.shape(start)[-1])).astype(float)
    best = _fit_at(model, t, curves, guess)
    first, smallest, largest = DAMPING
    damping = np.full(len(curves), first)
    active = np.ones(len(curves), bool)
    for _ in range(MAX_ITERATIONS):
        step = _step(best, damping)
        # Stop where the predicted decrease of the sum of squares is negligible.
        active &= np.sum(-best.gradient * step, axis=1) > SQUARES_TOLERANCE * best.squares
        trial = _fit_at(model, t, curves, best.p + step)
        decreased = trial.squares < best.squares  # false for NaN
        gain = np.where(decreased, best.squares - trial.squares, 0.0)
        better = np.flatnonzero(decreased & active)
        for old, new in zip(best, trial, strict=True):
            old[better] = new[better]
        active &= ~(decreased & (gain <= SQUARES_TOLERANCE * best.squares)) & (damping < largest)
        damping = np.clip(
            np.where(decreased, damping / DAMPING_FACTOR, damping * DAMPING_FACTOR),
            smallest,
            largest,
        )
        if not active.any():
            break
    return best.p


def _fit_at(model: Model, t: np.ndarray, curves: np.ndarray, p: np.ndarray) -> _Fit:
    values, jacobian = model(p, t)
    residual = values - curves
    squares = np.sum(residual**2, axis=1)
    gradient = np.einsum("csp,cs->cp", jacobian, residual)
    hessian = np.einsum("csp,csq->cpq", jacobian, jacobian)
    return _Fit(p, squares, gradient, hessian)


def _step(fit: _Fit, damping: np.ndarray) -> np.ndarray:
    """Return the damped step; parameters that do not affect the curve do not change."""
    diagonal = np.einsum("cpp->cp", fit.hessian)
    scale = np.where(diagonal > 0.0, diagonal, 1.0)
    damped = fit.hessian + (damping[:, None] * scale)[..., None] * np.eye(scale.shape[1])
    sound = np.isfinite(damped).all(axis=(1, 2)) & np.isfinite(fit.gradient).all(axis=1)
    safe = np.where(sound[:, None, None], damped, np.eye(scale.shape[1]))
    step = np.linalg.solve(safe, -fit.gradient[..., None])[..., 0]
    return np.where(sound[:, None], step, 0.0)
