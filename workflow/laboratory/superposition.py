"""Shifts of sweeps at several temperatures to one master curve: a_T, b_T and their errors.

b_T G*(omega, T) = G*(omega a_T, T_ref): at T, times are a_T times longer and, on request, moduli
b_T times smaller. First guess: mean distance of adjacent sweeps along log omega at equal moduli
(the closed-form shifting of Gergesova et al., J. Rheol. 55, 1 (2011), doi:10.1122/1.3503529,
ISO 18437-6). Then all shifts are varied together until one Prony series on a dense grid of times
describes all sweeps best. G' and G'' are fitted together. The residual contains the misfit of the
series besides noise, so neither theory of estimate.py applies. Its mean square per degree of
freedom is taken as the variance of the data, as usual in least squares. Since both shifts move a
power law in the same way, log10 b_T has a prior of 0 +- LIKELY_DECADES. The series is eliminated by
variable projection (Kaufman, BIT 15, 49 (1975)).

Two packages with the same purpose were not used. pyvisco 2.1 requires JupyterLab, Voila and
IPython, shifts pair by pair by a power law of G' alone, and states no errors. mastercurves 0.2.3 of
2023 is under GPL and requires scikit-learn and pandas; its Gaussian process ignores the relation of
G' and G''.
"""

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from scipy.optimize import least_squares

from .prony_fit import TIME_MARGIN, MeasuredModuli, grid_of_times, measured_moduli, solved

TIME_GRID_MARGIN = 10.0  # factor by which the grid of times allows shifts to leave the first guess
TIMES_PER_DECADE = 16  # fine enough not to affect the shifts
LIKELY_DECADES = 0.1  # standard deviation of log10 b_T; density times temperature varies less
MODULUS_LEVELS = 50  # number of moduli at which distances of sweeps are taken
Sweep = tuple[np.ndarray, np.ndarray]  # omega in rad/s, G* (or 1/t, G(t)), shapes (n,)


class Superposition(NamedTuple):
    """Shifts of sweeps; arrays are 0 at the reference, of shape (sweeps,) or (sweeps, sweeps)."""

    decades: np.ndarray  # log10 a_T
    vertical: np.ndarray  # log10 b_T
    covariance: np.ndarray  # of the decades
    vertical_errors: np.ndarray
    rms: float  # of the relative residual of all moduli

    @property
    def errors(self) -> np.ndarray:
        """Return the standard errors of the decades."""
        return np.sqrt(np.diag(self.covariance))


def superposed(
    temperatures: np.ndarray, sweeps: Sequence[Sweep], reference: int, vertical: bool = False
) -> Superposition:
    """Fit the shifts that superpose sweeps on one master curve.

    temperatures : °C, of each sweep, ascending, for messages. reference : index of the sweep that
    is not shifted. vertical : whether moduli are shifted as well. Raises ValueError for adjacent
    sweeps without a common modulus.
    """
    first = _first_guess(temperatures, sweeps)
    first -= first[reference]
    omega = np.concatenate([w * 10.0**s for (w, _), s in zip(sweeps, first, strict=True)])
    reach = np.array([omega.min() / TIME_GRID_MARGIN, omega.max() * TIME_GRID_MARGIN])
    grid = grid_of_times(reach, TIME_MARGIN, TIMES_PER_DECADE)
    moduli = np.concatenate([values for _, values in sweeps])
    unit = float(np.abs(moduli).max())
    owner = np.repeat(np.arange(len(sweeps)), [w.size for w, _ in sweeps])
    free = np.delete(np.arange(len(sweeps)), reference)
    raw = np.concatenate([w for w, _ in sweeps]), moduli / unit

    def projected(p: np.ndarray, prior: float) -> tuple[np.ndarray, np.ndarray, int]:
        """Return residual, its Jacobian and the number of branches. p : shifts in decades."""
        shifts = np.zeros((2, len(sweeps)))
        shifts[: p.size // free.size, free] = p.reshape(-1, free.size)
        across, up = 10.0 ** shifts[:, owner]
        data = measured_moduli(raw[0] * across, raw[1] * up, 1.0)
        residual, jacobian, branches = _projected(data, grid, owner, free, p.size > free.size)
        weak = prior * np.eye(p.size)[free.size :]
        return np.concatenate([residual, weak @ p]), np.vstack([jacobian, weak]), branches

    def fitted(start: np.ndarray, prior: float = 0.0) -> np.ndarray:
        parts = (lambda p, n=n: projected(p, prior)[n] for n in (0, 1))
        solution: np.ndarray = least_squares(next(parts), start, next(parts), xtol=1e-10).x
        return solution

    prior, p = 0.0, fitted(first[free])
    if vertical:
        prior = float(np.sqrt(np.mean(projected(p, 0.0)[0] ** 2))) / LIKELY_DECADES
        p = fitted(np.concatenate([p, np.zeros(free.size)]), prior)
    residual, jacobian, branches = projected(p, prior)
    freedom = max(residual.size - branches - p.size, 1)
    covariance = np.linalg.pinv(jacobian.T @ jacobian, hermitian=True)
    covariance *= residual @ residual / freedom
    whole = np.zeros((len(sweeps), len(sweeps)))
    whole[np.ix_(free, free)] = covariance[: free.size, : free.size]
    solution, errors = np.zeros((2, len(sweeps))), np.zeros(len(sweeps))
    solution[: 1 + vertical, free] = p.reshape(-1, free.size)
    errors[free] = np.sqrt(np.diag(covariance))[free.size :] if vertical else 0.0
    rms = float(np.sqrt(residual @ residual / moduli.size))
    return Superposition(solution[0], solution[1], whole, errors, rms)


def _projected(
    data: MeasuredModuli, grid: np.ndarray, owner: np.ndarray, free: np.ndarray, vertical: bool
) -> tuple[np.ndarray, np.ndarray, int]:
    """Return the residual of the best series, its Jacobian by shifts, and the number of branches.

    owner : index of the sweep of each modulus. The Jacobian is projected orthogonal to all changes
    that the series can make.
    """
    solution, _ = solved(data, grid)
    columns, slopes = data.weighted(grid)
    model = columns @ solution
    values = [slopes @ solution[1:], -model] if vertical else [slopes @ solution[1:]]
    mask = np.resize(owner, model.size)[:, None] == free  # repeated for the imaginary parts
    jacobian = np.log(10.0) * np.hstack([mask * column[:, None] for column in values])
    active = solution > 0.0
    basis, _ = np.linalg.qr(np.hstack([columns[:, active], slopes[:, active[1:]]]))
    jacobian -= basis @ (basis.T @ jacobian)
    return model - data.wanted, jacobian, int(active.sum())


def _first_guess(temperatures: np.ndarray, sweeps: Sequence[Sweep]) -> np.ndarray:
    """Return log10 a_T from mean distances of adjacent sweeps at equal moduli; the first is 0."""
    curves = [(np.sort(np.log10(np.abs(g))), np.sort(np.log10(w))) for w, g in sweeps]
    shifts = [0.0]
    for place, ((cold, cold_omega), (warm, warm_omega)) in enumerate(pairwise(curves)):
        low, high = max(cold[0], warm[0]), min(cold[-1], warm[-1])
        if not high > low:
            one, two = temperatures[place], temperatures[place + 1]
            raise ValueError(
                f"the sweeps at {one:g} and {two:g} °C have no modulus in common, |G| to "
                f"{10.0 ** min(cold[-1], warm[-1]):.3g} and from {10.0**low:.3g} Pa: they can be "
                "shifted by no overlap; measure in between"
            )
        levels = np.linspace(low, high, MODULUS_LEVELS)
        distance = np.interp(levels, cold, cold_omega) - np.interp(levels, warm, warm_omega)
        shifts.append(shifts[-1] + float(distance.mean()))
    return np.array(shifts)
