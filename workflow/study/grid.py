"""The grid: the values of every axis, and what a scene leaves out of it."""

import math
from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from typing import Any

from ..ground import UserError
from .axes import ALL_AXES, Grid, Parts, axes_of, parts_at
from .effects import Scene
from .settings import (
    Key,
    checked_values,
    filled,
    number,
    positive,
    values_of_axis,
    within,
)
from .surfaces import Surface, check_cutoff

MOST_ELEMENTS = 1e8
LEAST_ELEMENTS = 4
MOST_POINTS = 300_000  # a plan takes seconds, a run 2 GiB in the driver


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


GRID = {
    "hurst": Key(
        partial(checked_values, partial(within, least=0.0, most=1.0)),
        "The Hurst exponent H of the line, whose power spectral density falls as q^(−2H−1).",
        "Doubled (up to 1), at the same roughness the rms slope is smaller, and for x > 1 the "
        "relaxation rate b ≈ x^(1−H) grows more slowly with the velocity.",
        usual="required for random lines alone",
    ),
    "normal_force": Key(
        partial(checked_values, positive),
        "The normal force F_N on the line of length L.",
        "Doubled, F̄ doubles and more of the line touches. In full contact µ halves; in partial "
        "contact it changes less.",
        "N",
        usual="required where neither `normal_pressure` nor the indentation is given",
    ),
    "normal_pressure": Key(
        partial(checked_values, positive),
        "The nominal pressure σ₀, in place of `normal_force`. On a half-space F_N = σ₀L². On the "
        "foundation F_N = σ₀ λ_r L, with λ_r = `surface.rolloff`, or L without it, so that "
        "each length λ_r carries what a square of this side does; from one to sixteen of them "
        "friction still falls by up to 27 %.",
        "Doubled, F_N doubles.",
        "Pa",
        default=(),
    ),
    "spacing": Key(
        partial(checked_values, positive),
        "The spacing Δx of the elements. It is a physical parameter: without a cut-off the "
        "shortest wave is 2Δx long, and q_max = π/Δx. Accuracy is set by "
        "`numerics.steps_per_spacing` instead.",
        "Doubled, elements and x halve, and the rms slope falls by about 2^(1−H).",
        "m",
        usual="required for random lines alone",
    ),
    "roughness": Key(
        partial(checked_values, positive),
        "The rms roughness h of the line.",
        "Doubled, slopes double and F̄ halves: µ is twice what it was at half the normal force.",
        "m",
        usual="required for random lines alone",
    ),
    "velocity": Key(
        partial(checked_values, positive),
        "The sliding velocity v₁ before the velocity step, or that to which `ratio` in a "
        "programme refers.",
        "Doubled, x doubles. Where x < 1 steady friction doubles; on the plateau above it hardly "
        "changes.",
        "m/s",
        usual="required where the motion depends on it",
    ),
    "velocity_step": Key(
        partial(checked_values, _step),
        "The relative velocity step Δv/v₁, so that v₂ = v₁ (1 + Δv/v₁).",
        "Doubled, small steps make twice the jump Δµ₀; the relaxation rate b hardly changes.",
        values="a number above −1, zero or at least 1e-9 in size, or a list or range",
        usual="required without a programme, unless steady sliding alone is asked for",
        schema=values_of_axis({"type": "number", "exclusiveMinimum": -1}),
    ),
    "prescribed_indentation": Key(
        partial(checked_values, number),
        "The indentation d, positive where the mean line lies below the undeformed surface; with "
        '`scene.control = "indentation"` alone.',
        "Doubled in full contact, the normal force doubles and µ halves.",
        "m",
        usual="left out with control by force",
    ),
}


def read_grid(
    given: Mapping[str, Any],
    written: Mapping[str, Any],
    parts: Parts,
    several: Grid,
) -> Grid:
    """Return axis -> values of the table [grid], and those of all other axes.

    given : its checked values. written : the same as the user wrote them, for messages.
    several : values of the axes that stand in other tables. What the scene has no use for is left
    out of the table; it has one value then, NaN where there is none. Raises UserError.
    """
    _, surface, scene = parts
    left_out = _left_out(surface, scene)
    for axis, (_, reason) in left_out.items():
        if axis in given:
            raise UserError(f"grid.{axis} = {written[axis]!r:.40}: {reason}; leave it out")
    if scene.starts_after_sliding and "velocity" not in given:
        raise UserError(
            'scene.start = "steady": the programme begins with a hold; give grid.velocity, at '
            'which it slid before, or use "relaxed"'
        )
    if given.get("normal_pressure"):
        given = _pressed(given, written, surface)
    keys = {
        axis: replace(key, default=left_out.get(axis, (key.default,))[0])
        for axis, key in GRID.items()
    }
    if not {*scene.quantities} - {"steady", "persson"} and not scene.programme:
        keys["velocity_step"] = replace(GRID["velocity_step"], default=(0.0,))
    grid: Grid = filled("grid", given, keys)
    if surface.profile is None:
        grid["spacing"] = _spacings(grid["spacing"], surface)
        for each in parts_at(parts, several, axes_of(several, "surface")):
            check_cutoff(each.surface, grid["spacing"])
    grid |= several | scene.listed
    found = {axis: grid[axis] for axis in ALL_AXES if grid.get(axis)}
    points = math.prod(map(len, found.values()))
    if points > MOST_POINTS:
        raise UserError(
            f"grid: {points} points, more than {MOST_POINTS}: take fewer values, or several studies"
        )
    return found


def _pressed(given: Mapping[str, Any], written: Mapping[str, Any], surface: Surface) -> Grid:
    """Return the values of a grid with normal forces in place of pressures. Raises UserError."""
    if "normal_force" in given:
        raise UserError(
            f"grid.normal_pressure = {written['normal_pressure']!r:.40}: give it or "
            "grid.normal_force, not both"
        )
    forces = tuple(surface.pressed_area * pressure for pressure in given["normal_pressure"])
    return {**given, "normal_force": forces}


def _left_out(surface: Surface, scene: Scene) -> dict[str, tuple[tuple[float, ...], str]]:
    """Return axis -> (values, why) of what the table [grid] must not hold."""
    found: dict[str, tuple[tuple[float, ...], str]] = {}
    if surface.profile is not None:
        why = "that of the measured lines is taken"
        found["hurst"] = (math.nan,), "measured lines have their own spectrum"
        found["spacing"] = (surface.profile.spacing,), why
        found["roughness"] = (surface.profile.roughness,), why
    if scene.control == "indentation":
        free = 'scene.control = "indentation" leaves it free'
        found |= {"normal_force": ((math.nan,), free), "normal_pressure": ((), free)}
    if not scene.uses_indentation:
        found["prescribed_indentation"] = (
            (),
            'needs scene.control = "indentation", without scene.indentation_file',
        )
    if scene.programme:
        found["velocity_step"] = (0.0,), "the programme says how velocities change"
    if not scene.uses_velocity:
        found["velocity"] = (scene.typical_speed,), "no segment of the programme depends on it"
    return found


def _spacings(spacings: tuple[float, ...], surface: Surface) -> tuple[float, ...]:
    """Return the spacings, snapped where that is asked for. Raises UserError.

    Every spacing must divide the length into a number of elements in reach.
    """
    length = surface.length
    for spacing in spacings:
        if not length / spacing < MOST_ELEMENTS:
            raise UserError(
                f"grid.spacing = {spacing!r}: more than {MOST_ELEMENTS:g} elements on "
                f"surface.length = {length!r}"
            )
    if surface.snap_spacing:
        spacings = snapped_spacing(length, spacings)
    for spacing in spacings:
        elements = length / spacing
        if round(elements) < LEAST_ELEMENTS or abs(elements / round(elements) - 1.0) > 1e-9:
            near = length / max(LEAST_ELEMENTS, round(elements))
            raise UserError(
                f"grid.spacing = {spacing:g}: must divide surface.length = {length:g} into at "
                f"least {LEAST_ELEMENTS} elements (nearest: {near!r}; or set "
                "surface.snap_spacing = true)"
            )
    return spacings
