"""Division of text lines into cells, and the selection of the lines that are table rows."""

import csv
import re
from array import array
from collections import Counter
from contextlib import suppress
from typing import NamedTuple

import numpy as np

from ..ground import counted
from .numerals import is_missing, is_numeral

DELIMITERS = (";", "\t", "|", ",", None)  # None: whitespace
COMMENT_MARKS = ("#", "%", "//", "!")
TRAILING_REMARK = re.compile(r"#(?<=[\s\d]#)(?!N/A|DIV|NUM|VALUE).*$")  # at the end of a row
# Several numbers in a cell indicate a wrong delimiter; a date with a time of day does not match.
SEVERAL_NUMBERS = re.compile(r"(?!\s*\d+([-/.])\d+\1\d+\s+\d+:\d).*\d[\s;]+[-+.\d]")
LEADING_ZERO = re.compile(r"0\d+")  # occurs in the decimals of 1,05, not in integers
# Limits of the sample of lines, from the start and the middle, used to find the delimiter.
MAX_SAMPLE_LINES, MIN_SAMPLE_LINES, MAX_SAMPLE_CHARACTERS = 250, 20, 50_000
MAX_SCORED_CELLS = 1000  # of each line of the sample
# Limits of the lines that are not rows, since some patterns take quadratic time.
MAX_REMARK_CHARACTERS, MAX_TITLE_CHARACTERS, MAX_WORD_CHARACTERS = 10_000, 200, 100_000


class Cells(NamedTuple):
    """Lines of a text and the rows among them."""

    lines: list[str]  # at their line numbers; lines[0] is empty
    rows: "array[int]"  # number of the line of each row
    width: int  # number of cells in each row
    numeric: list[int]  # indices of the columns that hold numbers
    delimiter: str | None

    def row(self, number: int) -> list[str]:
        """Return the cells of a row as written, ``width`` in number."""
        cells = split(_without_remark(self.lines[self.rows[number]]), self.delimiter)
        return cells[: self.width] + [""] * (self.width - len(cells))

    def gaps(self) -> list[tuple[int, list[str]]]:
        """Return the lines before the first row, between rows, and after the last one.

        With each, the index of the next row is given. The lines before the first are always given.
        """
        ends = np.concatenate([[0], self.rows, [len(self.lines)]])
        gaps = {0, *np.flatnonzero(np.diff(ends) > 1).tolist()}
        return [(n, self.lines[ends[n] + 1 : ends[n + 1]]) for n in sorted(gaps)]


def split(line: str, delimiter: str | None) -> list[str]:
    """Return the cells of a line, without quotes."""
    if delimiter is None:
        parts = line.split()
        return [word.strip('"') if word.count('"') == 2 else word for word in parts]
    if '"' in line:
        with suppress(csv.Error):  # a cell of 131 072 characters is not a number
            (cells,) = csv.reader([line.strip()], delimiter=delimiter, skipinitialspace=True)
            return [word.strip() for word in cells]
    return [word.strip() for word in line.split(delimiter)]


def _without_remark(line: str) -> str:
    return TRAILING_REMARK.sub("", line) if "#" in line else line


def is_comment(line: str) -> bool:
    """Return whether a line is a comment."""
    return line.lstrip().startswith(COMMENT_MARKS)


def cells_of(text: str) -> Cells:
    """Return the rows of a text.

    A row has the most frequent number of cells, with numbers in the columns that mostly hold
    numbers. Raises ValueError if there is no row of numbers, or if a row below the first has
    another length.
    """
    lines = text.splitlines()
    lines.insert(0, "")
    delimiter, width, sample = _best_division(_sample_of(lines))
    cells = Cells(lines, array("q"), width, _numeric_columns(sample, width), delimiter)
    for number, line in enumerate(lines):
        if _is_row(line, number, cells):
            cells.rows.append(number)
    if not cells.rows:
        raise ValueError("holds no row of numbers")
    stated = sum(map(is_numeral, cells.row(0)))
    if np.diff(cells.rows[:2]).sum() > 1 and 2 * stated <= len(cells.numeric):
        del cells.rows[0]  # a half empty row above a line of titles
    _check_words(cells)
    return cells


def _sample_of(lines: list[str]) -> list[str]:
    """Return lines from the start and the middle of a text that are not empty or comments.

    Remarks at their ends are removed.
    """
    content = [line for line in lines if line.strip() and not is_comment(line)]
    longest = max(map(len, content), default=1)
    count = max(MIN_SAMPLE_LINES, min(MAX_SAMPLE_LINES, MAX_SAMPLE_CHARACTERS // longest))
    middle = max(len(content) // 2, count)
    return [_without_remark(line) for line in content[:count] + content[middle:][:count]]


def _check_words(cells: Cells) -> None:
    """Raise ValueError if the lines that are not rows exceed the limits."""
    sizes = [len(line.strip()) for _, lines in cells.gaps() for line in lines]
    titles = cells.width * MAX_TITLE_CHARACTERS
    for size, limit, place in (
        (max(sizes, default=0), MAX_REMARK_CHARACTERS + titles, "a line without numbers"),
        (sum(sizes), MAX_WORD_CHARACTERS + titles, "the lines that are not rows of numbers"),
    ):
        if size > limit:
            raise ValueError(f"holds {size} characters in {place}, more than {limit}: shorten them")


def _is_row(line: str, number: int, table: Cells) -> bool:
    """Return whether a line is a row, not a comment or words. Raises ValueError."""
    if not line.strip() or is_comment(line):
        return False
    cells = split(_without_remark(line), table.delimiter)
    values = [cells[n] for n in table.numeric if n < len(cells)]
    numbers, first = sum(map(is_numeral, values)), not table.rows
    words = not all(is_numeral(cell) or is_missing(cell) for cell in values)
    if not numbers or (words and (first or 2 * numbers < len(table.numeric))):
        return False
    divided = len(cells) > 1 and table.delimiter is not None
    fits = not any(cells[table.width :]) and (len(cells) >= table.width or divided)
    if first:
        return fits and len(values) == len(table.numeric)
    if not fits:
        raise ValueError(
            f"line {number} reads {line.strip()!r:.40}: must hold {counted(table.width, 'cell')} "
            "as the rows before it; part the file there if another table begins"
        )
    return True


def _trimmed(cells: list[str]) -> list[str]:
    """Return the cells without trailing empty cells."""
    end = len(cells)
    while end and not cells[end - 1]:
        end -= 1
    return cells[:end]


def _best_division(sample: list[str]) -> tuple[str | None, int, list[list[str]]]:
    """Return the delimiter, the number of cells per row, and the cells of a sample of lines."""
    best: tuple[str | None, int, list[list[str]]] = (None, 1, [])
    most = 0
    for delimiter in DELIMITERS:
        rows = [_trimmed(split(line, delimiter)) for line in sample]
        if delimiter == "," and _has_decimal_commas(rows):
            continue
        score: Counter[int] = Counter()
        for row in rows:
            scored = row[:MAX_SCORED_CELLS]
            several = sum(1 for cell in scored if cell in DELIMITERS or SEVERAL_NUMBERS.match(cell))
            numbers = sum(map(is_numeral, scored))
            score[len(row)] += numbers * (3 * numbers > len(scored)) - 3 * several  # 0 for words
        width, points = max(score.items(), key=lambda item: item[1], default=(1, 0))
        if points > most:
            most, best = points, (delimiter, width, rows)
    return best


def _has_decimal_commas(rows: list[list[str]]) -> bool:
    """Return whether commas are decimal marks: all numeric rows are pairs, one such as 1,05."""
    pairs = [row for row in rows if all(map(is_numeral, row))]
    return (
        bool(pairs)
        and all(len(row) == 2 and "." not in "".join(row) for row in pairs)
        and any(LEADING_ZERO.fullmatch(row[1]) for row in pairs)
    )


def _numeric_columns(rows: list[list[str]], width: int) -> list[int]:
    """Return the columns that hold a number or a missing value in at least half of the rows."""
    rows = [row for row in rows if any(map(is_numeral, row)) and width <= 2 * len(row) <= 2 * width]
    numerals = np.zeros((len(rows), width), dtype=bool)
    missing = np.zeros_like(numerals)
    for n, row in enumerate(rows):
        numerals[n, : len(row)] = list(map(is_numeral, row))
        missing[n, : len(row)] = list(map(is_missing, row))
    mostly_values = 2 * np.count_nonzero(numerals | missing, axis=0) >= len(rows)
    return np.flatnonzero(numerals.any(axis=0) & mostly_values).tolist()
