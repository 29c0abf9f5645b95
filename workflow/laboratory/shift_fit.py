"""Fit of a law to the shifts of sweeps with the temperature: WLF, Arrhenius, or the table itself.

WLF is linear in c1 for a given c2, and Arrhenius in the activation energy. Residuals are those of
the differences from the sweep that was not shifted, with their full covariance, so the result does
not depend on the choice of that sweep.
"""

from typing import NamedTuple

import numpy as np
from scipy.optimize import minimize_scalar

from ...kernels import (
    GAS_CONSTANT,
    Arrhenius,
    ShiftLaw,
    ShiftTable,
    Wlf,
    inverse_temperature,
)

LOG_POLES = np.log(np.geomspace(1.0, 2000.0, 80))  # log of K below the coldest sweep: trial T_0
MIN_TEMPERATURES = {"wlf": 4, "arrhenius": 3}  # two more than there are constants
SHIFT_ROUNDING_DECADES = 1e-3  # decades, added in quadrature to the error of a shift
CLOSE_DECADES = 0.05  # decades: allowed deviation of a law from a shift with a small error
MAX_SHIFT_ERRORS = 3.0  # standard errors: allowed deviation of a law from a shift


class ShiftFit(NamedTuple):
    """A law, its constants with errors, and its deviation from the shifts."""

    law: ShiftLaw
    errors: tuple[float, ...]  # of c1 and of c2 (K), or of E_a (J/mol); () for a table
    decades: np.ndarray  # log10 a_T of each sweep, 0 at the reference; shape (sweeps,)
    worst: float  # decades: largest deviation of the law from a shift
    scatter: float  # sum of squares over variances, per degree of freedom
    holds: bool  # whether every shift is met within CLOSE_DECADES or MAX_SHIFT_ERRORS errors


def fit_shifts(
    temperatures: np.ndarray,
    decades: np.ndarray,
    covariance: np.ndarray,
    reference: float,
    law: str | None = None,
) -> ShiftFit:
    """Return the law that fits the shifts with the least scatter, or their table if none fits.

    temperatures : °C, ascending, shape (sweeps,). decades : log10 a_T, 0 at one of them.
    covariance : shape (sweeps, sweeps). reference : °C, where a_T is 1, within the temperatures.
    law : one of SHIFT_KEYS, to require that law. Raises ValueError if a required law has fewer
    temperatures than MIN_TEMPERATURES, or if the shifts rise with the temperature.
    """
    laws = {"wlf": _wlf_fit, "arrhenius": _arrhenius_fit}
    candidates = [n for n in laws if law in (None, n) and temperatures.size >= MIN_TEMPERATURES[n]]
    every = temperatures, decades, reference
    fits = (laws[name](*every, _weighted(covariance)) for name in candidates)
    successful = [fit for fit in fits if fit is not None]
    if law in laws and not successful:
        raise ValueError(
            f"{temperatures.size} temperatures do not determine a law {law}: it needs "
            f"{MIN_TEMPERATURES[law]}, and times that fall with the temperature"
        )
    successful = [fit for fit in successful if law is not None or fit.holds]
    if successful:
        return min(successful, key=lambda fit: fit.scatter)
    table = decades - np.interp(reference, temperatures, decades)
    rows = tuple(zip(temperatures.tolist(), table.tolist(), strict=True))
    return ShiftFit(ShiftTable(rows), (), table, 0.0, 0.0, holds=True)


class _Weighted(NamedTuple):
    """Weights that express differences of shifts in standard errors."""

    free: np.ndarray  # mask of the sweeps that were shifted, shape (sweeps,)
    root: np.ndarray  # square root of the inverse covariance of their shifts
    errors: np.ndarray  # standard errors of the shifts of all sweeps

    def off(self, values: np.ndarray) -> np.ndarray:
        """Return values at the shifted sweeps minus that at the fixed one, in standard errors."""
        return self.root @ (values[self.free] - values[~self.free][0])


def _weighted(covariance: np.ndarray) -> _Weighted:
    free = np.diag(covariance) > 0.0
    weighting = covariance[np.ix_(free, free)] + SHIFT_ROUNDING_DECADES**2 * np.eye(int(free.sum()))
    return _Weighted(
        free, np.linalg.cholesky(np.linalg.inv(weighting)).T, np.sqrt(np.diag(covariance))
    )


def _wlf_fit(
    temperatures: np.ndarray, decades: np.ndarray, reference: float, weighting: _Weighted
) -> ShiftFit | None:
    """Return the best WLF law, or None if shifts rise with the temperature."""
    wanted, above = weighting.off(decades), temperatures - reference
    coldest = reference - float(temperatures.min())

    def squares(log_pole: float) -> float:
        column = weighting.off(-above / (coldest + np.exp(log_pole) + above))
        return float(wanted @ wanted - (column @ wanted) ** 2 / (column @ column))

    near = LOG_POLES[np.argmin([squares(pole) for pole in LOG_POLES[1:-1]]) + np.arange(3)]
    c2 = coldest + float(np.exp(minimize_scalar(squares, bounds=near[[0, 2]], method="bounded").x))
    column = weighting.off(-above / (c2 + above))
    c1 = float(column @ wanted / (column @ column))
    if not c1 > 0.0:
        return None
    slopes = [column, weighting.off(c1 * above / (c2 + above) ** 2)]
    return _fit_of(Wlf(c1, c2, reference), np.array(slopes), weighting, temperatures, decades)


def _arrhenius_fit(
    temperatures: np.ndarray, decades: np.ndarray, reference: float, weighting: _Weighted
) -> ShiftFit | None:
    """Return the best Arrhenius law, or None if shifts rise with the temperature."""
    wanted = weighting.off(decades)
    slope = weighting.off(
        inverse_temperature(temperatures, reference) / (GAS_CONSTANT * np.log(10.0))
    )
    energy = float(slope @ wanted / (slope @ slope))
    if not energy > 0.0:
        return None
    return _fit_of(Arrhenius(energy, reference), slope[None], weighting, temperatures, decades)


def _fit_of(
    law: Wlf | Arrhenius,
    slopes: np.ndarray,
    weighting: _Weighted,
    temperatures: np.ndarray,
    decades: np.ndarray,
) -> ShiftFit:
    """Return a law with its errors. slopes : weighted derivatives with respect to its constants."""
    values = np.array([law.decades(t) for t in temperatures.tolist()])
    off = weighting.off(values - decades)
    scatter = float(off @ off) / (off.size - len(slopes))
    covariance = np.linalg.pinv(slopes @ slopes.T, hermitian=True) * max(scatter, 1.0)
    close = np.maximum(CLOSE_DECADES, MAX_SHIFT_ERRORS * weighting.errors)
    missed = decades - decades[~weighting.free][0] - (values - values[~weighting.free][0])
    return ShiftFit(
        law=law,
        errors=tuple(np.sqrt(np.diag(covariance)).tolist()),
        decades=decades - decades[~weighting.free][0] + values[~weighting.free][0],
        worst=float(np.abs(missed).max()),
        scatter=scatter,
        holds=bool(np.all(np.abs(missed) <= close)),
    )
