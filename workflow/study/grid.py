"""The grid: a number, a list, {linspace = [a, b, n]} or {geomspace = [a, b, n]} on each axis."""

import math
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from workflow.errors import UserError
from workflow.study.checks import Key, integer, number, positive, read_table, within

Grid = dict[str, tuple[float, ...]]

MOST_VALUES = 10_000  # on one axis
MOST_ELEMENTS = 1e8
LEAST_ELEMENTS = 4
SPACES: dict[str, Callable[..., np.ndarray]] = {"linspace": np.linspace, "geomspace": np.geomspace}


def axis_values(key: str, spec: object) -> tuple[float, ...]:
    """Return the values of one grid axis, in the order given, without repetitions.

    Computed values are rounded to 12 digits, so that 0.3 of a linspace is 0.3.
    """
    if isinstance(spec, dict):
        values = _spaced(key, spec)
    elif isinstance(spec, list):
        values = tuple(number(f"{key}[{i}]", v) for i, v in enumerate(spec))
    else:
        values = (number(key, spec),)
    if not values:
        raise UserError(f"{key} = []: must hold at least one value")
    if len(set(values)) < len(values):
        raise UserError(f"{key} = {spec!r}: holds a value twice")
    return values


def _spaced(key: str, spec: dict[str, Any]) -> tuple[float, ...]:
    kind = next(iter(spec)) if len(spec) == 1 else ""
    if kind not in SPACES:
        raise UserError(f"{key} = {spec!r}: use {{linspace = [a, b, n]}} or {{geomspace = ...}}")
    args = spec[kind]
    if not isinstance(args, list) or len(args) != 3:
        raise UserError(f"{key}.{kind} = {args!r}: must be [first, last, number of values]")
    first, last = number(f"{key}.{kind}[0]", args[0]), number(f"{key}.{kind}[1]", args[1])
    count = integer(f"{key}.{kind}[2]", args[2], 1, MOST_VALUES)
    if kind == "geomspace" and first * last <= 0.0:
        raise UserError(f"{key}.geomspace = {args!r}: both ends must be of one sign, not zero")
    return tuple(float(f"{value:.12g}") for value in SPACES[kind](first, last, count))


def snapped_spacing(length: float, spacings: tuple[float, ...]) -> tuple[float, ...]:
    """Return the nearest spacings that divide ``length`` into a number of elements 2^a 3^b 5^c.

    Such numbers are quick for the FFT; two spacings may fall on one.
    """
    elements = [_nearest_smooth(length / spacing) for spacing in spacings]
    return tuple(length / count for count in dict.fromkeys(elements))


def _nearest_smooth(target: float) -> int:
    found = [2]
    for prime in (2, 3, 5):
        for count in found:  # which grows meanwhile
            if prime * count <= 2.0 * target + 8.0:
                found.append(prime * count)
    return min(found, key=lambda n: (abs(math.log(n / target)), n))


def _step(key: str, value: object) -> float:
    checked = number(key, value)
    if checked <= -1.0:
        raise UserError(f"{key} = {checked!r}: must be greater than -1 (v2 > 0)")
    return checked


def _values(check: Callable[[str, object], float], key: str, spec: object) -> tuple[float, ...]:
    return tuple(check(key, value) for value in axis_values(key, spec))


CHECKS: dict[str, Callable[[str, object], float]] = {
    "hurst": partial(within, least=0.0, most=1.0),
    "normal_force": positive,
    "spacing": positive,
    "roughness": positive,
    "velocity": positive,
    "velocity_step": _step,
}
GRID = {axis: Key(partial(_values, check)) for axis, check in CHECKS.items()}
AXES = tuple(GRID)


def read_grid(table: Any, length: float, snap: bool, steady_alone: bool) -> Grid:
    """Return axis -> values of the table [grid]. Raises UserError.

    length : of the line (m), which every spacing must divide; ``snap`` moves spacings so that
    they do. steady_alone : whether a velocity step may be left out.
    """
    keys = {**GRID, "velocity_step": Key(GRID["velocity_step"].check, (0.0,))}
    grid: Grid = read_table("grid", table, keys if steady_alone else GRID)
    for spacing in grid["spacing"]:
        if not length / spacing < MOST_ELEMENTS:
            raise UserError(
                f"grid.spacing = {spacing!r}: more than {MOST_ELEMENTS:g} elements on "
                f"surface.length = {length!r}"
            )
    if snap:
        grid["spacing"] = snapped_spacing(length, grid["spacing"])
    for spacing in grid["spacing"]:
        elements = length / spacing
        if round(elements) < LEAST_ELEMENTS or abs(elements / round(elements) - 1.0) > 1e-9:
            near = length / max(LEAST_ELEMENTS, round(elements))
            raise UserError(
                f"grid.spacing = {spacing:g}: must divide surface.length = {length:g} into at "
                f"least {LEAST_ELEMENTS} elements (nearest: {near!r}; or set "
                "surface.snap_spacing = true)"
            )
    return grid
