"""Curves of friction over speed out of a result: at a normal force, or at an indentation."""

from collections.abc import Callable
from itertools import product
from typing import NamedTuple

import numpy as np
import xarray as xr
from scipy.interpolate import PchipInterpolator

from .collapse import LEAST_POINTS, Curve

LARGEST_ERROR = 0.3  # relative standard error of mu up to which a point is used
INDENTATIONS = (-0.6, -0.3, 0.0, 0.3, 0.6)  # in rms roughnesses, over the mean line


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
