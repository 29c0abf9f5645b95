"""The axes of a grid, a row for each: what it is, where its values stand and what they change.

An axis of the table [grid] is a number of every point, which plan/problems.py makes dimensionless.
Any other is a number of a material, a surface or a scene: where a study gives several values of
it, each makes another one, and all that follows from it (G, tau, the spectrum, the load) with it.
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
    """What a study is made of at a point of the axes that change it."""

    material: Material
    surface: Surface
    scene: Scene


class Axis(NamedTuple):
    """What a dimension of the grid is."""

    name: str  # of the dimension, and of the key that holds its values
    unit: str  # as a result file has it
    long_name: str
    table: str = "grid"  # of the study in which its values stand, or the part that they change
    put: Callable[[Any, str, float], Any] | None = None  # part, axis, value; None: its field
    within: str = ""  # the table in that table in which its values stand

    def changed(self, parts: Parts, value: float) -> Parts:
        """Return the parts of a study with one value of this axis."""
        own = getattr(parts, self.table)
        with_it = (
            self.put(own, self.name, value) if self.put else own._replace(**{self.name: value})
        )
        return parts._replace(**{self.table: with_it})


def _pulled(scene: Scene, _: str, stiffness: float) -> Scene:
    assert scene.drive is not None
    return scene._replace(drive=scene.drive._replace(stiffness=stiffness))


ROWS = (
    Axis("hurst", "1", "Hurst exponent H"),
    Axis("normal_force", "N", "normal force F_N"),
    Axis("spacing", "m", "element spacing dx"),
    Axis("roughness", "m", "rms roughness h"),
    Axis("velocity", "m s-1", "sliding velocity v1 before the jump"),
    Axis("velocity_step", "1", "relative velocity jump dv/v1"),
    Axis("prescribed_indentation", "m", "prescribed indentation d over the mean line"),
    Axis("temperature", "degree_Celsius", "temperature of the elastomer", "material"),
    Axis("hold", "s", "duration of the hold", "scene", Scene.with_axis_value),
    Axis("stiffness", "N m-1", "stiffness of the drive's spring", "scene", _pulled, "drive"),
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
COMMON_AXES = tuple(ALL_AXES)[:6]  # that every result has; another is there where it has values


def axes_of(grid: Mapping[str, Any], *tables: str) -> list[str]:
    """Return the axes of a grid whose values stand in some tables."""
    return [axis for axis in grid if ALL_AXES[axis].table in tables]


def parts_at(parts: Parts, grid: Grid, axes: Iterable[str]) -> list[Parts]:
    """Return the parts of a study at every point of some axes, the last of which goes fastest."""
    found = [parts]
    for axis in axes:
        found = [ALL_AXES[axis].changed(own, value) for own in found for value in grid[axis]]
    return found


def with_lists(table: str, keys: Mapping[str, Key]) -> dict[str, Key]:
    """Return the keys of a table, of which those of axes may have several values."""
    return {
        name: _listed(key) if name in ALL_AXES and ALL_AXES[name].table == table else key
        for name, key in keys.items()
    }


def _listed(key: Key) -> Key:
    means = f"{key.means} A list makes it a dimension of the result."
    values = f"{key.values}, or a list or range of them" if key.values else ""
    return replace(key, check=partial(one_or_several, key.check), means=means, values=values)


def separated(tables: Mapping[str, dict[str, Any]]) -> tuple[dict[str, dict[str, Any]], Grid]:
    """Return checked tables with one value of each of their axes, the first, and all their values.

    The table [grid] stays as it is.
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
    own = {**_table_of(tables, row), row.name: value}
    return {**tables, row.table: {**tables[row.table], row.within: own} if row.within else own}


def _table_of(tables: Mapping[str, dict[str, Any]], row: Axis) -> dict[str, Any]:
    """Return the table in which the values of an axis stand; empty where there is none."""
    own = tables[row.table]
    return own.get(row.within) or {} if row.within else own
