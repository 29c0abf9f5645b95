"""Division of text lines into cells, and the selection of the lines that are table rows."""

import csv
import re
from collections import Counter
from typing import NamedTuple

from ..ground import counted
from .numerals import is_missing, is_numeral

DELIMITERS = (";", "\t", "|", ",", None)  # None: whitespace
COMMENT_MARKS = ("#", "%", "//", "!")
TRAILING_REMARK = re.compile(r"(?:(?<=\s)|(?<=\d))#(?!N/A|DIV|NUM|VALUE).*$")  # at the end of a row
# Several numbers in a cell indicate a wrong delimiter; a date with a time of day does not match.
SEVERAL_NUMBERS = re.compile(r"(?!\s*\d+([-/.])\d+\1\d+\s+\d+:\d).*\d[\s;]+[-+.\d]")
LEADING_ZERO = re.compile(r"0\d+")  # occurs in the decimals of 1,05, not in integers
# Limits of the sample of lines, from the start and the middle, used to find the delimiter.
MAX_SAMPLE_LINES, MIN_SAMPLE_LINES, MAX_SAMPLE_CHARACTERS = 250, 20, 50_000


class Cells(NamedTuple):
    """Rows of a file and the lines between them."""

    rows: list[list[str]]  # all of equal length
    lines: list[int]  # line number of each row, from 1
    numeric: list[int]  # indices of the columns that hold numbers
    above: list[str]  # lines before the first row
    between: list[tuple[int, list[str]]]  # (index of the next row, lines before it)
    delimiter: str | None
    plain: bool = True  # whether all cells are numbers with decimal points only


def split(line: str, delimiter: str | None) -> list[str]:
    """Return the cells of a line, without quotes."""
    if delimiter is None:
        parts = line.split()
        return [word.strip('"') if word.count('"') == 2 else word for word in parts]
    if '"' in line:
        return [word.strip() for word in next(csv.reader([line.strip()], delimiter=delimiter))]
    return [word.strip() for word in line.split(delimiter)]


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
    content = [
        (n, line) for n, line in enumerate(lines, 1) if line.strip() and not is_comment(line)
    ]
    longest = max((len(line) for _, line in content), default=1)
    count = max(MIN_SAMPLE_LINES, min(MAX_SAMPLE_LINES, MAX_SAMPLE_CHARACTERS // longest))
    middle = max(len(content) // 2, count)
    sample = [line for _, line in content[:count] + content[middle:][:count]]
    delimiter, width = _delimiter_and_width(sample)
    rows = [_trimmed(split(TRAILING_REMARK.sub("", line), delimiter)) for line in sample]
    numeric = _numeric_columns([row for row in rows if len(row) <= width], width)
    cells = Cells([], [], numeric, [], [], delimiter)
    pending: list[str] = []
    pattern, plain = _plain_row_pattern(delimiter, width if len(numeric) == width else 0), True
    for number, line in enumerate(lines, 1):
        if pattern.fullmatch(line):  # the fast path for long files
            row: list[str] | None = split(line, delimiter)
        else:
            row = _row_cells(line, number, cells, width)
            plain = plain and row is None
        if row is None:
            pending.append(line)
            continue
        if not cells.rows:
            cells.above.extend(pending)
        elif pending:
            cells.between.append((len(cells.rows), pending))
        pending = []
        cells.rows.append(row)
        cells.lines.append(number)
    if not cells.rows:
        raise ValueError("holds no row of numbers")
    cells.between.append((len(cells.rows), pending))
    return cells._replace(plain=plain)


def _plain_row_pattern(delimiter: str | None, width: int) -> re.Pattern[str]:
    """Return the pattern of a row of `width` decimal numbers; for 0 it never matches."""
    if not width:
        return re.compile(r"(?!)")
    number = r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?"
    gap, blank = (r"\s+", r"\s*") if delimiter is None else (rf" *{re.escape(delimiter)} *", " *")
    return re.compile(rf"{blank}{number}(?:{gap}{number}){{{width - 1}}}{blank}")


def _row_cells(line: str, number: int, table: Cells, width: int) -> list[str] | None:
    """Return the cells of a row; None for comments and lines of words. Raises ValueError."""
    if is_comment(line):
        return None
    untrimmed = split(TRAILING_REMARK.sub("", line), table.delimiter)
    cells = _trimmed(untrimmed)
    numeric_cells = [cells[n] for n in table.numeric if n < len(cells)]
    numbers = sum(map(is_numeral, numeric_cells))
    first = not table.rows
    if not numbers or (2 * numbers < len(table.numeric) and not all(map(_is_value, numeric_cells))):
        return None
    short = len(numeric_cells) < len(table.numeric) and len(untrimmed) < width
    if first and (short or not all(map(_is_value, numeric_cells))):
        return None
    if len(cells) > width or (
        len(untrimmed) < width and (table.delimiter is None or len(untrimmed) < 2)
    ):
        if first:
            return None
        raise ValueError(
            f"line {number} reads {line.strip()!r:.40}: must hold {counted(width, 'cell')} as the "
            "rows before it"
        )
    return cells + [""] * (width - len(cells))


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
        rows = [_trimmed(split(TRAILING_REMARK.sub("", line), delimiter)) for line in sample]
        if delimiter == "," and _has_decimal_commas(rows):
            continue
        score: Counter[int] = Counter()
        for row in rows:
            several = sum(1 for cell in row if cell in DELIMITERS or SEVERAL_NUMBERS.match(cell))
            numbers = sum(map(is_numeral, row))
            score[len(row)] += numbers * (3 * numbers > len(row)) - 3 * several  # 0 for words
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
    columns = []
    for column in range(width):
        column_cells = [row[column] for row in rows if column < len(row)]
        numbers = sum(map(is_numeral, column_cells))
        if numbers and 2 * sum(map(_is_value, column_cells)) >= len(rows):
            columns.append(column)
    return columns
