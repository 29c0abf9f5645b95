"""Rows of a text file with titles and blocks, before their units are converted."""

import re
from collections.abc import Iterator
from functools import cached_property
from itertools import pairwise
from pathlib import Path

import numpy as np

from ..ground import UserError, decoded, foreign_content, is_text, read_plain
from .cells import Cells, is_comment
from .headers import Title, header_of
from .numerals import Marks, marks_of, seconds_of
from .units import unit_of

MAX_LISTED = 12  # columns in one message
MIN_BLOCK_ROWS = 3  # minimum mean size of blocks separated by empty lines or comments


def _is_words(line: str) -> bool:
    return bool(re.search(r"\w", line)) and not is_comment(line)


class TextTable(Cells):
    """Rows of a text file, with titles and the lines between blocks."""

    def __init__(self, key: str, name: str, text: str) -> None:
        """Read a text. ``key`` and the ``name`` of the file begin every message.

        Raises UserError if it has no row of numbers or rows of different lengths, or if its numbers
        are ambiguous.
        """
        self.key, self.name, self.prefix = key, name, f"{key} = {name!r}"
        try:
            super().__init__(text)
            # Between cells that commas separate, decimal commas need quotes.
            comma = '"' if self.delimiter == "," else ","
            self.marks = Marks()
            if re.search(rf"{comma}|\.\d+\.", text):  # not only decimal points
                rows = map(self.row, range(len(self.lines)))
                self.marks = marks_of(row[n] for row in rows for n in self.numeric)
        except ValueError as error:
            raise self.refused(str(error)) from None
        self.titles, self.unread = header_of(self.above, self)
        self._check_blocks()

    def refused(self, reason: str) -> UserError:
        """Return the error with a reason to refuse the file, and the remedy."""
        return UserError(f"{self.prefix}: {reason}")

    @property
    def passed_over(self) -> tuple[str, ...]:
        """Return the lines of words below the first row."""
        below = (line for at, lines in self.gaps.items() if at for line in lines)
        return tuple(line.strip() for line in below if _is_words(line))

    @cached_property
    def blocks(self) -> tuple[slice, ...]:
        """Return the rows of each block. Lines of words, or empty lines, separate blocks."""
        blank = [at for at in self.gaps if 0 < at < len(self.lines)]
        words = [at for at in blank if any(map(_is_words, self.gaps[at]))]
        many = len(blank) * MIN_BLOCK_ROWS > len(self.lines)  # e.g. every other line is empty
        starts = [0, *(words if many else blank), len(self.lines)]
        return tuple(slice(a, b) for a, b in pairwise(starts))

    def _check_blocks(self) -> None:
        """Raise UserError if titles below the first row state other units or another order."""
        between = [(lines, at) for at, lines in self.gaps.items() if 0 < at < len(self.lines)]
        for lines, at in dict(between[::-1]).items():  # the first of several alike
            titles, _ = header_of(lines, self)
            names = [[title.name for title in header] for header in (titles, self.titles)]
            units = [[unit_of(title.unit) for title in header] for header in (titles, self.titles)]
            pairs = zip(*units, strict=False)
            differ = any(first and second and first[1:] != second[1:] for first, second in pairs)
            if differ or (names[0] != names[1] and sorted(names[0]) == sorted(names[1])):
                raise self.refused(
                    f"the titles above line {self.lines[at]} name other units or another order of "
                    "columns than those above the first row: part the file there"
                )

    def title(self, column: int) -> Title:
        """Return the title of a column; an empty title if the file, or the column, has none."""
        return self.titles[column] if column < len(self.titles) else Title()

    def words(self, column: int) -> Iterator[str]:
        """Yield the cells of a column as written."""
        return (self.row(n)[column] for n in range(len(self.lines)))

    def values(self, column: int) -> np.ndarray:
        """Return the numbers of a column, shape (rows,), before unit conversion; NaN if missing.

        Raises UserError, naming the line, for a word that is not a number.
        """
        values = np.ascontiguousarray(self._numbers[:, column])
        for row in np.flatnonzero(np.isinf(values)).tolist():
            words = " ".join(self.row(row))
            raise self.refused(
                f"line {self.lines[row]} reads {words!r:.40}: must hold a number in column {column}"
            )
        return values

    @cached_property
    def clocks(self) -> dict[int, np.ndarray]:
        """Return the seconds, shape (rows,), of each column of times of day, as 10:15:03.5."""
        words = [n for n in range(self.width) if seconds_of(self.row(0)[n]) >= 0.0]
        seconds = {n: np.array([seconds_of(word) for word in self.words(n)]) for n in words}
        return {n: values for n, values in seconds.items() if np.isfinite(values).all()}

    @cached_property
    def _numbers(self) -> np.ndarray:
        """Return the numbers of all columns, shape (rows, width), as ``Marks.number``."""
        numbers = np.empty((len(self.lines), self.width))
        for row in range(len(self.lines)):
            numbers[row] = list(map(self.marks.number, self.row(row)))
        return numbers

    @property
    def columns_text(self) -> str:
        """Return a list of the columns for messages, with their numbers and units."""
        if not self.titles:
            return f"{self.width} columns without names"
        named = [
            f"{n} {title.name or '(no name)'}{f' [{title.unit}]' if title.unit else ''}"
            for n, title in enumerate(self.titles[:MAX_LISTED])
        ]
        return f"the columns {', '.join([*named, '...'] if self.width > MAX_LISTED else named)}"


def read_text_table(key: str, path: Path, name: str | None = None) -> TextTable:
    """Return the table of a text file; ``name`` is its name in messages, by default the path.

    Raises UserError, which begins with ``key``, for a file that cannot be read, is an archive or
    not text, has no row of numbers or rows of different lengths, or has ambiguous numbers.
    """
    name = str(path) if name is None else name
    try:
        data = read_plain(path)
    except (OSError, ValueError) as error:  # ValueError: invalid file name
        reason = getattr(error, "strerror", None) or error
        raise UserError(f"{key} = {name!r}: cannot be read: {reason}") from None
    if kind := foreign_content(data):
        raise UserError(f"{key} = {name!r}: is {kind}")
    if not is_text(data):
        raise UserError(f"{key} = {name!r}: cannot be read: it is not text")
    text = decoded(data)
    del data
    return TextTable(key, name, text)
