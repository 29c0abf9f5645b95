"""Tables of numbers in text files as instruments write them: headers, delimiters, commas."""

import math
from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from workflow.errors import UserError
from workflow.study.surfaces.units import units_in

DELIMITERS = (";", "\t", ",", None)  # None: any blanks
COMMENTS = ("#", "%", "//", "!")
HEADER = 3  # lines before the numbers in which units are looked for


class Table(NamedTuple):
    """The columns asked for."""

    values: np.ndarray  # shape (columns, rows)
    written: tuple[str, ...]  # the numbers of the first column as they are written
    units: tuple[str, ...]  # of each column, from the header; empty where it names none


def read_text(key: str, name: str, data: bytes, columns: tuple[int, ...]) -> Table:
    """Return columns of a text file; ``key`` and ``name`` of the file are for messages.

    Lines before the first row of numbers are the header, lines that begin with #, %, // or ! and
    empty ones are passed over. A delimiter is one of ; tab , or blanks; where it is no comma,
    numbers may have decimal commas.

    Raises UserError for a file without rows, and naming the line for a row that breaks off, holds
    words or numbers that are not finite.
    """
    lines = _decoded(data).splitlines()
    start, delimiter = _first_row(lines, columns)
    if start == len(lines):
        raise UserError(f"{key} = {name!r}: holds no line with numbers in columns {list(columns)}")
    rows = []
    for number, line in enumerate(lines[start:], start + 1):
        if not line.strip() or line.strip().startswith(COMMENTS):
            continue
        row = _numbers(line, delimiter, columns)
        if row is None or not all(math.isfinite(float(word)) for word in row):
            raise UserError(
                f"{key} = {name!r}: line {number} reads {line.strip()!r:.60}: must hold finite "
                f"numbers in columns {list(columns)}"
            )
        rows.append(row)
    values = np.array(rows, dtype=float).T
    written = tuple(row[0] for row in rows)
    return Table(values, written, _units(lines[:start], delimiter, columns))


def _decoded(data: bytes) -> str:
    """Return the text of a file; instruments seldom say which encoding they write."""
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        return data.decode("utf-16", errors="replace")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        return data.decode("latin-1")  # knows every byte, and the micro sign


def _first_row(lines: list[str], columns: tuple[int, ...]) -> tuple[int, str | None]:
    """Return the index of the first row of numbers, and its delimiter."""
    for index, line in enumerate(lines):
        for delimiter in DELIMITERS:
            if _numbers(line, delimiter, columns) is not None:
                return index, delimiter
    return len(lines), None


def _numbers(line: str, delimiter: str | None, columns: tuple[int, ...]) -> list[str] | None:
    """Return the numbers in the columns of a line as they are written; None where there are not."""
    words = [word.strip() for word in line.split(delimiter)]
    if max(columns) >= len(words):
        return None
    chosen = [words[column] for column in columns]
    if delimiter != ",":
        chosen = [word.replace(",", ".") if "." not in word else word for word in chosen]
    return chosen if all(map(_is_number, chosen)) else None


def _is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True


def _units(header: list[str], delimiter: str | None, columns: tuple[int, ...]) -> tuple[str, ...]:
    """Return one unit per column from the lines just before the numbers, or none."""
    for line in reversed(header[-HEADER:]):
        words = line.lstrip("#%/! ").split(delimiter)
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
