"""Measure the friction of a rigid sphere over its speed, on both bodies, beside known values.

At rest on the relaxed body the radius of contact is a = (3 F_N R/(4 E*))^(1/3). For v -> 0 a Kelvin
half-space has F_x = (4/3) E* tau v a^3/R^2, so that mu = v tau/R. All is in units of the cell:
lengths in its side, E* = 1.
"""

from collections.abc import Callable
from functools import partial

import numpy as np
import xarray as xr

from elastomer_friction.kernels import KELVIN, Case, Line, Quantities, Spectrum, run_case
from elastomer_friction.kernels.half_space.cases import run_case as run_on_half_space
from elastomer_friction.kernels.half_space.surface import Surface
from elastomer_friction.workflow.study import Key, integer

STEADY = Quantities(jump=False, relaxation=False)
CELL, MOST, PAST = 6.0, 24.0, 8.0  # side of the cell, in radii of contact at rest: see cell_at
FINE = 10.0  # samples in such a radius, at least, where the cell is longer than the shortest
SECONDS = 2e-5  # of a speed, for each sample of the map, in the mean
SLOW, FAST = 0.003, 10.0  # v tau/a
# Carbone and Putignano, J. Mech. Phys. Solids 61, 1822 (2013), fig. 12, as digitised: R = 1 cm,
# 0.15 N, E from 1 to 10 MPa with one time, nu = 0.3; v 10 ms/a and mu. The relaxed solid is E = 1
# MPa with one branch of 9 MPa and 1 ms. Third: radii a side, with which mu no longer changes.
PUBLISHED = ((0.106, 0.00851, 9.0), (1.169, 0.0403, 12.0), (7.943, 0.0159, 36.0))
SLS = Spectrum((9.0,), (1.0 / 9.0,), 0.0)  # tau = sum g t/G = 9 ms
RADIUS, FORCE, MODULUS, TIME = 0.01, 0.15, 1e6 / (1.0 - 0.3**2), 9e-3
SETTINGS = {  # docs/reference/measures.md says what they mean
    "side": Key(partial(integer, least=16)),
    "speeds": Key(partial(integer, least=2)),
    "published": Key(partial(integer, least=0)),
}


def outline(settings: dict) -> tuple[list[str], float]:
    """Return what would be measured, and the predicted seconds of one core."""
    count = settings["speeds"] + 3 * settings["published"]
    side = settings["side"]
    lines = [f"cell        {side} x {side} samples, {CELL:g} to {MOST:g} radii a side"]
    return lines, SECONDS * count * side**2


def measure(settings: dict, seed: int, advance: Callable[[float], None]) -> dict[str, xr.Dataset]:
    """Return the friction over the speed, and the published points with ours beside them."""
    speeds = np.geomspace(SLOW, FAST, settings["speeds"])
    found = []
    for number, speed in enumerate(speeds, 1):
        cell = cell_at(speed, settings["side"])
        ours = _both(settings["side"], speed, KELVIN, cell)
        found.append([mu * _radius(cell) / _radius(CELL) for mu in ours])
        advance(number / (len(speeds) + 3 * settings["published"]))
    known = {"closed": speeds / _radius(CELL)}  # v tau/R over v tau/a, R in radii
    groups = {"": _over_speed(speeds, found, known, "v tau over the radius of contact at rest")}
    if settings["published"]:
        groups["published"] = _published(settings["side"])
    return groups


def cell_at(speed: float, side: int) -> float:
    """Return the side of the cell in radii of contact, over which a body forgets: exp(-L/(v tau)).

    speed : v tau/a. side : in samples.
    """
    return max(CELL, min(MOST, PAST * speed, side / FINE))


def _radius(cell: float) -> float:
    """Return the radius of the sphere in radii of contact: flat enough for small slopes."""
    return 10.0 * cell


def _both(side: int, speed: float, spectrum: Spectrum, cell: float) -> tuple[float, float]:
    """Return mu of half-space and foundation at a speed in radii of contact at rest per tau."""
    radius = _radius(cell)
    x = cell * ((np.arange(side) + 0.5) / side - 0.5)
    map_heights = (x[:, None] ** 2 + x**2) / (2.0 * radius)
    # F_N = (4/3) E* a^3/R, of which Fbar = F_N/(E* L h) with h = 1 radius of contact.
    load = 4.0 / (3.0 * radius) / cell
    per_step = side / cell  # elements in a radius of contact
    case = Case(load, speed * per_step, (), (), "exponential", spectrum, refine=False)
    # Slopes are those of a paraboloid, in heights per element: of no mean across the seam.
    surface = Surface.from_samples(map_heights, np.gradient(map_heights, axis=-1), 1)
    half = run_on_half_space(surface, case, STEADY).mu_1
    heights = x**2 / radius
    line = Line.from_samples(heights, np.gradient(heights), 1)
    foundation = run_case(line, case, STEADY).mu_1
    return half * per_step, foundation * per_step


def _published(side: int) -> xr.Dataset:
    rest = (0.75 * FORCE * RADIUS / MODULUS) ** (1.0 / 3.0)
    speeds = [speed for speed, _, _ in PUBLISHED]
    found = []
    for speed, _, cell in PUBLISHED:
        # Slopes scale with a/R: ours have another R.
        ours = _both(side, speed * TIME / 0.01, SLS, cell)
        found.append([mu * _radius(cell) * rest / RADIUS for mu in ours])
    known = {"published": np.array([mu for _, mu, _ in PUBLISHED])}
    return _over_speed(np.array(speeds), found, known, "v 10 ms over the radius of contact")


def _over_speed(
    speeds: np.ndarray, found: list[list[float]], known: dict[str, np.ndarray], text: str
) -> xr.Dataset:
    """Return both bodies, and what is known beside them, over the speed; text : what that is."""
    columns = dict(zip(("half_space", "foundation"), np.array(found).T, strict=True)) | known
    data = {name: ("speed", values) for name, values in columns.items()}
    return xr.Dataset(data, {"speed": ("speed", speeds, {"long_name": text})})
