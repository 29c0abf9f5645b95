"""Division of text lines into cells, and the selection of the lines that are table rows."""

import csv
import re
from array import array
from collections import Counter
from contextlib import suppress

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


class Cells:
    """Rows of a text, and the lines between them.

    A row has the most frequent number of cells, with numbers in the columns that mostly hold
    numbers.
    """

    def __init__(self, text: str) -> None:
        """Find the rows.

        Raises ValueError if there is no row of numbers, or if a row below the first has another
        length.
        """
        text_lines = text.splitlines()
        self.delimiter, self.width, sample = _best_division(text_lines)
        self.numeric = _numeric_columns(sample, self.width)  # indices of the columns of numbers
        self.lines = array("q")  # line number of each row
        for number, line in enumerate(text_lines, 1):
            if self._is_row(line, number):
                self.lines.append(number)
        if not self.lines:
            raise ValueError("holds no row of numbers")
        self._rows = [TRAILING_REMARK.sub("", text_lines[number - 1]) for number in self.lines]
        stated = sum(map(is_numeral, self.row(0)))
        if np.diff(self.lines[:2]).sum() > 1 and 2 * stated <= len(self.numeric):
            del self.lines[0], self._rows[0]  # a half empty row above a line of titles
        ends = np.concatenate([[0], self.lines, [len(text_lines) + 1]])
        # Index of the next row -> lines before it; those before the first row are always there.
        self.gaps = {
            n: tuple(text_lines[ends[n] : ends[n + 1] - 1])
            for n in sorted({0, *np.flatnonzero(np.diff(ends) > 1).tolist()})
        }
        self.above = self.gaps[0]
        self._check_words()

    def row(self, number: int) -> list[str]:
        """Return the cells of a row as written, ``width`` in number."""
        cells = split(self._rows[number], self.delimiter)
        return cells[: self.width] + [""] * (self.width - len(cells))

    def _check_words(self) -> None:
        """Raise ValueError if the lines that are not rows exceed the limits."""
        sizes = [len(line.strip()) for lines in self.gaps.values() for line in lines]
        titles = self.width * MAX_TITLE_CHARACTERS
        for size, limit, place in (
            (max(sizes, default=0), MAX_REMARK_CHARACTERS, "a line without numbers"),
            (sum(sizes), MAX_WORD_CHARACTERS, "the lines that are not rows of numbers"),
        ):
            if size > limit + titles:
                raise ValueError(
                    f"holds {size} characters in {place}, more than {limit + titles}: shorten them"
                )

    def _is_row(self, line: str, number: int) -> bool:
        """Return whether a line is a row, not a comment or words. Raises ValueError."""
        if not line.strip() or is_comment(line):
            return False
        cells = split(TRAILING_REMARK.sub("", line), self.delimiter)
        values = [cells[n] for n in self.numeric if n < len(cells)]
        numbers, first = sum(map(is_numeral, values)), not self.lines
        words = not all(is_numeral(cell) or is_missing(cell) for cell in values)
        if not numbers or (words and (first or 2 * numbers < len(self.numeric))):
            return False
        divided = len(cells) > 1 and self.delimiter is not None
        fits = not any(cells[self.width :]) and (len(cells) >= self.width or divided)
        if first:
            return fits and len(values) == len(self.numeric)
        if not fits:
            raise ValueError(
                f"line {number} reads {line.strip()!r:.40}: must hold "
                f"{counted(self.width, 'cell')} as the rows before it; part the file there if "
                "another table begins"
            )
        return True


def split(line: str, delimiter: str | None) -> list[str]:
    """Return the cells of a line, without quotes."""
    if delimiter is None:
        return [word.strip('"') if word.count('"') == 2 else word for word in line.split()]
    if '"' in line:
        with suppress(csv.Error):  # a cell of 131 072 characters is not a number
            (cells,) = csv.reader([line.strip()], delimiter=delimiter, skipinitialspace=True)
            return [word.strip() for word in cells]
    return [word.strip() for word in line.split(delimiter)]


def is_comment(line: str) -> bool:
    """Return whether a line is a comment."""
    return line.lstrip().startswith(COMMENT_MARKS)


def _best_division(lines: list[str]) -> tuple[str | None, int, list[list[str]]]:
    """Return the delimiter, the number of cells per row, and the cells of a sample of lines.

    The sample is taken from the start and the middle, without comments.
    """
    content = [line for line in lines if line.strip() and not is_comment(line)]
    longest = max(map(len, content), default=1)
    count = max(MIN_SAMPLE_LINES, min(MAX_SAMPLE_LINES, MAX_SAMPLE_CHARACTERS // longest))
    content = content[:count] + content[max(len(content) // 2, count) :][:count]
    sample = [TRAILING_REMARK.sub("", line) for line in content]
    best: tuple[str | None, int, list[list[str]]] = (None, 1, [])
    most = 0
    for delimiter in DELIMITERS:
        rows = [split(line, delimiter) for line in sample]
        for row in rows:  # without trailing empty cells
            while row and not row[-1]:
                row.pop()
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


def _numeric_columns(rows: list[list[str]], width: int) -> tuple[int, ...]:
    """Return the columns that hold a number or a missing value in at least half of the rows."""
    rows = [row for row in rows if any(map(is_numeral, row)) and width <= 2 * len(row) <= 2 * width]
    columns = [[row[n] for row in rows if n < len(row)] for n in range(width)]
    return tuple(
        n
        for n, cells in enumerate(columns)
        if any(map(is_numeral, cells))
        and 2 * sum(is_numeral(cell) or is_missing(cell) for cell in cells) >= len(rows)
    )
