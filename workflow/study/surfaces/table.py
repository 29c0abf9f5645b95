"""The table [surface]: random self-affine lines, or lines that were measured."""

from functools import partial
from pathlib import Path
from typing import Any

from ....kernels.lines.self_affine import NORMALISATIONS
from ...errors import UserError
from ..settings import (
    Key,
    as_table,
    as_text,
    check_keys,
    choice,
    flag,
    positive,
    read_table,
    within,
)
from .lines import Asked
from .prepare import DETRENDS, PERIODICS
from .profile import read_profile
from .surface import LINES, Surface
from .units import METRES, metres


def _columns(key: str, value: object) -> tuple:
    """Return columns as a tuple: whole numbers from 0, or two names of variables."""
    columns = tuple(value) if isinstance(value, list) else ()
    numbers = all(type(column) is int and column >= 0 for column in columns)
    names = len(columns) == 2 and all(isinstance(column, str) for column in columns)
    if len(columns) < 2 or not (numbers or names):
        raise UserError(
            f"{key} = {value!r}: must be that of positions and those of heights, as [0, 1], or in "
            'netCDF two names, as ["x", "height"]'
        )
    return columns


def _units(key: str, value: object) -> tuple[str, ...]:
    """Return the units of positions and heights as a tuple."""
    units = tuple(value) if isinstance(value, list) else ()
    known = all(isinstance(unit, str) and metres(unit) is not None for unit in units)
    if len(units) != 2 or not known:
        raise UserError(
            f"{key} = {value!r}: must be the units of positions and heights, two out of "
            f"{', '.join(unit for unit in METRES if len(unit) < 3)}"
        )
    return units


RANDOM = {
    "length": Key(positive),
    "normalisation": Key(partial(choice, known=NORMALISATIONS), "modal"),
    "snap_spacing": Key(flag, False),
    "rolloff": Key(positive, 0.0),
    "cutoff": Key(positive, 0.0),
}
MEASURED = {
    "file": Key(as_text),
    "columns": Key(_columns, ()),
    "units": Key(_units, ()),
    "detrend": Key(partial(choice, known=DETRENDS), "line"),
    "periodic": Key(partial(choice, known=PERIODICS), "mirror"),
}
LIKE = {  # which a comparison may set as well
    "lines": Key(partial(choice, known=LINES), "measured"),
    "hurst": Key(partial(within, least=0.0, most=1.0), 1.0),
}
WITH_FILE = MEASURED | LIKE
SURFACE = RANDOM | WITH_FILE


def read_surface(table: Any, folder: Path) -> Surface:
    """Return the surface of a study; files are found from its ``folder``. Raises UserError."""
    given = as_table("surface", table)
    check_keys("surface.", given, SURFACE)
    if "file" in given:
        return _measured(given, folder)
    for key in filter(WITH_FILE.__contains__, given):
        raise UserError(f"surface.{key} = {given[key]!r:.40}: goes with surface.file alone")
    surface = Surface(**read_table("surface", given, RANDOM))
    for key in ("rolloff", "cutoff"):
        if given.get(key, 0.0) > surface.length:
            raise UserError(
                f"surface.{key} = {given[key]!r}: must not be longer than surface.length = "
                f"{surface.length!r}"
            )
    if surface.rolloff and surface.rolloff <= surface.cutoff:
        raise UserError(
            f"surface.rolloff = {surface.rolloff!r}: must be longer than surface.cutoff = "
            f"{surface.cutoff!r}"
        )
    return surface


def _measured(given: dict[str, Any], folder: Path) -> Surface:
    own = {key: value for key, value in given.items() if key in MEASURED}
    settings = read_table("surface", own, MEASURED)
    like = {key: value for key, value in given.items() if key in LIKE}
    for key in filter(RANDOM.__contains__, given):
        raise UserError(
            f"surface.{key} = {given[key]!r:.40}: leave it out with surface.file, measured lines"
        )
    name = settings["file"]
    asked = Asked(folder / name, name, settings["columns"], settings["units"])
    profile = read_profile(asked, settings["detrend"], settings["periodic"])
    return lines_like("surface", Surface(profile.measured_length, profile=profile), like)


def lines_like(where: str, surface: Surface, table: dict[str, Any]) -> Surface:
    """Return a surface whose lines are those that a table holds, measured or like them.

    ``where`` is the name of the table. Raises UserError.
    """
    for key in table if surface.profile is None else ():
        raise UserError(f"{where}.{key} = {table[key]!r:.40}: goes with surface.file alone")
    usual = {key: Key(each.check, getattr(surface, key)) for key, each in LIKE.items()}
    found = surface._replace(**read_table(where, table, usual))
    try:
        _ = found.amplitudes
    except ValueError as error:
        raise UserError(f"{where}.hurst = {found.hurst!r}: {error}") from None
    return found


def check_cutoff(surface: Surface, spacings: tuple[float, ...]) -> None:
    """Raise UserError where elements do not resolve the shortest wavelength of their lines."""
    for key, wavelength in (("cutoff", surface.cutoff), ("rolloff", surface.rolloff)):
        for spacing in spacings:
            if wavelength and wavelength < 2.0 * spacing * (1.0 - 1e-9):
                raise UserError(
                    f"surface.{key} = {wavelength!r}: must be two spacings or more: "
                    f"{2.0 * spacing:g} at grid.spacing = {spacing!r}"
                )
