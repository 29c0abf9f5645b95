"""Tables of positions and heights in text files: units of the header, rounded numbers."""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from ...errors import UserError
from ..settings import BrokenRowError, Rows, read_rows
from .units import units_in

HEADER = 3  # lines before the numbers in which units are looked for


class Table(NamedTuple):
    """The columns asked for."""

    values: np.ndarray  # shape (columns, rows)
    written: tuple[str, ...]  # the numbers of the first column as they are written
    units: tuple[str, ...]  # of each column, from the header; empty where it names none


def read_text(key: str, name: str, data: bytes, columns: tuple[int, ...]) -> Table:
    """Return columns of a text file; ``key`` and ``name`` of the file are for messages.

    Raises UserError for a file without rows, and naming the line for a row that breaks off, holds
    words or numbers that are not finite.
    """
    try:
        rows = read_rows(data, columns)
    except BrokenRowError as error:
        raise UserError(
            f"{key} = {name!r}: {error}: must hold finite numbers in columns {list(columns)}"
        ) from None
    if not rows.lines:
        raise UserError(f"{key} = {name!r}: holds no line with numbers in columns {list(columns)}")
    return Table(rows.values, rows.written, _units(rows, columns))


def _units(rows: Rows, columns: tuple[int, ...]) -> tuple[str, ...]:
    """Return one unit per column from the lines just before the numbers, or none."""
    for line in reversed(rows.header[-HEADER:]):
        words = line.lstrip("#%/! ").split(rows.delimiter)
        if max(columns) < len(words):
            found = [units_in(words[column])[-1:] for column in columns]
            if all(found):
                return tuple(unit for (unit,) in found)
        units = units_in(line)  # "x [um] z [um]" has blanks within its titles
        if len(units) > max(columns):
            return tuple(units[column] for column in columns)
    return ()


def precision(written: Iterable[str]) -> np.ndarray:
    """Return to how much each number is written: 0.1 for 1499.8, also for 3 in the same column.

    Formats cut numbers after a decimal or after a count of digits, and may leave out zeros at the
    end; so the finest decimal and the largest count of digits of the column hold for all of it.
    """
    parts = [_parts(word) for word in written]
    finest = min(exponent for _, exponent in parts)
    most = max(digits for digits, _ in parts)
    sizes = np.array([abs(float(word)) for word in written])
    with np.errstate(divide="ignore"):
        leading = np.floor(np.log10(sizes))
    return np.maximum(10.0**finest, 10.0 ** (leading - most + 1.0))


def _parts(word: str) -> tuple[int, int]:
    """Return the count of digits and the exponent of the last one of a written number."""
    mantissa, _, exponent = word.lower().partition("e")
    whole, _, decimals = mantissa.lstrip("+-").partition(".")
    digits = len((whole + decimals).lstrip("0"))
    return digits, int(exponent or 0) - len(decimals)
