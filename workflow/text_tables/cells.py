"""Division of text lines into cells, and the selection of the lines that are table rows."""

import csv
import re
from array import array
from collections import Counter
from collections.abc import Iterator
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
END_OF_LINE = re.compile("\r\n|[\n\r\v\f\x1c-\x1e\x85\u2028\u2029]")  # as in str.splitlines
# Limits of the lines that are not rows, since some patterns take quadratic time.
MAX_REMARK_CHARACTERS, MAX_TITLE_CHARACTERS, MAX_WORD_CHARACTERS = 10_000, 200, 100_000


class Cells(NamedTuple):
    """Rows of a text and the lines between them. A row takes 24 bytes beside the text."""

    text: str
    width: int  # number of cells in each row
    starts: "array[int]"  # index of the first character of each row
    ends: "array[int]"  # index after its last character
    lines: "array[int]"  # line number of each row, from 1
    numeric: list[int]  # indices of the columns that hold numbers
    above: list[str]  # lines before the first row
    between: list[tuple[int, list[str]]]  # (index of the next row, lines before it)
    delimiter: str | None
    plain: bool = True  # whether all cells are numbers with a decimal mark at most

    def row(self, number: int) -> list[str]:
        """Return the cells of a row as written, ``width`` in number."""
        line = self.text[self.starts[number] : self.ends[number]]
        if self.plain:
            return split(line, self.delimiter)
        cells = _trimmed(split(_without_remark(line), self.delimiter))
        return cells + [""] * (self.width - len(cells))


def split(line: str, delimiter: str | None) -> list[str]:
    """Return the cells of a line, without quotes."""
    if delimiter is None:
        parts = line.split()
        return [word.strip('"') if word.count('"') == 2 else word for word in parts]
    if '"' in line:
        return [word.strip() for word in next(csv.reader([line.strip()], delimiter=delimiter))]
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
    text = END_OF_LINE.sub("\n", text) + "\n"
    sample = _sample_of(text)
    delimiter, width = _delimiter_and_width(sample)
    rows = [_trimmed(split(line, delimiter)) for line in sample]
    numeric = _numeric_columns([row for row in rows if len(row) <= width], width)
    starts, ends, numbers = array("q"), array("q"), array("q")
    cells = Cells(text, width, starts, ends, numbers, numeric, [], [], delimiter)
    pending: list[str] = []
    pattern, plain = _plain_row_pattern(delimiter, width if len(numeric) == width else 0), True
    for number, (start, line) in enumerate(_lines(text), 1):
        if not pattern.fullmatch(line):  # the fast path for long files
            if not _is_row(line, number, cells):
                if line or pending[-1:] != [""]:  # one empty line stands for several
                    pending.append(line)
                continue
            plain = False
        if not starts:
            cells.above.extend(pending)
        elif pending:
            cells.between.append((len(starts), pending))
        pending = []
        starts.append(start)
        ends.append(start + len(line))
        numbers.append(number)
    if not starts:
        raise ValueError("holds no row of numbers")
    cells.between.append((len(starts), pending))
    cells = cells._replace(plain=plain)
    _check_words(cells)
    _move_head_row(cells)
    return cells


def _move_head_row(cells: Cells) -> None:
    """Move a first row that is mostly empty and stands above a line of titles to the head."""
    at, titles = cells.between[0]
    if at == 1 < len(cells.lines) and 2 * sum(map(is_numeral, cells.row(0))) < len(cells.numeric):
        cells.above.extend([cells.text[cells.starts[0] : cells.ends[0]], *titles])
        for rows in (cells.starts, cells.ends, cells.lines, cells.between):
            del rows[0]
        cells.between[:] = [(row - 1, lines) for row, lines in cells.between]


def _lines(text: str) -> Iterator[tuple[int, str]]:
    """Return the lines of a text with the indices of their first characters."""
    return ((match.start(1), match[1]) for match in re.finditer("(.*)\n", text))


def _sample_of(text: str) -> list[str]:
    """Return lines from the start and the middle of a text that are not empty or comments.

    Remarks at their ends are removed.
    """
    starts, longest = array("q"), 1
    for start, line in _lines(text):
        if line.strip() and not is_comment(line):
            starts.append(start)
            longest = max(longest, len(line))
    count = max(MIN_SAMPLE_LINES, min(MAX_SAMPLE_LINES, MAX_SAMPLE_CHARACTERS // longest))
    middle = max(len(starts) // 2, count)
    sample = starts[:count] + starts[middle:][:count]
    return [_without_remark(text[start : text.index("\n", start)]) for start in sample]


def _check_words(cells: Cells) -> None:
    """Raise ValueError if the lines that are not rows exceed the limits."""
    sizes = [len(line.strip()) for _, lines in ((0, cells.above), *cells.between) for line in lines]
    titles = cells.width * MAX_TITLE_CHARACTERS
    for size, limit, place in (
        (max(sizes, default=0), MAX_REMARK_CHARACTERS + titles, "a line without numbers"),
        (sum(sizes), MAX_WORD_CHARACTERS + titles, "the lines that are not rows of numbers"),
    ):
        if size > limit:
            raise ValueError(f"holds {size} characters in {place}, more than {limit}: shorten them")


def _plain_row_pattern(delimiter: str | None, width: int) -> re.Pattern[str]:
    """Return the pattern of a row of `width` plain numbers; for 0 it never matches."""
    if not width:
        return re.compile(r"(?!)")
    mark = r"\." if delimiter == "," else "[.,]"
    number = rf"[+-]?(?:\d+(?:{mark}\d*)?|{mark}\d+)(?:[eE][+-]?\d+)?"
    gap, blank = (r"\s+", r"\s*") if delimiter is None else (rf" *{re.escape(delimiter)} *", " *")
    return re.compile(rf"{blank}{number}(?:{gap}{number}){{{width - 1}}}{blank}")


def _is_row(line: str, number: int, table: Cells) -> bool:
    """Return whether a line is a row, not a comment or words. Raises ValueError."""
    if not line.strip() or is_comment(line):
        return False
    untrimmed = split(_without_remark(line), table.delimiter)
    cells = _trimmed(untrimmed)
    numeric_cells = [cells[n] for n in table.numeric if n < len(cells)]
    numbers = sum(map(is_numeral, numeric_cells))
    width = table.width
    first = not table.starts
    if not numbers or (2 * numbers < len(table.numeric) and not all(map(_is_value, numeric_cells))):
        return False
    short = len(numeric_cells) < len(table.numeric) and len(untrimmed) < width
    if first and (short or not all(map(_is_value, numeric_cells))):
        return False
    if len(cells) > width or (
        len(untrimmed) < width and (table.delimiter is None or len(untrimmed) < 2)
    ):
        if first:
            return False
        raise ValueError(
            f"line {number} reads {line.strip()!r:.40}: must hold {counted(width, 'cell')} as the "
            "rows before it; part the file there if another table begins"
        )
    return True


def _is_value(word: str) -> bool:
    return is_numeral(word) or is_missing(word)


def _trimmed(cells: list[str]) -> list[str]:
    """Return the cells without trailing empty cells."""
    end = len(cells)
    while end and not cells[end - 1]:
        end -= 1
    return cells[:end]


def _delimiter_and_width(sample: list[str]) -> tuple[str | None, int]:
    """Return the delimiter and the number of cells per row."""
    best: tuple[int, str | None, int] = (0, None, 1)
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
        if points > best[0]:
            best = (points, delimiter, width)
    return best[1:]


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
    rows = [row for row in rows if any(map(is_numeral, row)) and 2 * len(row) >= width]
    numerals = np.zeros((len(rows), width), dtype=bool)
    missing = np.zeros_like(numerals)
    for n, row in enumerate(rows):
        numerals[n, : len(row)] = list(map(is_numeral, row))
        missing[n, : len(row)] = list(map(is_missing, row))
    mostly_values = 2 * np.count_nonzero(numerals | missing, axis=0) >= len(rows)
    return np.flatnonzero(numerals.any(axis=0) & mostly_values).tolist()
