"""The table [grid]: the values of its axes, and the keys that a scene excludes."""

import math
from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from typing import Any

from ..ground import UserError
from .axes import ALL_AXES, Grid, Parts, axes_of, parts_at
from .effects import Scene
from .settings import Key, checked_values, filled, number, positive, values_of_axis, within
from .surfaces import Surface, check_cutoff

MAX_LINE_ELEMENTS = 1e8
MIN_LINE_ELEMENTS = 4
MAX_GRID_POINTS = 300_000  # a plan of this size takes seconds, a run 2 GiB in the driver


def snapped_spacing(length: float, spacings: tuple[float, ...]) -> tuple[float, ...]:
    """Return the nearest spacings that divide ``length`` into 2^a 3^b 5^c elements.

    The FFT is fast for these numbers of elements. Spacings that become equal are merged.
    """
    elements = [_nearest_smooth(length / spacing) for spacing in spacings]
    return tuple(length / count for count in dict.fromkeys(elements))


def _nearest_smooth(target: float) -> int:
    """Return the number 2^a 3^b 5^c (a > 0) whose ratio to the target is nearest to one."""
    counts = [2]
    for prime in (2, 3, 5):
        for count in counts:  # the list grows during the loop
            if prime * count <= 2.0 * target + 8.0:
                counts.append(prime * count)
    return min(counts, key=lambda n: (abs(math.log(n / target)), n))


def _velocity_step(key: str, value: object) -> float:
    checked = number(key, value)
    if checked <= -1.0:
        raise UserError(f"{key} = {checked!r}: must be greater than -1 (v2 > 0)")
    return checked


GRID = {
    "hurst": Key(
        partial(checked_values, partial(within, least=0.0, most=1.0)),
        "The Hurst exponent H of the line. Its power spectral density falls as q^(−2H−1).",
        "Doubled (up to 1), at the same roughness the rms slope is smaller.",
        usual="required for random lines",
    ),
    "normal_force": Key(
        partial(checked_values, positive),
        "The normal force F_N on the line of length L.",
        "Doubled in full contact, µ halves; in partial contact it changes less.",
        "N",
        usual="required unless `normal_pressure` or the indentation is given",
    ),
    "normal_pressure": Key(
        partial(checked_values, positive),
        "The nominal pressure σ₀, in place of `normal_force`. On a half-space F_N = σ₀L². On the "
        "foundation the line stands for a strip of width λ_r and F_N = σ₀ λ_r L, with λ_r = "
        "`surface.rolloff`, or L without it. µ still falls by up to 27 % from L = λ_r to 16 λ_r.",
        "Doubled, F_N doubles.",
        "Pa",
        default=(),
    ),
    "spacing": Key(
        partial(checked_values, positive),
        "The spacing Δx of the elements, a physical parameter: without a cut-off the shortest "
        "wavelength is 2Δx, and q_max = π/Δx.",
        "Doubled, the number of elements and x halve, and the rms slope falls by about 2^(1−H).",
        "m",
        usual="required for random lines",
    ),
    "roughness": Key(
        partial(checked_values, positive),
        "The rms roughness h of the line; with `surface.spectrum` that of its waves up to L.",
        "Doubled, slopes double and F̄ halves.",
        "m",
        usual="required for random lines",
    ),
    "velocity": Key(
        partial(checked_values, positive),
        "The sliding velocity v₁ before the velocity step; in a programme the reference of "
        "`ratio`.",
        "Doubled, x doubles, and so does steady friction for x < 1; on the plateau it hardly "
        "changes.",
        "m/s",
        usual="required if the motion depends on it",
    ),
    "velocity_step": Key(
        partial(checked_values, _velocity_step),
        "The relative velocity step Δv/v₁, so that v₂ = v₁ (1 + Δv/v₁).",
        "Doubled, the jump Δµ₀ of a small step doubles; b hardly changes.",
        values="a number above −1, zero or at least 1e-9 in size, or a list or range",
        usual="required without a programme, unless only steady sliding is requested",
        schema=values_of_axis({"type": "number", "exclusiveMinimum": -1}),
    ),
    "prescribed_indentation": Key(
        partial(checked_values, number),
        'The indentation d with `scene.control = "indentation"`, positive if the mean line lies '
        "below the undeformed surface.",
        "Doubled in full contact, the normal force doubles and µ halves.",
        "m",
        usual="omitted with control by force",
    ),
}


def read_grid(
    given: Mapping[str, Any],
    written: Mapping[str, Any],
    parts: Parts,
    several: Grid,
) -> Grid:
    """Return axis -> values, for the table [grid] and for the axes of other tables.

    given : checked values of [grid]. written : the table as written by the user, for messages.
    several : values of the axes of other tables. An axis that the scene excludes has one value
    (NaN if undefined), or is absent. Raises UserError.
    """
    _, surface, scene = parts
    excluded = _excluded(surface, scene)
    for axis, (_, reason) in excluded.items():
        if axis in given:
            raise UserError(f"grid.{axis} = {written[axis]!r:.40}: {reason}; omit it")
    if scene.starts_after_sliding and "velocity" not in given:
        raise UserError(
            'scene.start = "steady": the programme begins with a hold; give grid.velocity, the '
            'velocity before it, or use "relaxed"'
        )
    if given.get("normal_pressure"):
        given = _with_forces(given, written, surface)
    keys = {
        axis: replace(key, default=excluded.get(axis, (key.default,))[0])
        for axis, key in GRID.items()
    }
    if not {*scene.quantities} - {"steady", "persson", "model_ratio"} and not scene.programme:
        keys["velocity_step"] = replace(GRID["velocity_step"], default=(0.0,))
    grid: Grid = filled("grid", given, keys)
    if surface.profile is None:
        grid["spacing"] = _spacings(grid["spacing"], surface)
        for point in parts_at(parts, several, axes_of(several, "surface")):
            check_cutoff(point.surface, grid["spacing"])
    if surface.power is not None:
        height = surface.drawn_roughness(round(surface.length / min(grid["spacing"])))
        if not height > 0.0:
            raise UserError(
                f"surface.length = {surface.length!r}: no whole number of its waves is one of "
                "surface.spectrum; take a longer one"
            )
        grid["roughness"] = (height,)
    grid |= several | scene.listed
    axes = {axis: grid[axis] for axis in ALL_AXES if grid.get(axis)}
    points = math.prod(map(len, axes.values()))
    if points > MAX_GRID_POINTS:
        raise UserError(
            f"grid: {points} points, more than {MAX_GRID_POINTS}; use fewer values or several "
            "studies"
        )
    return axes


def _with_forces(given: Mapping[str, Any], written: Mapping[str, Any], surface: Surface) -> Grid:
    """Return the values of a grid with the normal forces of its pressures. Raises UserError."""
    if "normal_force" in given:
        raise UserError(
            f"grid.normal_pressure = {written['normal_pressure']!r:.40}: give it or "
            "grid.normal_force, not both"
        )
    forces = tuple(surface.pressed_area * pressure for pressure in given["normal_pressure"])
    return {**given, "normal_force": forces}


def _excluded(surface: Surface, scene: Scene) -> dict[str, tuple[tuple[float, ...], str]]:
    """Return axis -> (values, reason) for the keys that the table [grid] must not contain."""
    excluded: dict[str, tuple[tuple[float, ...], str]] = {}
    if surface.profile is not None:
        reason = "the measured lines determine it"
        excluded["hurst"] = (math.nan,), "measured lines have their own spectrum"
        excluded["spacing"] = (surface.profile.spacing,), reason
        excluded["roughness"] = (surface.profile.roughness,), reason
    if surface.power is not None:
        for axis in ("hurst", "roughness"):
            excluded[axis] = (math.nan,), "surface.spectrum determines it"
    if scene.control == "indentation":
        reason = 'it follows from the indentation with scene.control = "indentation"'
        excluded |= {"normal_force": ((math.nan,), reason), "normal_pressure": ((), reason)}
    if not scene.uses_indentation:
        excluded["prescribed_indentation"] = (
            (),
            'needs scene.control = "indentation", without scene.indentation_file',
        )
    if scene.programme:
        excluded["velocity_step"] = (0.0,), "the programme gives the velocities"
    if not scene.uses_velocity:
        excluded["velocity"] = (scene.typical_speed,), "no segment of the programme depends on it"
    return excluded


def _spacings(spacings: tuple[float, ...], surface: Surface) -> tuple[float, ...]:
    """Return the spacings, snapped if surface.snap_spacing is true.

    Raises UserError for a spacing that gives a fractional or unsupported number of elements.
    """
    length = surface.length
    for spacing in spacings:
        if not length / spacing < MAX_LINE_ELEMENTS:
            raise UserError(
                f"grid.spacing = {spacing!r}: makes more than {MAX_LINE_ELEMENTS:g} elements on "
                f"surface.length = {length!r}"
            )
    if surface.snap_spacing:
        spacings = snapped_spacing(length, spacings)
    for spacing in spacings:
        elements = length / spacing
        if round(elements) < MIN_LINE_ELEMENTS or abs(elements / round(elements) - 1.0) > 1e-9:
            nearest = length / max(MIN_LINE_ELEMENTS, round(elements))
            raise UserError(
                f"grid.spacing = {spacing:g}: must divide surface.length = {length:g} into at "
                f"least {MIN_LINE_ELEMENTS} elements (nearest: {nearest!r}; or set "
                "surface.snap_spacing = true)"
            )
    return spacings
