"""Nonlinear least squares of many curves at once, after Levenberg and Marquardt.

Plain numpy on arrays over the curves: one call fits a curve and all its jackknife replicates, and
gives the same bits in every process. scipy's ``leastsq`` does not: its MINPACK (scipy 1.15 to 1.17)
reads one number beyond the Jacobian when columns are nearly dependent, as those of two
exponentials fitted to one are, and pivots by what happens to lie there.
Source: D. W. Marquardt, J. Soc. Ind. Appl. Math. 11, 431 (1963).
"""

from typing import NamedTuple, Protocol

import numpy as np

MOST_ITERATIONS = 200
ENOUGH = 1e-14  # relative fall of the sum of squares below which an iteration is the last
DAMPING = (1e-3, 1e-12, 1e12)  # first, least and largest, relative to the diagonal of J'J
FACTOR = 10.0


class Model(Protocol):
    """A law of several parameters that curves are fitted by."""

    def __call__(self, p: np.ndarray, t: np.ndarray, /) -> tuple[np.ndarray, np.ndarray]:
        """Return values (curves, samples) and derivatives (curves, samples, parameters).

        p : parameters, shape (curves, parameters). t : times, shape (samples,).
        """


class _Fit(NamedTuple):
    p: np.ndarray
    squares: np.ndarray  # sum of squares, shape (curves,)
    gradient: np.ndarray  # J'r
    hessian: np.ndarray  # J'J


def fit_curves(model: Model, t: np.ndarray, curves: np.ndarray, start: np.ndarray) -> np.ndarray:
    """Return the parameters that fit each row of ``curves``, shape (curves, parameters).

    start : first guess, shape (parameters,) or (curves, parameters). A fit that runs away ends
    where its sum of squares last fell.
    """
    guess = np.broadcast_to(start, (len(curves), np.shape(start)[-1])).astype(float)
    best = _at(model, t, curves, guess)
    first, least, largest = DAMPING
    damping = np.full(len(curves), first)
    going = np.ones(len(curves), bool)
    for _ in range(MOST_ITERATIONS):
        step = _step(best, damping)
        going &= np.sum(-best.gradient * step, axis=1) > ENOUGH * best.squares  # that it may fall
        tried = _at(model, t, curves, best.p + step)
        fell = tried.squares < best.squares  # not where it is not a number
        gain = np.where(fell, best.squares - tried.squares, 0.0)
        better = np.flatnonzero(fell & going)
        for old, new in zip(best, tried, strict=True):
            old[better] = new[better]
        going &= ~(fell & (gain <= ENOUGH * best.squares)) & (damping < largest)
        damping = np.clip(np.where(fell, damping / FACTOR, damping * FACTOR), least, largest)
        if not going.any():
            break
    return best.p


def _at(model: Model, t: np.ndarray, curves: np.ndarray, p: np.ndarray) -> _Fit:
    values, jacobian = model(p, t)
    residual = values - curves
    squares = np.sum(residual**2, axis=1)
    gradient = np.einsum("csp,cs->cp", jacobian, residual)
    hessian = np.einsum("csp,csq->cpq", jacobian, jacobian)
    return _Fit(p, squares, gradient, hessian)


def _step(fit: _Fit, damping: np.ndarray) -> np.ndarray:
    """Return the damped step; parameters without influence stay where they are."""
    diagonal = np.einsum("cpp->cp", fit.hessian)
    scale = np.where(diagonal > 0.0, diagonal, 1.0)
    damped = fit.hessian + (damping[:, None] * scale)[..., None] * np.eye(scale.shape[1])
    sound = np.isfinite(damped).all(axis=(1, 2)) & np.isfinite(fit.gradient).all(axis=1)
    safe = np.where(sound[:, None, None], damped, np.eye(scale.shape[1]))
    step = np.linalg.solve(safe, -fit.gradient[..., None])[..., 0]
    return np.where(sound[:, None], step, 0.0)
