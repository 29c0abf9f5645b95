"""The table [surface]: settings of random lines and of measured lines."""

import math
from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from ....kernels.lines.self_affine import NORMALISATIONS
from ...ground import UserError
from ..effects import FOUNDATION, HALF_SPACE
from ..settings import (
    FILE_NAME,
    OPTIONAL,
    TEXT,
    Key,
    checked,
    choice,
    filled,
    flag,
    inline_table,
    pair,
    positive,
    refuse_keys,
    within,
)
from .files import read_lines
from .gaps import GAPS, SPIKES
from .profile import DETRENDS, PERIODICS, Profile, is_map, map_of_lines, profile_of_lines
from .raw_lines import LineFile, metres
from .spectrum_file import SPECTRUM, SPECTRUM_KEY, read_spectrum
from .surface import LINE_KINDS, MAP_KINDS, Surface


def _as_columns(key: str, value: object) -> tuple:
    """Return columns as a tuple: whole numbers from 0, or two names of variables."""
    columns = tuple(value) if isinstance(value, list) else ()
    numbers = all(type(column) is int and column >= 0 for column in columns)
    names = len(columns) == 2 and all(isinstance(column, str) for column in columns)
    if not columns or not (numbers or names):
        raise UserError(
            f"{key} = {value!r}: must be that of positions and those of heights, as [0, 1], or in "
            'netCDF two names, as ["x", "height"]'
        )
    return columns


def _as_units(key: str, value: object) -> tuple[str, ...]:
    """Return the units of positions and heights as a tuple."""
    units = tuple(value) if isinstance(value, list) else ()
    known = all(isinstance(unit, str) and metres(unit) is not None for unit in units)
    if len(units) != 2 or not known:
        raise UserError(
            f"{key} = {value!r}: must be the units of positions and heights, two out of "
            "m, cm, mm, um, nm, å, pm, in, mil"
        )
    return units


RANDOM_KEYS = {
    "length": Key(
        positive,
        "The length L of the periodic line.",
        "Doubled at the same spacing, elements and time double and F̄ halves.",
        "m",
        usual="required for random lines alone",
    ),
    "normalisation": Key(
        partial(choice, known=NORMALISATIONS),
        'The meaning of the roughness h: with `"modal"` the rms height of every line; with '
        '`"integral"` the integral of the spectral density as in the paper, which differs by a '
        "factor from 1.04 (H = 0) to 1.55 (H = 1) at 5000 elements.",
        default="modal",
    ),
    "snap_spacing": Key(
        flag,
        "Whether each spacing is moved to the nearest that divides the length into 2^a 3^b 5^c "
        "elements, for which the Fourier transform is fast. Otherwise it must divide the length.",
        default=False,
    ),
    "rolloff": Key(
        positive,
        "The wavelength λ_r above which the power spectrum is flat. With `file` it only "
        "determines the force of `grid.normal_pressure`.",
        "Doubled at the same h, the rms slope falls by about 2^H.",
        "m",
        default=0.0,
        usual="none: the power law extends to the length, as in the paper",
    ),
    "cutoff": Key(
        positive,
        "The shortest wavelength of the line, at least two spacings.",
        "Doubled, q_max = 2π/cutoff and x halve, and the rms slope falls by about 2^(1−H).",
        "m",
        default=0.0,
        usual="twice the spacing, as in the paper",
    ),
}
SPECTRUM_KEYS = {
    "spectrum": OPTIONAL(
        partial(inline_table, keys=SPECTRUM),
        "The measured power spectrum of an isotropic surface, in place of `grid.hurst` and "
        "`grid.roughness`. It is zero beyond its rows; `rolloff` makes C₂D flat above λ_r.",
    ),
    "rms_slope": OPTIONAL(
        positive,
        "The rms slope (full gradient) of all waves of `spectrum` up to the cut-off q₁, in place "
        "of `cutoff`.",
        "Doubled, q₁ more than doubles, and the spacing must resolve it.",
    ),
}
FILE_KEYS = {
    "file": FILE_NAME(
        "A file of measured lines beside `study.toml`: text of any suffix, `.npy`, `.nc`, or a "
        "format of SurfaceTopography. It determines H, spacing and roughness; the keys below need "
        "it.",
        usual="none: lines are random",
    ),
    "columns": Key(
        _as_columns,
        "The columns, from 0, of positions and of the heights of one or more lines; in netCDF the "
        "names of the two variables.",
        default=(),
        values='whole numbers as `[0, 1]`, or two names as `["x", "height"]`',
        usual="those that the header names, else the first two, or the only variable of heights",
        schema={"type": "array", "minItems": 1, "items": {"type": ["integer", "string"]}},
    ),
    "units": Key(
        _as_units,
        "The units of positions and heights. They are never guessed.",
        default=(),
        values='two units of length as `["mm", "um"]`',
        usual="those that the file names, else required",
        schema=pair(TEXT, TEXT),
    ),
    "step": OPTIONAL(
        positive,
        "The distance of two samples of a file without positions.",
        "Doubled, slopes are half as steep.",
        "m",
        usual="that of the file",
    ),
    "gaps": Key(
        partial(choice, known=GAPS),
        "The treatment of missing samples and codes such as −9999: `refuse` stops and counts "
        "them, `fill` interpolates linearly, `drop` leaves out their lines.",
        default="refuse",
    ),
    "spikes": Key(
        partial(choice, known=SPIKES),
        "The treatment of spikes, neighbours with a slope of 3 or more (ISO 13473-1): `fill` "
        "interpolates linearly, `keep` keeps them; `refuse` keeps them too, but stops if a gap "
        "would be filled from one.",
        default="refuse",
    ),
    "detrend": Key(
        partial(choice, known=DETRENDS),
        "The part subtracted from each line: nothing, its mean, a straight line (tilt) or a "
        "parabola (tilt and bow).",
        default="line",
    ),
    "periodic": Key(
        partial(choice, known=PERIODICS),
        "How a measured line becomes periodic: `mirror` appends it reversed, which loses the "
        "direction of a texture; `taper` brings both ends to the mean height over a tenth of the "
        "length; `none` takes it as one period.",
        default="mirror",
    ),
}
LINE_KIND_KEYS = {  # also keys of comparisons
    "lines": Key(
        partial(choice, known=LINE_KINDS),
        "The lines that slide: the measured ones, random lines of the same mean power spectrum, "
        "random lines equivalent to the isotropic surface, or self-affine lines of the same rms "
        "height and slope. A cut has half the mean square slope of the equivalent line.",
        default="measured",
    ),
    "hurst": Key(
        partial(within, least=0.0, most=1.0),
        'The Hurst exponent of `"self-affine"` lines.',
        "Doubled (up to 1), more of the roughness lies in long waves.",
        default=1.0,
    ),
}
MEASURED_KEYS = FILE_KEYS | LINE_KIND_KEYS
SURFACE = RANDOM_KEYS | SPECTRUM_KEYS | MEASURED_KEYS
MAX_RMS_SLOPE = 1000.0  # of a spectrum: beyond it, kind or units are wrong


def read_surface(
    given: Mapping[str, Any],
    folder: Path,
    body: str | None = None,
    *,
    loaded_by_force: bool = False,
) -> Surface:
    """Return the surface for the checked values of a table. Raises UserError.

    folder : of the file. body : its elastic body; None: a half-space if the file holds a map, and
    otherwise a foundation. A half-space uses the lines of a file as one map. loaded_by_force : as
    for ``is_map``.
    """
    if "file" in given:
        return _read_measured(given, folder, body, loaded_by_force)
    refuse_keys("surface", given, MEASURED_KEYS, "goes with surface.file alone")
    surface = Surface(**filled("surface", given, RANDOM_KEYS), body=body or FOUNDATION)
    if "spectrum" in given:
        surface = _with_spectrum(surface, given, folder)
    else:
        refuse_keys("surface", given, ("rms_slope",), f"goes with {SPECTRUM_KEY} alone")
    for key in ("rolloff", "cutoff"):
        if given.get(key, 0.0) > surface.length:
            reason = f"must not be longer than surface.length = {surface.length!r}"
            refuse_keys("surface", given, (key,), reason)
    if surface.rolloff and surface.rolloff <= surface.cutoff:
        reason = f"must be longer than surface.cutoff = {surface.cutoff!r}"
        refuse_keys("surface", given, ("rolloff",), reason)
    return surface


def _read_measured(
    given: Mapping[str, Any], folder: Path, body: str | None, loaded_by_force: bool
) -> Surface:
    """Return the surface of a file; see ``read_surface``."""
    settings = filled("surface", given, FILE_KEYS)
    random = (RANDOM_KEYS | SPECTRUM_KEYS).keys() - {"rolloff"}
    refuse_keys("surface", given, random, "leave it out with surface.file, measured lines")
    if body == HALF_SPACE:
        _check_map_kind("surface", given)
    if settings["step"] is None and len(settings["columns"]) == 1:
        reason = (
            "must be that of positions and those of heights, as [0, 1]; of heights alone with "
            "surface.step"
        )
        refuse_keys("surface", given, ("columns",), reason)
    reading = (settings[key] for key in ("columns", "units", "step", "gaps", "spikes"))
    file = LineFile(folder / settings["file"], settings["file"], *reading)
    lines = read_lines(file)
    if body is None:
        body = HALF_SPACE if is_map(lines, loaded_by_force) else FOUNDATION
    prepare = map_of_lines if body == HALF_SPACE else profile_of_lines
    profile = prepare(file, lines, settings["detrend"], settings["periodic"])
    length, rolloff = profile.measured_length, given.get("rolloff", 0.0)
    if rolloff > length * (1.0 + 1e-9):
        reason = f"must not be longer than the lines of surface.file, {length:.6g} m"
        refuse_keys("surface", given, ("rolloff",), reason)
    surface = Surface(length, rolloff=rolloff, profile=profile, body=body)
    check_cutoff(surface, (profile.spacing,))
    like = {key: value for key, value in given.items() if key in LINE_KIND_KEYS}
    return lines_like("surface", surface, like)


def _with_spectrum(surface: Surface, given: Mapping[str, Any], folder: Path) -> Surface:
    """Return a surface with its measured spectrum and the cut-off of its rms slope.

    given : checked values of the table. Raises UserError.
    """
    refuse_keys("surface", given, ("normalisation",), f"leave it out with {SPECTRUM_KEY}")
    if "rms_slope" in given:
        refuse_keys("surface", given, ("cutoff",), "leave it out with surface.rms_slope")
    power, told = read_spectrum(given["spectrum"], folder)
    longest, shortest = 2.0 * math.pi / power.q[0], 2.0 * math.pi / power.q[-1]
    waves = f"those of {given['spectrum']['file']!r}, {shortest:.4g} to {longest:.4g} m"
    if slope := given.get("rms_slope"):
        try:
            q_1 = power.wave_number_of_slope(slope)
        except ValueError as error:
            raise UserError(f"surface.rms_slope = {slope!r}: {error} are {waves}") from None
        surface = surface._replace(cutoff=2.0 * math.pi / q_1, rms_slope=slope)
        told += f"; rms slope {slope:g} is reached at q_1 = {q_1:.4g} 1/m"
    elif surface.cutoff and surface.cutoff < shortest * (1.0 - 1e-9):
        raise UserError(f"surface.cutoff = {surface.cutoff!r}: is shorter than all waves, {waves}")
    surface = surface._replace(power=power)
    longest = min(longest, surface.length)
    if not surface.least_wave < longest:
        raise UserError(f"surface.length = {surface.length!r}: is shorter than all waves, {waves}")
    told += f"; {_size_of_spectrum(surface, longest, given['spectrum']['kind'])}"
    return surface._replace(power_notes=f"{told}; heights are Gaussian")


def _size_of_spectrum(surface: Surface, longest: float, kind: str) -> str:
    """Return h and the slope of a measured spectrum in words. Raises UserError for a wrong kind.

    longest : wave of the surface, m.
    """
    assert surface.power is not None
    ends = 2.0 * math.pi / np.array([longest, surface.least_wave])
    height, slope = (float(np.diff(part)[0]) ** 0.5 for part in surface.power.moments_below(ends))
    size = f"h = {height:.4g} m and an rms slope of {slope:.4g}"
    size += f" of the waves of {surface.least_wave:.4g} to {longest:.4g} m"
    if height < surface.length and slope < MAX_RMS_SLOPE:
        return size
    raise UserError(
        f"{SPECTRUM_KEY}.kind = {kind!r}: gives {size}, but h must be below surface.length and the "
        f"slope below {MAX_RMS_SLOPE:g}; check kind, times and the units of the file"
    )


def read_measured_surface(given: Mapping[str, Any]) -> Profile:
    """Return the prepared lines, or the map, of the file that the keys of [surface] name.

    The path of the file is relative to the current folder. The rows of a map that a half-space does
    not support are lines. Raises UserError as read_surface does.
    """
    values = checked("surface", given, FILE_KEYS)
    try:
        surface = read_surface(values, Path())
    except UserError:  # also if the cells of a map are not square
        surface = read_surface(values, Path(), FOUNDATION)
    assert surface.profile is not None
    return surface.profile


def _check_map_kind(where: str, table: Mapping[str, Any]) -> None:
    """Raise UserError for kinds of lines that a half-space does not support."""
    lines = table.get("lines", LINE_KINDS[0])
    if lines not in MAP_KINDS:
        raise UserError(f"{where}.lines = {lines!r}: a half-space needs {' or '.join(MAP_KINDS)}")


def lines_like(where: str, surface: Surface, table: Mapping[str, Any]) -> Surface:
    """Return a surface with the requested kind of lines: measured lines, or lines like them.

    ``where`` is the name of the table of checked values. Raises UserError.
    """
    if surface.profile is None:
        refuse_keys(where, table, LINE_KIND_KEYS, "goes with surface.file alone")
    if surface.profile is not None and surface.profile.heights.ndim > 2:
        _check_map_kind(where, table)
    changed = surface._replace(**table)
    try:
        _ = changed.amplitudes
    except ValueError as error:
        raise UserError(f"{where}.hurst = {changed.hurst!r}: {error}") from None
    return changed


def check_cutoff(surface: Surface, spacings: tuple[float, ...]) -> None:
    """Raise UserError if elements do not resolve the shortest wavelength of their lines."""
    cutoff = f"cutoff = {surface.cutoff!r}:"
    if surface.rms_slope:
        cutoff = f"rms_slope = {surface.rms_slope!r}: its shortest wave, {surface.cutoff:.6g} m,"
    rolloff = f"rolloff = {surface.rolloff!r}:"
    for setting, wavelength in ((cutoff, surface.cutoff), (rolloff, surface.rolloff)):
        for spacing in spacings:
            if wavelength and wavelength < 2.0 * spacing * (1.0 - 1e-9):
                raise UserError(
                    f"surface.{setting} must be two spacings or more: "
                    f"{2.0 * spacing:g} at grid.spacing = {spacing!r}"
                )
