"""Fit of a Prony series with few branches to measured moduli G'(omega), G''(omega), or to G(t).

G* = G + sum_b g_b i omega t_b/(1 + i omega t_b) and G(t) = G + sum_b g_b exp(-t/t_b), with moduli
>= 0. For given times this is a least-squares problem with bounds (Lawson & Hanson 1974, chapter
23), whose solution on a dense grid of times is sparse. Neighbouring times are then merged, times
are refined, and branches are joined while the residual stays close to that on the grid. Residuals
of G' are relative to |G*|, and those of G'' to G'', since friction depends on it (Baumgaertel and
Winter, Rheol. Acta 28, 511 (1989), doi:10.1007/BF01332922), but at least to LOSS_FLOOR |G*|, as the
phase has an error too. For a relaxation test, 1/t takes the place of a frequency.

Branches may be up to ten times slower than the lowest frequency; slower ones count as relaxed. If
the data do not determine the relaxed modulus, its bounds are those with branches up to a hundred
times slower. If the fit has no relaxed modulus, half of its upper bound is taken.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from scipy.interpolate import BSpline, make_interp_spline
from scipy.optimize import least_squares, nnls

GRID_TIMES_PER_DECADE = 8  # times per decade of the dense grid
TIME_MARGIN = 10.0  # factor by which times extend beyond the inverse frequencies
MAX_RMS_GROWTH = 1.1  # growth of the rms residual allowed for fewer branches
GOOD_RMS = 1e-2  # rms residual that needs no improvement
LOSS_FLOOR = 0.1  # least scale of the residual of G'', over |G*|
BOUND_ERRORS = 3.0  # standard errors between the fit and a bound of the relaxed modulus
GRID_RMS_ERROR = 1e-4  # of the rms residual: error due to the spacing of the grid of times
MAX_BOUND_RATIO = 1.1  # of the bounds of a relaxed modulus that counts as determined
MIN_COMBINATION = 1e-10  # size of a combination of values, over the largest one
SPLINE_DEGREE = 7
ZERO_RELAXED_SHARE = 1e-6  # relaxed modulus, over its upper bound, up to which it counts as zero
RELAXED_TRIALS = np.linspace(0.0, 1.0, 41)  # of the relaxed modulus, over the largest one


# Function of omega t_b or t_b/t; returns the share of g_b in G* or G(t), and d share/d ln t_b.
Shares = Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]]


def in_oscillation(turn: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the share of g_b in G*, and d share/d ln t_b. turn : omega t_b, of any shape."""
    share = 1j * turn / (1.0 + 1j * turn)
    return share, share * (1.0 - share)


def in_relaxation(turn: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the share of g_b in G(t), and d share/d ln t_b. turn : t_b/t, of any shape."""
    share = np.exp(-1.0 / turn)
    return share, share / turn


class PronyFit(NamedTuple):
    """A fitted material and the quality of its fit."""

    shear_modulus: float  # relaxed, in the unit of the data
    branches: tuple[tuple[float, float], ...]  # (modulus, time), times ascending
    residual: np.ndarray  # |fit - G*|/|G*| at each frequency, shape (n,)
    loss_residual: np.ndarray  # |fit - G''|/G'' at each frequency, 0 without G'', shape (n,)
    dense: float  # rms of the residual of G* with all times of the dense grid
    slowest: float  # s, time beyond which every relaxation counts as complete
    least: float  # least, most : bounds of the relaxed modulus
    most: float

    @property
    def rms(self) -> float:
        """Return the rms of the relative residual of G*."""
        return float(np.sqrt(np.mean(self.residual**2)))

    @property
    def worst(self) -> float:
        """Return the largest relative residual of G*."""
        return float(self.residual.max())

    @property
    def determined(self) -> bool:
        """Return whether the bounds of the relaxed modulus differ by at most a tenth."""
        return self.most <= MAX_BOUND_RATIO * self.least


def fit_prony(omega: np.ndarray, moduli: np.ndarray, branches: int | None = None) -> PronyFit:
    """Fit a Prony series to complex moduli at angular frequencies, or to G(t).

    omega : rad/s, shape (n,), positive; for a relaxation test, 1/t. moduli : G' + i G'', shape
    (n,), or real G(t). branches : maximum number; by default the fewest that fit about as well as
    the dense grid. Raises ValueError for fewer than four frequencies, for a frequency or G' that is
    not positive, for G'' < 0, and for values that are not finite.
    """
    omega, moduli = np.asarray(omega, float), np.asarray(moduli)
    good = (omega > 0.0) & np.isfinite(moduli) & (moduli.real > 0.0) & (moduli.imag >= 0.0)
    if omega.size < 4 or not np.all(good):
        raise ValueError("needs four frequencies or more, all of them and G' above 0, no G'' below")
    unit = float(np.abs(moduli).max())
    measured = measured_moduli(omega, moduli / unit, LOSS_FLOOR)
    data = condensed(measured)
    grid = grid_of_times(omega, TIME_MARGIN)
    series, best = solved(data, grid)
    dense = measured.residual(grid, series)
    least, most = _bounds(data, grid, best)
    if most > MAX_BOUND_RATIO * least:
        least, most = _bounds(data, grid_of_times(omega, TIME_MARGIN**2), best)
    allowed, discarded = max(MAX_RMS_GROWTH * best, GOOD_RMS), 0.0
    times, series, rms = _few(data, grid, allowed, branches)
    if series[0] <= ZERO_RELAXED_SHARE * most:
        discarded = 0.5 * most
        measured = measured._replace(moduli=measured.moduli - discarded)
        data = data._replace(wanted=data.wanted - discarded * data.relaxed)
        times, series, rms = _few(data, grid, allowed, branches)
    positive = series[1:] > 0.0
    residual, loss = measured.residual(times, series), np.imag(moduli)
    share = np.divide(np.abs(moduli), loss, where=loss > 0.0, out=np.zeros(omega.size))
    pairs = zip((unit * series[1:][positive]).tolist(), times[positive].tolist(), strict=True)
    relaxed = discarded + float(series[0])
    within = rms <= allowed  # if false, branches are too few to determine the relaxed modulus
    return PronyFit(
        shear_modulus=unit * relaxed,
        branches=tuple(pairs),
        residual=np.abs(residual),
        loss_residual=np.abs(residual.imag) * share,
        dense=float(np.sqrt(np.mean(np.abs(dense) ** 2))),
        slowest=float(grid[-1]),
        least=unit * (min(least, relaxed) if within else least),
        most=unit * (max(most, relaxed) if within else most),
    )


def _few(
    data: "CondensedModuli", grid: np.ndarray, allowed: float, most: int | None
) -> tuple[np.ndarray, np.ndarray, float]:
    """Fit few branches; return their times, all moduli (relaxed first) and the rms residual.

    allowed, most : see ``_joined``.
    """
    reach = np.log(grid[[0, -1]])
    times = _moved(data, _merged(grid, solved(data, grid)[0][1:]), reach)
    times = _moved(data, _joined(data, times, reach, allowed, most), reach)
    return times, *solved(data, times)


class MeasuredModuli(NamedTuple):
    """Data of a fit and scales of its residuals; arrays of shape (n,)."""

    omega: np.ndarray  # rad/s, or 1/t
    moduli: np.ndarray  # G* or G(t), minus the part of the relaxed modulus that is not fitted
    size: np.ndarray  # |G*|
    scale: np.ndarray  # of the residual of each value, G' before G'', shape (values,)
    shares: Shares

    def weighted(self, times: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return relative moduli per unit of G and of each g_b, and derivatives by ln t_b.

        Real and imaginary parts are separate rows: shapes (values, 1 + branches) and (values,
        branches).
        """
        columns, slopes = self._unweighted(times)
        return _parts(columns) / self.scale[:, None], _parts(slopes) / self.scale[:, None]

    def _unweighted(self, times: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        columns, slopes = self.shares(self.omega[:, None] * times)
        return np.hstack([np.ones((self.omega.size, 1)), columns]), slopes

    @property
    def wanted(self) -> np.ndarray:
        """Return the relative moduli, shape (values,)."""
        return _parts(self.moduli) / self.scale

    def residual(self, times: np.ndarray, series: np.ndarray) -> np.ndarray:
        """Return (series - G*)/|G*|, shape (n,). series : relaxed modulus, then the g_b."""
        return (self._unweighted(times)[0] @ series - self.moduli) / self.size


class CondensedModuli(NamedTuple):
    """Data of a fit as the few combinations of values that contain every series and the moduli.

    They have the same least squares as all values, in matrices so small that a library of linear
    algebra starts no threads for them, which would wait for most of the time. Shapes (rows,).
    """

    relaxed: np.ndarray  # relative moduli per unit of G
    wanted: np.ndarray  # relative moduli
    curves: BSpline  # those per unit of g_b, as a function of ln t_b
    size: np.ndarray  # |G*|, shape (n,)
    values: int  # number of values before

    def weighted(self, times: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return what ``MeasuredModuli.weighted`` does, in fewer rows."""
        columns, slopes = (self.curves(np.log(times), order).T for order in (0, 1))
        return np.column_stack([self.relaxed, columns]), slopes


def condensed(data: MeasuredModuli) -> CondensedModuli:
    """Return the combinations of values; the curves agree with the shares to about 1e-9."""
    grid = grid_of_times(data.omega, TIME_MARGIN**2, 2 * GRID_TIMES_PER_DECADE)
    columns = np.column_stack([data.wanted, data.weighted(grid)[0]])
    basis, sizes, _ = np.linalg.svd(columns / np.linalg.norm(columns, axis=0), full_matrices=False)
    wanted, relaxed, *shares = (basis[:, sizes > MIN_COMBINATION * sizes[0]].T @ columns).T
    curves = make_interp_spline(np.log(grid), np.array(shares), SPLINE_DEGREE)
    return CondensedModuli(relaxed, wanted, curves, data.size, data.wanted.size)


def measured_moduli(omega: np.ndarray, moduli: np.ndarray, loss_floor: float) -> MeasuredModuli:
    """Return the data of a fit; real moduli are those of a relaxation test.

    loss_floor : least scale of the residual of G'', over |G*|; 1 treats G'' as G'.
    """
    size = np.abs(moduli)
    if not np.iscomplexobj(moduli):
        return MeasuredModuli(omega, moduli, size, size, in_relaxation)
    scale = np.concatenate([size, np.maximum(moduli.imag, loss_floor * size)])
    return MeasuredModuli(omega, moduli, size, scale, in_oscillation)


def grid_of_times(
    omega: np.ndarray, beyond: float, per_decade: int = GRID_TIMES_PER_DECADE
) -> np.ndarray:
    """Return the dense grid of times, up to ``beyond`` / (lowest frequency)."""
    first, last = 1.0 / (TIME_MARGIN * omega.max()), beyond / omega.min()
    return np.geomspace(first, last, int(np.ceil(per_decade * np.log10(last / first))) + 1)


def _parts(values: np.ndarray) -> np.ndarray:
    if not np.iscomplexobj(values):
        return values
    return np.concatenate([values.real, values.imag])


def solved(
    data: MeasuredModuli | CondensedModuli, times: np.ndarray, relaxed: float | None = None
) -> tuple[np.ndarray, float]:
    """Fit moduli >= 0 at given times; return them, shape (1 + branches,), and the rms residual.

    relaxed : given relaxed modulus, or None to fit it.
    """
    columns, wanted = data.weighted(times)[0], data.wanted
    fixed = np.zeros(0)
    if relaxed is not None:
        wanted = wanted - relaxed * columns[:, 0]
        columns, fixed = columns[:, 1:], np.array([relaxed])
    scale = np.linalg.norm(columns, axis=0)
    columns = columns / scale
    square, projected = columns, wanted
    if columns.shape[0] > 4 * columns.shape[1]:  # solve with the triangular factor
        basis, square = np.linalg.qr(columns)
        projected = basis.T @ wanted
    moduli, _ = nnls(square, projected, maxiter=100 * scale.size)
    residual = np.linalg.norm(columns @ moduli - wanted)
    return np.concatenate([fixed, moduli / scale]), float(residual / np.sqrt(data.size.size))


def _merged(grid: np.ndarray, moduli: np.ndarray) -> np.ndarray:
    """Merge adjacent grid times with nonzero moduli, over at most half a decade."""
    runs: list[list[int]] = []
    for i in np.flatnonzero(moduli > 0.0).tolist():
        if runs and i == runs[-1][-1] + 1 and len(runs[-1]) < GRID_TIMES_PER_DECADE // 2:
            runs[-1].append(i)
        else:
            runs.append([i])
    means = [np.average(np.log(grid[run]), weights=moduli[run]) for run in runs]
    return np.exp(np.array(means))


def _moved(data: CondensedModuli, times: np.ndarray, reach: np.ndarray) -> np.ndarray:
    """Refine times by least squares, starting from the given ones.

    reach : logarithms of the shortest and the longest time.
    """
    moduli, _ = solved(data, times)
    some = np.concatenate([[True], moduli[1:] > 0.0])
    moduli, times = np.maximum(moduli[some], 1e-12), times[some[1:]]
    if not times.size:
        return times

    def residual(logs: np.ndarray) -> np.ndarray:
        columns, _ = data.weighted(np.exp(logs[moduli.size :]))
        return columns @ np.exp(logs[: moduli.size]) - data.wanted

    def slopes(logs: np.ndarray) -> np.ndarray:
        values = np.exp(logs[: moduli.size])
        columns, later = data.weighted(np.exp(logs[moduli.size :]))
        return np.hstack([columns * values, later * values[1:]])

    free = np.full(moduli.size, 50.0)  # bound of |ln modulus|
    bounds = [
        np.concatenate([side * free, np.full(times.size, end)])
        for side, end in zip((-1.0, 1.0), reach, strict=True)
    ]
    start = np.concatenate(
        [np.log(moduli), np.clip(np.log(times), reach[0] + 1e-6, reach[1] - 1e-6)]
    )
    moved = least_squares(residual, start, slopes, bounds=bounds, max_nfev=100).x
    return np.sort(np.exp(moved[moduli.size :]))


def _joined(
    data: CondensedModuli, times: np.ndarray, reach: np.ndarray, allowed: float, most: int | None
) -> np.ndarray:
    """Join adjacent times, or drop an end one, while the rms residual is at most ``allowed``.

    most : maximum number of times, whatever the rms; None: no maximum.
    """
    while times.size > 1:
        middles = np.sqrt(times[1:] * times[:-1])
        trials = [np.delete(times, i) for i in (0, times.size - 1)]
        trials += [np.insert(np.delete(times, [i, i + 1]), i, t) for i, t in enumerate(middles)]
        nearest = sorted(trials, key=lambda trial: solved(data, trial)[1])
        fewer = nearest[0]
        if solved(data, fewer)[1] > allowed:
            moved = [_moved(data, trial, reach) for trial in nearest[:2]]
            fewer = min(moved, key=lambda trial: solved(data, trial)[1])
        too_many = most is not None and times.size > most
        if not too_many and solved(data, fewer)[1] > allowed:
            break
        times = fewer
    return times


def _bounds(data: CondensedModuli, grid: np.ndarray, best: float) -> tuple[float, float]:
    """Return the smallest and the largest relaxed modulus within three standard errors.

    There the sum of squares exceeds its minimum by nine times the mean square.
    """
    allowed = best * np.sqrt(1.0 + BOUND_ERRORS**2 / data.values) + GRID_RMS_ERROR
    top = 1.05 * float(np.min(data.size))
    tried = top * RELAXED_TRIALS
    fits = [relaxed for relaxed in tried if solved(data, grid, relaxed)[1] <= allowed]
    return (float(min(fits)), float(max(fits))) if fits else (np.inf, 0.0)
