"""Least squares of a relaxation mu_2 + b g(k t) with unknown rate k, and which rates fit as well.

For a given rate the model is linear, so that many rates can be tried; the best one is refined by
scipy's ``least_squares``. All rates at which the sum of squares has grown by less than nine
variances are compatible with the data within three standard errors. The variance is that of the
residual, times the factor by which correlated noise says less than independent noise.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from scipy.optimize import least_squares

from .errors import DEVIATIONS, correlation_factor

RATES = 80  # tried
SLOWEST = 0.1  # rate times the whole time: slower is a straight line
FASTEST = 1.0  # rate times the first interval of samples: faster is part of the jump
SMALL = 1e-12  # of a coefficient of friction: less is rounding

Shape = Callable[[np.ndarray, np.ndarray], tuple[np.ndarray, np.ndarray]]


class Relaxation(NamedTuple):
    """The fit of one curve, with p = (mu_2, b, log k)."""

    p: np.ndarray
    residual: np.ndarray  # fit minus data, shape (samples,)
    factor: float  # on the variances, as the noise is correlated
    covariance: np.ndarray  # of p, shape (3, 3)
    rates: np.ndarray  # that were tried, increasing
    compatible: np.ndarray  # which of them are
    best: np.ndarray  # mu_2 and b at these rates, shape (rates, 2)
    covariances: np.ndarray  # of mu_2 and b at these rates, shape (rates, 2, 2)
    slack: np.ndarray  # standard errors that the rate itself leaves to chance, shape (rates,)

    def error(self, weights: np.ndarray) -> float:
        """Return the standard error of a sum of mu_2 and b with these weights."""
        return float(np.sqrt(weights @ self.covariance[:2, :2] @ weights))

    def spread(self, weights: np.ndarray) -> float:
        """Return the same from all compatible rates: half their range over three."""
        values = self.best @ weights
        widths = self.slack * np.sqrt(np.einsum("p,kpq,q->k", weights, self.covariances, weights))
        ends = (values + widths)[self.compatible], (values - widths)[self.compatible]
        return float((ends[0].max() - ends[1].min()) / (2.0 * DEVIATIONS))


def fit_relaxation_curve(t: np.ndarray, values: np.ndarray, shape: Shape) -> Relaxation:
    """Fit mu_2 + b g(k t) to values at times t > 0, both of shape (samples,), four or more.

    shape : returns b g and its derivatives by b and log k for (b, log k), as
    ``workflow.reduce.step_law``.
    """
    fastest = max(FASTEST / (t[1] - t[0]), 2.0 / t[-1])
    rates = np.geomspace(SLOWEST / t[-1], fastest, RATES)
    squares, best, inverse = _tried(t, values, shape, rates)
    place = int(np.argmin(squares))
    start = np.array([*best[place], np.log(rates[place])])
    p, jacobian = _refined(t, values, shape, start, np.log(rates[[0, -1]]))
    residual = _model(t, shape, p)[0] - values
    least = float(residual @ residual)
    factor = correlation_factor(residual)
    variance = factor * max(least / (t.size - 3), SMALL**2)
    grown = (squares - least) / variance
    compatible = grown <= DEVIATIONS**2
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
        slack=np.sqrt(np.clip(DEVIATIONS**2 - grown, 0.0, None)),
    )


def _model(t: np.ndarray, shape: Shape, p: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    values, slopes = shape(p[None, 1:], t)
    return p[0] + values[0], np.column_stack([np.ones_like(t), slopes[0]])


def _tried(
    t: np.ndarray, values: np.ndarray, shape: Shape, rates: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return per rate the sum of squares, mu_2 and b that fit best, and the inverse of J'J."""
    squares, best, inverses = [], [], []
    for rate in rates:
        _, jacobian = _model(t, shape, np.array([0.0, 1.0, np.log(rate)]))
        columns = jacobian[:, :2]
        inverse = np.linalg.inv(columns.T @ columns)
        found = inverse @ (columns.T @ values)
        squares.append(float(np.sum((columns @ found - values) ** 2)))
        best.append(found)
        inverses.append(inverse)
    return np.array(squares), np.array(best), np.array(inverses)


def _refined(
    t: np.ndarray, values: np.ndarray, shape: Shape, start: np.ndarray, reach: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Return the parameters that fit best near ``start``, and the derivatives there."""
    start[2] = np.clip(start[2], reach[0] + 1e-6, reach[1] - 1e-6)
    found = least_squares(
        lambda p: _model(t, shape, p)[0] - values,
        start,
        lambda p: _model(t, shape, p)[1],
        bounds=([-np.inf, -np.inf, reach[0]], [np.inf, np.inf, reach[1]]),
        x_scale="jac",
        ftol=1e-12,
        xtol=1e-12,
        gtol=None,
    )
    return found.x, found.jac
