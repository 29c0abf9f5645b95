"""Rows of numbers in text files as instruments and people write them: the one reader of text.

Lines before the first row of numbers are the header. Empty lines, and lines that begin with #, %,
// or !, are passed over; so is what stands behind a # in a row. A delimiter is one of ; tab , or
blanks; where it is no comma, numbers may have decimal commas.
"""

import math
import re
from pathlib import Path
from typing import NamedTuple

import numpy as np

from ...errors import UserError
from ...plain_files import read_plain

DELIMITERS = (";", "\t", ",", None)  # None: any blanks
COMMENTS = ("#", "%", "//", "!")


class BrokenRowError(ValueError):
    """A row that breaks off, or holds words or numbers that are not finite."""

    def __init__(self, number: int, line: str) -> None:
        super().__init__(f"line {number} reads {line.strip()!r:.60}")
        self.number = number
        self.line = line.strip()


class Rows(NamedTuple):
    """The columns asked for; no rows where the file holds no line with numbers in them."""

    values: np.ndarray  # shape (columns, rows)
    written: tuple[str, ...]  # the numbers of the first column as they are written
    lines: tuple[int, ...]  # the number of the line of each row, from 1
    header: tuple[str, ...]  # the lines before the first row
    delimiter: str | None


def read_rows(data: bytes, columns: tuple[int, ...], exact: bool = False) -> Rows:
    """Return columns of a text file.

    columns : their numbers, from 0. exact : a row must hold as many numbers, and no more. Raises
    BrokenRowError for the first row after the header that does not hold them.
    """
    lines = _decoded(data).splitlines()
    start, delimiter = _first_row(lines, columns)
    rows, numbers = [], []
    for number, line in enumerate(lines[start:], start + 1):
        if not line.strip() or line.strip().startswith(COMMENTS):
            continue
        words = _words(line, delimiter)
        row = _numbers(words, delimiter, columns)
        too_many = exact and len(words) > len(columns)
        if row is None or too_many or not all(math.isfinite(float(word)) for word in row):
            raise BrokenRowError(number, line)
        rows.append(row)
        numbers.append(number)
    values = np.array(rows, dtype=float).reshape(len(rows), len(columns)).T
    written = tuple(row[0] for row in rows)
    return Rows(values, written, tuple(numbers), tuple(lines[:start]), delimiter)


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
            if _numbers(_words(line, delimiter), delimiter, columns) is not None:
                return index, delimiter
    return len(lines), None


def _words(line: str, delimiter: str | None) -> list[str]:
    """Return the entries of a line, without a comment and without empty ones at its end."""
    words = [word.strip() for word in line.partition("#")[0].split(delimiter)]
    while words and not words[-1]:
        words.pop()
    return words


def _numbers(words: list[str], delimiter: str | None, columns: tuple[int, ...]) -> list[str] | None:
    """Return the numbers in the columns of a line as they are written; None where there are not."""
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


def read_columns(key: str, path: Path, names: tuple[str, ...]) -> Rows:
    """Return the columns of a text file that holds just these, all of their numbers finite.

    Raises UserError, naming ``key`` and the line, for a file that cannot be read or holds anything
    else.
    """
    return rows_of_file(key, path, tuple(range(len(names))), names, exact=True)


def rows_of_file(
    key: str, path: Path, columns: tuple[int, ...], names: tuple[str, ...], exact: bool = False
) -> Rows:
    """Return chosen columns of a text file; names : what they hold, for messages.

    Raises UserError as ``read_columns``.
    """
    places = "" if exact else f" in columns {list(columns)}"
    try:
        rows = read_rows(read_plain(path), columns, exact)
    except BrokenRowError as error:
        raise UserError(
            f"{key}: line {error.number} of {str(path)!r} reads {error.line!r:.40}: must hold "
            f"{len(names)} finite numbers{places}, {', '.join(names[:-1])} and {names[-1]}"
        ) from None
    except (OSError, ValueError) as error:  # ValueError: no name of a file
        reason = getattr(error, "strerror", None) or error
        raise UserError(f"{key} = {str(path)!r}: cannot be read: {reason}") from None
    if not rows.lines:
        raise UserError(f"{key} = {str(path)!r}: holds no row of {len(names)} numbers{places}")
    return rows


def named_unit(key: str, option: str, units: re.Pattern[str], header: str) -> str | None:
    """Return the one unit that the header of a file names; None where it names none.

    Raises UserError for two: ``option`` chooses.
    """
    found = list(dict.fromkeys(units.findall(header)))
    if len(found) > 1:
        raise UserError(f"{key}: names the units {' and '.join(found)}; choose by {option}")
    return found[0] if found else None
