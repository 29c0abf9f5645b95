"""Shift curves of friction over speed onto one: the rule, how well it does, what is known of it.

A curve is log10 mu over log10 v. Every curve is shifted onto one reference curve, by s along log v
and, where that is asked for, by t along log mu. s is tried at every value of ``SHIFTS``; t is then
the mean difference; chosen is the s of the least rms difference from the reference, which is
interpolated between its points (monotone cubics, Fritsch and Carlson 1980,
doi:10.1137/0717021). Only points within the reference's range of speeds count, and of every
curve at least ``OVERLAP`` of its points must; the others are left out and counted. No point is
chosen by hand.
"""

from collections.abc import Callable
from itertools import product
from typing import NamedTuple

import numpy as np
import xarray as xr
from scipy.interpolate import PchipInterpolator

from elastomer_friction.workflow.report import not_resolved

SHIFTS = np.arange(-500, 501) * 0.01  # decades of speed
OVERLAP = 2.0 / 3.0
LEAST_POINTS = 4
LARGEST_ERROR = 0.3  # relative standard error of mu up to which a point is used
INDENTATIONS = (-0.6, -0.3, 0.0, 0.3, 0.6)  # in rms roughnesses, over the mean line
UNSHIFTED, ALONG_SPEED, ALONG_BOTH = "unshifted", "along speed", "along both"
WAYS = (UNSHIFTED, ALONG_SPEED, ALONG_BOTH)


class Curve(NamedTuple):
    """Friction over speed with its standard error; all of shape (points,), speeds ascending."""

    x: np.ndarray  # log10 of the speed
    y: np.ndarray  # log10 of the coefficient of friction
    error: np.ndarray  # standard error of y


class Shift(NamedTuple):
    """How one curve comes onto the reference."""

    along_speed: float  # s, decades, added to x
    along_friction: float  # t, decades, added to y
    speed_error: float  # standard error of s, from the scatter about the reference
    squares: float  # sum of squares of the differences that remain, decades squared
    points: int  # that lie within the range of the reference
    left_out: int


class Collapse(NamedTuple):
    """All curves of a set on one reference."""

    shifts: tuple[Shift, ...]

    @property
    def rms(self) -> float:
        """Root of the mean square of what remains over all points that count, in decades."""
        points = sum(shift.points for shift in self.shifts)
        squares = sum(shift.squares for shift in self.shifts)
        return float(np.sqrt(squares / points)) if points else float("nan")

    @property
    def left_out(self) -> int:
        """Points that lie beyond the reference once they are shifted."""
        return sum(shift.left_out for shift in self.shifts)


def collapse(curves: list[Curve], reference: Curve, how: str) -> Collapse:
    """Return how all curves come onto the reference. how : UNSHIFTED, ALONG_SPEED, ALONG_BOTH."""
    tried = np.zeros(1) if how == UNSHIFTED else SHIFTS
    return Collapse(tuple(best(curve, reference, tried, how == ALONG_BOTH) for curve in curves))


def best(curve: Curve, reference: Curve, tried: np.ndarray, vertically: bool) -> Shift:
    """Return the shift, out of those that are tried along speed, of the least rms difference."""
    law = PchipInterpolator(reference.x, reference.y, extrapolate=False)
    moved = curve.x + tried[:, None]
    gap = law(moved) - curve.y  # NaN beyond the reference
    points = np.isfinite(gap).sum(axis=1)
    enough = points >= max(LEAST_POINTS, OVERLAP * curve.x.size)
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
    """To what a curve belongs."""

    pressed: float  # normal force (N), or indentation in rms roughnesses
    temperature: float  # °C
    size: float  # length of the line over that of the smallest system


class Family(NamedTuple):
    """Curves over normal forces or indentations, temperatures and sizes."""

    places: list[Place]
    curves: list[Curve]
    left_out: int  # points without a number, with too large an error, or in too short a curve

    def reference(self) -> int:
        """Return the number of the curve that the others are shifted onto.

        It is the smallest system at the highest temperature, in the middle of the forces or
        indentations that there are of it.
        """
        warm, size = max(p.temperature for p in self.places), min(p.size for p in self.places)
        known = [k for k, p in enumerate(self.places) if p[1:] == (warm, size)]
        return known[len(known) // 2]


def at_forces(dataset: xr.Dataset) -> Family:
    """Return mu over speed at every normal force, temperature and size."""
    points = _points(dataset)
    forces = dataset.normal_force.values
    found = []
    for temperature, size, part in _parts(points):
        for force in forces:
            one = part.sel(normal_force=force)
            place = Place(float(force), temperature, size)
            relative = (one.mu_1_error / one.mu_1).values
            found.append((place, one.speed.values, one.mu_1.values, relative))
    return _family(found)


def at_indentations(dataset: xr.Dataset) -> Family:
    """Return mu over speed at some indentations, wherever the forces of the grid reach them.

    log mu at an indentation is interpolated between the normal forces of the grid (monotone cubics
    in the mean indentation, which grows with the force at every speed).
    """
    points = _points(dataset)
    found = []
    for temperature, size, part in _parts(points):
        part = part.transpose("velocity", "normal_force")
        depth = (part.indentation / part.roughness).values
        relative = (part.mu_1_error / part.mu_1).values
        laws = [_over_depth(*each) for each in zip(depth, part.mu_1.values, relative, strict=True)]
        for wanted in INDENTATIONS:
            values = np.array([law(wanted) for law in laws])
            place = Place(wanted, temperature, size)
            found.append((place, part.speed.values, 10.0 ** values[:, 0], values[:, 1]))
    return _family(found)


def _points(dataset: xr.Dataset) -> xr.Dataset:
    """Return the estimates over force, temperature, spacing and speed, as systems of one spacing.

    A spacing dx of the grid stands for a system that is s = dx_max/dx times as long as the
    smallest, at the speed s v and with the friction s^(H-1) mu (study.toml).
    """
    chosen = dataset[["mu_1", "mu_1_error", "indentation"]]
    one = chosen.squeeze(["hurst", "roughness", "velocity_step"])
    size = one.spacing.max() / one.spacing
    slope = size ** (one.hurst - 1.0)
    return one.assign(
        mu_1=one.mu_1 * slope, mu_1_error=one.mu_1_error * slope, speed=one.velocity * size
    ).assign_coords(size=size)


def _parts(points: xr.Dataset) -> list[tuple[float, float, xr.Dataset]]:
    """Return (temperature, size, points over force and speed)."""
    return [
        (float(t), float(points["size"].sel(spacing=dx)), points.sel(temperature=t, spacing=dx))
        for t, dx in product(points.temperature.values, points.spacing.values)
    ]


def _over_depth(
    depth: np.ndarray, mu: np.ndarray, relative: np.ndarray
) -> Callable[[float], tuple[float, float]]:
    """Return the function indentation -> (log10 mu, relative error), NaN beyond the forces."""
    sound = np.isfinite(depth) & (mu > 0.0) & (relative < LARGEST_ERROR)
    order = np.argsort(depth[sound])
    x = depth[sound][order]
    if x.size < LEAST_POINTS or np.any(np.diff(x) <= 0.0):
        return lambda _: (float("nan"), float("nan"))
    level = PchipInterpolator(x, np.log10(mu[sound][order]), extrapolate=False)
    error = PchipInterpolator(x, relative[sound][order], extrapolate=False)
    return lambda wanted: (float(level(wanted)), float(error(wanted)))


def _family(found: list[tuple[Place, np.ndarray, np.ndarray, np.ndarray]]) -> Family:
    """Return the curves with at least four points each, and how many points are left out."""
    places, curves, left_out = [], [], 0
    for place, speed, mu, relative in found:
        sound = np.isfinite(mu) & (relative < LARGEST_ERROR)
        if sound.sum() < LEAST_POINTS:
            left_out += sound.size
            continue
        left_out += int((~sound).sum())
        error = relative[sound] / np.log(10.0)
        places.append(place)
        curves.append(Curve(np.log10(speed[sound]), np.log10(mu[sound]), error))
    return Family(places, curves, left_out)


class Collapsed(NamedTuple):
    """Curves of one material, pressed in one way, and how they collapse."""

    family: Family
    ways: dict[str, Collapse]  # UNSHIFTED, ALONG_SPEED, ALONG_BOTH


def resolved(dataset: xr.Dataset) -> tuple[xr.Dataset, int]:
    """Return a result without friction where contacts are not resolved, and how many points."""
    coarse = not_resolved(dataset)
    mu = dataset.mu_1.copy(data=np.where(coarse, np.nan, dataset.mu_1.values))
    kept = dataset.assign(mu_1=mu).drop_vars("resolution_status", errors="ignore")
    return kept, int(coarse.sum())


def remaining(dataset: xr.Dataset) -> dict[str, Collapsed]:
    """Return how the curves of a result collapse, at given forces and at given indentations."""
    found = {}
    for how, family in (("force", at_forces(dataset)), ("indentation", at_indentations(dataset))):
        onto = family.curves[family.reference()]
        ways = {way: collapse(family.curves, onto, way) for way in WAYS}
        found[how] = Collapsed(family, ways)
    return found


def thermal(found: Collapsed) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return temperatures, and the shift along speed from the highest one, with its error.

    Every pair of curves that differ in temperature alone gives one value.
    """
    shifts = dict(zip(found.family.places, found.ways[ALONG_BOTH].shifts, strict=True))
    warmest = max(place.temperature for place in shifts)
    rows = []
    for place, shift in shifts.items():
        warm = shifts.get(place._replace(temperature=warmest))
        if place.temperature < warmest and warm is not None and warm.points and shift.points:
            error = np.hypot(shift.speed_error, warm.speed_error)
            rows.append((place.temperature, shift.along_speed - warm.along_speed, error))
    table = np.array(rows).reshape(-1, 3)
    return table[:, 0], table[:, 1], table[:, 2]
