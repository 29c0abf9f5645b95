"""Shift of curves of friction over speed onto a reference curve.

A curve is log10 mu over log10 v. Each curve is shifted by s along log v and, optionally, by t along
log mu. All values of ``SHIFTS`` are tried for s, with t the mean difference; the result is the s
with the smallest rms difference from the reference, which is interpolated by monotone cubics
(Fritsch and Carlson 1980, doi:10.1137/0717021). Only points within the speed range of the reference
count, and at least the share ``OVERLAP`` of each curve must lie there; the other points are left
out and counted. No point is chosen by hand.
"""

from collections.abc import Callable
from itertools import product
from typing import NamedTuple

import numpy as np
import xarray as xr
from scipy.interpolate import PchipInterpolator

from elastomer_friction.workflow.report import not_resolved

SHIFTS = np.arange(-500, 501) * 0.01  # decades of speed
OVERLAP = 2.0 / 3.0  # smallest share of the points of a curve within the reference
MIN_POINTS = 4
MAX_FRICTION_ERROR = 0.3  # relative standard error of mu up to which a point is used
INDENTATIONS = (-0.6, -0.3, 0.0, 0.3, 0.6)  # in rms roughnesses, over the mean line
UNSHIFTED, ALONG_SPEED, ALONG_BOTH = "unshifted", "along speed", "along both"
SHIFT_MODES = (UNSHIFTED, ALONG_SPEED, ALONG_BOTH)


class Curve(NamedTuple):
    """Friction over speed with its standard error; all of shape (points,), speeds ascending."""

    x: np.ndarray  # log10 of the speed
    y: np.ndarray  # log10 of the coefficient of friction
    error: np.ndarray  # standard error of y


class Shift(NamedTuple):
    """Shift of one curve onto the reference, with its error and residual."""

    along_speed: float  # s, decades, added to x
    along_friction: float  # t, decades, added to y
    speed_error: float  # standard error of s, from the scatter about the reference
    squares: float  # residual sum of squares, decades squared
    points: int  # number of points within the range of the reference
    left_out: int  # number of points beyond it


class Collapse(NamedTuple):
    """All curves of a set on one reference."""

    shifts: tuple[Shift, ...]

    @property
    def rms(self) -> float:
        """Rms residual over all points within the reference, in decades."""
        points = sum(shift.points for shift in self.shifts)
        squares = sum(shift.squares for shift in self.shifts)
        return float(np.sqrt(squares / points)) if points else float("nan")

    @property
    def left_out(self) -> int:
        """Number of points beyond the reference after the shift."""
        return sum(shift.left_out for shift in self.shifts)


def collapse(curves: list[Curve], reference: Curve, mode: str) -> Collapse:
    """Return the shifts of all curves onto the reference. mode : a value of SHIFT_MODES."""
    tried = np.zeros(1) if mode == UNSHIFTED else SHIFTS
    return Collapse(tuple(best(curve, reference, tried, mode == ALONG_BOTH) for curve in curves))


def best(curve: Curve, reference: Curve, tried: np.ndarray, vertically: bool) -> Shift:
    """Return the shift with the smallest rms difference among those tried along speed."""
    law = PchipInterpolator(reference.x, reference.y, extrapolate=False)
    moved = curve.x + tried[:, None]
    gap = law(moved) - curve.y  # NaN beyond the reference
    points = np.isfinite(gap).sum(axis=1)
    enough = points >= max(MIN_POINTS, OVERLAP * curve.x.size)
    if not enough.any():
        nan = float("nan")
        return Shift(nan, nan, nan, 0.0, 0, curve.x.size)
    share = np.maximum(points, 1)
    lift = np.nansum(gap, axis=1) / share if vertically else np.zeros(tried.size)
    squares = np.nansum((gap - lift[:, None]) ** 2, axis=1)
    k = int(np.argmin(np.where(enough, squares / share, np.inf)))
    n, error = int(points[k]), float("nan")
    slope = law(moved[k], 1)
    slope = slope[np.isfinite(slope)]
    spread, freedom = slope - slope.mean() * vertically, n - 1 - vertically
    if tried.size > 1 and freedom > 0 and np.any(spread):  # by least squares, linearised
        error = float(np.sqrt(squares[k] / freedom / np.sum(spread**2)))
    return Shift(float(tried[k]), float(lift[k]), error, float(squares[k]), n, curve.x.size - n)


class Place(NamedTuple):
    """Parameters of a curve."""

    pressed: float  # normal force, N, or indentation in rms roughnesses
    temperature: float  # °C
    size: float  # length of the line over that of the smallest system


class Family(NamedTuple):
    """Curves over normal forces or indentations, temperatures and sizes."""

    places: list[Place]
    curves: list[Curve]
    left_out: int  # number of points that are NaN, too inexact, or on a curve of too few points

    def reference(self) -> int:
        """Return the index of the reference curve.

        It is the smallest system at the highest temperature, at the middle of its forces or
        indentations.
        """
        warm, size = max(p.temperature for p in self.places), min(p.size for p in self.places)
        known = [k for k, p in enumerate(self.places) if p[1:] == (warm, size)]
        return known[len(known) // 2]


def at_forces(dataset: xr.Dataset) -> Family:
    """Return mu over speed at every normal force, temperature and size."""
    rows = []
    for temperature, size, part in _parts(dataset):
        for force in dataset.normal_force.values:
            points = part.sel(normal_force=force)
            place = Place(float(force), temperature, size)
            relative = (points.mu_1_error / points.mu_1).values
            rows.append((place, points.speed.values, points.mu_1.values, relative))
    return _family(rows)


def at_indentations(dataset: xr.Dataset) -> Family:
    """Return mu over speed at several indentations, if the forces of the grid reach them.

    log mu at an indentation is interpolated between the normal forces of the grid (monotone cubics
    in the mean indentation, which grows with the force at every speed).
    """
    rows = []
    for temperature, size, part in _parts(dataset):
        part = part.transpose("velocity", "normal_force")
        depth = (part.indentation / part.roughness).values
        relative = (part.mu_1_error / part.mu_1).values
        laws = [
            _over_depth(*columns) for columns in zip(depth, part.mu_1.values, relative, strict=True)
        ]
        for indentation in INDENTATIONS:
            values = np.array([law(indentation) for law in laws])
            place = Place(indentation, temperature, size)
            rows.append((place, part.speed.values, 10.0 ** values[:, 0], values[:, 1]))
    return _family(rows)


def _parts(dataset: xr.Dataset) -> list[tuple[float, float, xr.Dataset]]:
    """Return (temperature, size, estimates over force and speed) of systems of one spacing.

    A spacing dx of the grid represents a system that is s = dx_max/dx times as long as the
    smallest, with the speed s v and the friction s^(H-1) mu (study.toml).
    """
    chosen = dataset[["mu_1", "mu_1_error", "indentation"]]
    squeezed = chosen.squeeze(["hurst", "roughness", "velocity_step"])
    size = squeezed.spacing.max() / squeezed.spacing
    slope = size ** (squeezed.hurst - 1.0)
    scaled = {name: squeezed[name] * slope for name in ("mu_1", "mu_1_error")}
    points = squeezed.assign(scaled).assign(speed=squeezed.velocity * size)
    return [
        (float(t), float(size.sel(spacing=dx)), points.sel(temperature=t, spacing=dx))
        for t, dx in product(points.temperature.values, points.spacing.values)
    ]


def _over_depth(
    depth: np.ndarray, mu: np.ndarray, relative: np.ndarray
) -> Callable[[float], tuple[float, float]]:
    """Return the function indentation -> (log10 mu, relative error), NaN beyond the forces."""
    sound = np.isfinite(depth) & (mu > 0.0) & (relative < MAX_FRICTION_ERROR)
    order = np.argsort(depth[sound])
    x = depth[sound][order]
    if x.size < MIN_POINTS or np.any(np.diff(x) <= 0.0):
        return lambda _: (float("nan"), float("nan"))
    level = PchipInterpolator(x, np.log10(mu[sound][order]), extrapolate=False)
    error = PchipInterpolator(x, relative[sound][order], extrapolate=False)
    return lambda wanted: (float(level(wanted)), float(error(wanted)))


def _family(rows: list[tuple[Place, np.ndarray, np.ndarray, np.ndarray]]) -> Family:
    """Return the curves with at least four points, and the number of points left out."""
    places, curves, left_out = [], [], 0
    for place, speed, mu, relative in rows:
        sound = np.isfinite(mu) & (relative < MAX_FRICTION_ERROR)
        if sound.sum() < MIN_POINTS:
            left_out += sound.size
            continue
        left_out += int((~sound).sum())
        error = relative[sound] / np.log(10.0)
        places.append(place)
        curves.append(Curve(np.log10(speed[sound]), np.log10(mu[sound]), error))
    return Family(places, curves, left_out)


class Collapsed(NamedTuple):
    """Curves of one material at given forces or indentations, with their collapses."""

    family: Family
    collapses: dict[str, Collapse]  # by shift mode


def resolved(dataset: xr.Dataset) -> tuple[xr.Dataset, int]:
    """Return a result with NaN friction at unresolved points, and the number of these."""
    coarse = not_resolved(dataset)
    mu = dataset.mu_1.copy(data=np.where(coarse, np.nan, dataset.mu_1.values))
    masked = dataset.assign(mu_1=mu).drop_vars("resolution_status", errors="ignore")
    return masked, int(coarse.sum())


def remaining(dataset: xr.Dataset) -> dict[str, Collapsed]:
    """Return the collapses of the curves of a result, at given forces and at indentations."""
    collapsed = {}
    families = {"force": at_forces(dataset), "indentation": at_indentations(dataset)}
    for pressing, family in families.items():
        reference = family.curves[family.reference()]
        collapses = {mode: collapse(family.curves, reference, mode) for mode in SHIFT_MODES}
        collapsed[pressing] = Collapsed(family, collapses)
    return collapsed


def thermal(collapsed: Collapsed) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return temperatures, and shifts along speed relative to the highest one, with errors.

    Every pair of curves that differ only in temperature gives one value.
    """
    shifts = dict(zip(collapsed.family.places, collapsed.collapses[ALONG_BOTH].shifts, strict=True))
    warmest = max(place.temperature for place in shifts)
    rows = []
    for place, shift in shifts.items():
        warm = shifts.get(place._replace(temperature=warmest))
        if place.temperature < warmest and warm is not None and warm.points and shift.points:
            error = np.hypot(shift.speed_error, warm.speed_error)
            rows.append((place.temperature, shift.along_speed - warm.along_speed, error))
    table = np.array(rows).reshape(-1, 3)
    return table[:, 0], table[:, 1], table[:, 2]
