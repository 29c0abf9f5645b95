"""Table of quantities derived from the estimates of a point in SI units.

Points of equal dimensionless numbers share one task. A task only yields dimensionless numbers times
powers of the axes. For other quantities ``result/dataset.py`` applies the functions of this table
at every grid point, to the estimates and to each of their jackknife replicates. The standard error
then includes the covariances, and no gradient is needed.
"""

from collections.abc import Callable, Iterable, Mapping
from typing import Any, NamedTuple

from ..study import FOUNDATION, HALF_SPACE, QUANTITIES

Labelled = Any  # xarray.DataArray over any axes of the grid


class GridPoints(NamedTuple):
    """Estimates and parameters of all grid points in SI units, as arrays that broadcast by name."""

    estimates: Mapping[str, Labelled]  # over all axes, and the dimension "replicate"
    parameters: Mapping[str, Labelled]  # the axes of the grid, tau (s), and E* as "modulus" (Pa)
    # ("surface", function) -> function(surface) at every point; "material" and "scene" likewise
    setting: Callable[[str, Callable[[Any], float]], Labelled]


class PointQuantity(NamedTuple):
    """A quantity of a point; its variable has the name of its row in the table."""

    function: Callable[[GridPoints], Labelled]
    estimates: tuple[str, ...]  # block means (study/effects/quantities.py) that it needs
    bodies: tuple[str, ...] = (FOUNDATION, HALF_SPACE)


def _mean_contact_pressure(points: GridPoints) -> Labelled:
    """Return the normal force over the real contact area, Pa."""
    nominal_area = points.setting("surface", lambda surface: surface.pressed_area)
    area = nominal_area * points.estimates["contact_fraction"]
    return points.parameters["normal_force"] / area


POINT_QUANTITIES = {
    # The contact fraction of a foundation is a share of a line, not of an area.
    "mean_contact_pressure": PointQuantity(
        _mean_contact_pressure, ("contact_fraction",), (HALF_SPACE,)
    )
}


def quantities_of_points(requested: Iterable[str], body: str) -> dict[str, PointQuantity]:
    """Return the rows of the table for which the requested quantities supply all estimates."""
    means = {name for quantity in requested for name in QUANTITIES[quantity].means}
    return {
        name: row
        for name, row in POINT_QUANTITIES.items()
        if body in row.bodies and means.issuperset(row.estimates)
    }


def carried_estimates(requested: Iterable[str], body: str) -> tuple[str, ...]:
    """Return the names of the estimates whose replicates the quantities of a point need."""
    rows = quantities_of_points(requested, body).values()
    return tuple(sorted({name for row in rows for name in row.estimates}))
