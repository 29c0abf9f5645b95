"""Choice of the elastic body from the question that a study asks, unless scene.body names it.

A nominal pressure on a random surface, or a measured map, describes the contact of areas, which is
computed on a half-space. A force on random lines, measured lines and a prescribed indentation
belong to the foundation of the paper.
"""

from collections.abc import Mapping
from typing import Any, NamedTuple

from ..ground import UserError
from .effects import FOUNDATION, HALF_SPACE
from .surfaces import Surface


class BodyChoice(NamedTuple):
    """A body, and the reason for it in words."""

    body: str | None  # None: a half-space if the measured heights are a map
    reason: str


def choose_body(tables: Mapping[str, Mapping[str, Any]], measured: bool) -> BodyChoice:
    """Return the body for the checked values of a study as written.

    measured : whether heights are given, by surface.file or from Python. A body that is given in
    place of the default is stated with the default.
    """
    default = _default_body(tables, measured)
    body = tables["scene"].get("body")
    if body is None:
        return default
    reason = "given by scene.body"
    if default.body not in (None, body):
        reason += f", in place of the {default.body} (default: {default.reason})"
    return BodyChoice(body, reason)


def _default_body(tables: Mapping[str, Mapping[str, Any]], measured: bool) -> BodyChoice:
    surface = tables.get("surface", {})
    if tables["scene"].get("control") == "indentation":
        return BodyChoice(FOUNDATION, "a prescribed indentation is that of lines")
    if "lines" in surface:
        return BodyChoice(FOUNDATION, f'surface.lines = "{surface["lines"]}" requests lines')
    if measured:
        return BodyChoice(None, "")
    if "normal_pressure" in tables["grid"]:
        return BodyChoice(HALF_SPACE, "a nominal pressure acts on a random surface")
    return BodyChoice(FOUNDATION, "a normal force acts on random lines, as in the paper")


def settle_body(choice: BodyChoice, surface: Surface, grid: Mapping[str, Any]) -> BodyChoice:
    """Return the choice for a surface that was read.

    Raises UserError for a map under a normal force without scene.body: the force may be that of
    each line of the map, or that of the square.
    """
    if choice.body is not None:
        return choice
    if surface.body == FOUNDATION:
        return BodyChoice(FOUNDATION, "the measured heights are lines")
    if "normal_force" in grid:
        force, area = grid["normal_force"][0], surface.pressed_area
        raise UserError(
            f"grid.normal_force = {force:g}: is ambiguous for a map, a matrix of heights; give "
            f"grid.normal_pressure = {force / area:.4g}, F_N/L^2, for a half-space, or set "
            f'scene.body = "{FOUNDATION}" and give the force on each line'
        )
    return BodyChoice(HALF_SPACE, "the measured heights are a map")
