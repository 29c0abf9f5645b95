"""Axes of a grid: name, unit, the table that holds the values, and the part that they change.

An axis of the table [grid] is a parameter of each point, made dimensionless in plan/problems.py.
Any other axis is a parameter of a material, a surface or a scene. Each of its values gives another
material, surface or scene, from which G, tau, the spectrum and the load are derived.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from functools import partial
from typing import Any, NamedTuple

from .effects import Material, Scene
from .settings import Key, one_or_several
from .surfaces import Surface

Grid = dict[str, tuple[float, ...]]


class Parts(NamedTuple):
    """Material, surface and scene at one point of the axes that change them."""

    material: Material
    surface: Surface
    scene: Scene


class Axis(NamedTuple):
    """A dimension of the grid."""

    name: str  # of the dimension and of the key
    unit: str  # in a result file
    long_name: str
    table: str = "grid"  # table of the values; if not "grid", also the changed part
    put: Callable[[Any, str, float], Any] | None = None  # part, axis, value -> changed part
    within: str = ""  # inline table inside ``table`` that holds the values, if any

    def changed(self, parts: Parts, value: float) -> Parts:
        """Return the parts of a study with one value of this axis."""
        part = getattr(parts, self.table)
        if self.put is None:
            changed = part._replace(**{self.name: value})
        else:
            changed = self.put(part, self.name, value)
        return parts._replace(**{self.table: changed})


def _set_stiffness(scene: Scene, _: str, stiffness: float) -> Scene:
    assert scene.drive is not None
    return scene._replace(drive=scene.drive._replace(stiffness=stiffness))


ROWS = (
    Axis("hurst", "1", "Hurst exponent H"),
    Axis("normal_force", "N", "normal force F_N"),
    Axis("spacing", "m", "element spacing dx"),
    Axis("roughness", "m", "rms roughness h"),
    Axis("velocity", "m s-1", "sliding velocity v1"),
    Axis("velocity_step", "1", "relative velocity jump dv/v1"),
    Axis("prescribed_indentation", "m", "prescribed indentation d over the mean line"),
    Axis("temperature", "degree_Celsius", "temperature of the elastomer", "material"),
    Axis("hold", "s", "duration of the hold", "scene", Scene.with_axis_value),
    Axis("stiffness", "N m-1", "stiffness of the drive's spring", "scene", _set_stiffness, "drive"),
    Axis(
        "velocity_amplitude",
        "m s-1",
        "amplitude of the velocity of the oscillation",
        "scene",
        Scene.with_axis_value,
    ),
    Axis("frequency", "Hz", "frequency of the oscillation", "scene", Scene.with_axis_value),
)
ALL_AXES = {row.name: row for row in ROWS}
COMMON_AXES = tuple(ALL_AXES)[:6]  # dimensions of every result


def axes_of(grid: Mapping[str, Any], *tables: str) -> list[str]:
    """Return the axes of a grid that belong to the given tables."""
    return [axis for axis in grid if ALL_AXES[axis].table in tables]


def parts_at(parts: Parts, grid: Grid, axes: Iterable[str]) -> list[Parts]:
    """Return the parts of a study at every point of some axes, the last axis fastest."""
    points = [parts]
    for axis in axes:
        points = [ALL_AXES[axis].changed(point, value) for point in points for value in grid[axis]]
    return points


def with_lists(table: str, keys: Mapping[str, Key]) -> dict[str, Key]:
    """Return the keys of a table; those that are axes accept lists and ranges."""
    return {
        name: _listed(key) if name in ALL_AXES and ALL_AXES[name].table == table else key
        for name, key in keys.items()
    }


def _listed(key: Key) -> Key:
    values = f"{key.values}, or a list or range of them" if key.values else ""
    return replace(key, check=partial(one_or_several, key.check), values=values)


def separated(tables: Mapping[str, dict[str, Any]]) -> tuple[dict[str, dict[str, Any]], Grid]:
    """Return checked tables with one value per axis, the first, and all values of these axes.

    Axes of the table [grid] are not separated.
    """
    single, several = dict(tables), {}
    for row in ROWS[len(COMMON_AXES) :]:
        values = _table_of(tables, row).get(row.name)
        if row.table != "grid" and isinstance(values, tuple):
            several[row.name] = values
            single = with_value(single, row, values[0])
    return single, several


def with_value(
    tables: dict[str, dict[str, Any]], row: Axis, value: float
) -> dict[str, dict[str, Any]]:
    """Return checked tables with one value of an axis."""
    table = {**_table_of(tables, row), row.name: value}
    return {**tables, row.table: {**tables[row.table], row.within: table} if row.within else table}


def _table_of(tables: Mapping[str, dict[str, Any]], row: Axis) -> dict[str, Any]:
    """Return the table that holds the values of an axis, or an empty one."""
    table = tables[row.table]
    return table.get(row.within) or {} if row.within else table
