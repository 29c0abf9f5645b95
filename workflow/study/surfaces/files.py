"""Readers of measured lines: text, npy, netCDF, and the formats of SurfaceTopography."""

from typing import Any

import numpy as np

from ...ground import foreign_content, is_text, open_plain, read_plain
from ...system import unreadable
from .instrument_files import read_instrument_file
from .positions import rounding
from .raw_lines import LineFile, Lines, RawLines, check_numbered, lines_of, plain, row_spacing
from .text_lines import read_text_lines

DEFAULT_COLUMNS = (0, 1)
MAX_HEIGHTS = 10**8  # in a netCDF file; a compressed file of 8 kB may hold more
ARCHIVE_SUFFIXES = (".x3p", ".npy")  # formats that are, or contain, archives
SCALED_TEXT_SUFFIXES = (".sdf", ".ezd", ".nid", ".plu")  # text with headers that scale the numbers


def read_lines(file: LineFile) -> Lines:
    """Return the lines of a file in m.

    ``.npy`` and ``.nc`` are recognised by suffix, and text by its content. SurfaceTopography reads
    other files. Raises UserError, one line that names key and file, for a file that cannot be
    read, and as ``lines_of`` does.
    """
    suffix = file.path.suffix.lower()
    reader = {".npy": _read_npy, ".nc": _read_netcdf}.get(suffix)
    try:
        open_plain(file.path, linked=True).close()  # refuses pipes, which readers would open
        if reader is None:
            data = read_plain(file.path)
            kind = foreign_content(data)
            if kind and suffix not in ARCHIVE_SUFFIXES:
                raise file.refused(f"is {kind}")
            text = is_text(data) and suffix not in SCALED_TEXT_SUFFIXES
            del data
            reader = read_text_lines if text else read_instrument_file
        return lines_of(file, reader(file))
    except (OSError, EOFError, ValueError, TypeError, RuntimeError) as error:
        reason = getattr(error, "strerror", None) or str(error).partition("\n")[0]
        raise file.refused(f"cannot be read: {reason}") from None


def _read_npy(file: LineFile) -> RawLines:
    try:
        values = np.load(file.path, mmap_mode="r", allow_pickle=False)  # read on access
    except (OSError, ValueError):
        raise
    except Exception as error:  # a forged header can cause any exception
        raise ValueError(f"its header is not that of an array: {error}") from error
    if not isinstance(values, np.ndarray):
        raise ValueError("holds several arrays")
    columns = file.columns or (DEFAULT_COLUMNS if file.step is None else (0,))
    check_numbered(file)
    if values.ndim == 1 and file.step is not None:
        values = values[:, None]
    if values.ndim != 2 or values.shape[1] <= max(columns) or values.dtype.kind not in "fiu":
        raise file.refused(
            f"holds an array of shape {values.shape} and type {values.dtype}: must be numbers, a "
            f"row per sample, with columns {list(columns)}"
        )
    with np.errstate(invalid="ignore"):  # NaN of single precision
        table = values[:, columns].T.astype(float)
    description = f"columns {list(columns)}"
    if file.step is not None:
        return RawLines(table, (), description, step=file.step)
    return RawLines(table[1:], (), description, table[0], rounding(values[:, columns[0]]))


def _read_netcdf(file: LineFile) -> RawLines:
    import netCDF4

    if why := unreadable([file.path]).get(file.path):
        raise ValueError(why)
    with netCDF4.Dataset(file.path) as data:
        x, z = _variables(file, data.variables)
        if z.size > MAX_HEIGHTS:
            raise ValueError(f"{z.size} heights, more than {MAX_HEIGHTS}")
        heights = np.moveaxis(plain(z[:]), z.dimensions.index(x.dimensions[0]), -1)
        across = [data.variables.get(name) for name in z.dimensions if name not in x.dimensions]
        rows = None
        if len(across) == 1 and across[0] is not None:
            rows = row_spacing(plain(across[0][:]), _unit(across[0]) or _unit(x))
        return RawLines(
            heights.reshape(-1, x.size),
            (_unit(x), _unit(z)),
            f"variables {x.name} and {z.name}",
            plain(x[:]),
            rounding(x[:]),
            row_spacing=rows,
        )


def _unit(variable: Any) -> str:
    return str(getattr(variable, "units", getattr(variable, "unit", "")))


def _variables(file: LineFile, variables: dict) -> tuple:
    """Return the variables of positions and heights of a netCDF file."""
    if file.columns:
        names = file.columns
    else:
        heights = [n for n, v in variables.items() if v.ndim and (n,) != v.dimensions]
        along = variables[heights[0]].dimensions if len(heights) == 1 else ("",)
        names = ("x" if "x" in along else along[-1], *heights)
    if len(names) != 2 or any(name not in variables for name in names):
        raise file.refused(
            f"holds the variables {', '.join(variables)}: name positions and heights, as "
            'surface.columns = ["x", "height"]'
        )
    x, z = (variables[name] for name in names)
    if x.ndim != 1 or not set(x.dimensions) <= set(z.dimensions):
        raise file.refused(
            f"{names[0]!r} does not hold the positions of the samples of {names[1]!r}: must have "
            "one dimension, shared with the heights"
        )
    return x, z
