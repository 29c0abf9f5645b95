"""Lines of text parted into cells, and which of them are rows of a table."""

import csv
import re
from collections import Counter
from typing import NamedTuple

from .numerals import is_missing, is_numeral

DELIMITERS = (";", "\t", "|", ",", None)  # None: any blanks
COMMENTS = ("#", "%", "//", "!")
REMARK = re.compile(r"(?:(?<=\s)|(?<=\d))#(?!N/A|DIV|NUM|VALUE).*$")  # behind a row
# Numbers in one cell, for the delimiter is another; but a date and a time of day.
SEVERAL = re.compile(r"(?!\s*\d+([-/.])\d+\1\d+\s+\d+:\d).*\d[\s;]+[-+.\d]")
ZEROS = re.compile(r"0\d+")  # no whole number is written so, but decimals are
# Lines from the beginning and from the middle that decide on the delimiter: so many characters.
LOOKED_AT, LEAST_LOOKED_AT, ENOUGH = 250, 20, 50_000


class Cells(NamedTuple):
    """The rows of a file, and what stands between them."""

    rows: list[list[str]]  # each of as many cells
    lines: list[int]  # the number of the line of each row, from 1
    numeric: list[int]  # the columns that hold numbers
    above: list[str]  # the lines before the first row
    between: list[tuple[int, list[str]]]  # before which row, and the lines that stand there
    delimiter: str | None
    plain: bool = True  # whether all rows are numbers with points alone, and none is missing


class UnevenRowError(ValueError):
    """A row that holds more or fewer cells than the others: the line, its number, their count."""


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
    return line.lstrip().startswith(COMMENTS)


def cells_of(text: str) -> Cells:
    """Return the rows of a text, none where it holds none.

    Rows have the most frequent count of cells, with numbers in the columns that mostly hold them.
    Raises UnevenRowError for a row of another count below the first.
    """
    lines = text.splitlines()
    bare = [(n, line) for n, line in enumerate(lines, 1) if line.strip() and not is_comment(line)]
    longest = max((len(line) for _, line in bare), default=1)
    count = max(LEAST_LOOKED_AT, min(LOOKED_AT, ENOUGH // longest))
    sample = [line for _, line in bare[:count] + bare[max(len(bare) // 2, count) :][:count]]
    delimiter, width = _shape(sample)
    parts = [_trimmed(split(REMARK.sub("", line), delimiter)) for line in sample]
    numeric = _numeric([row for row in parts if len(row) <= width], width)
    found = Cells([], [], numeric, [], [], delimiter)
    if not numeric:
        return found._replace(above=lines)
    pending: list[str] = []
    quick, plain = _plain_row(delimiter, width if len(numeric) == width else 0), True
    for number, line in enumerate(lines, 1):
        if quick.fullmatch(line):  # as nearly all rows of long files are
            row: list[str] | None = split(line, delimiter)
        elif not line.strip() or is_comment(line):
            row = None
        else:
            row = _row(line, number, found, width)
            plain = plain and row is None
        if row is None:
            pending.append(line)
            continue
        if not found.rows:
            found.above.extend(pending)
        elif pending:
            found.between.append((len(found.rows), pending))
        pending = []
        found.rows.append(row)
        found.lines.append(number)
    if not found.rows:
        return found._replace(above=lines)
    found.between.append((len(found.rows), pending))
    return found._replace(plain=plain)


def _plain_row(delimiter: str | None, width: int) -> re.Pattern[str]:
    """Return the pattern of a row of so many numbers with points; of nothing for none."""
    if not width:
        return re.compile(r"(?!)")
    number = r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?"
    gap, blank = (r"\s+", r"\s*") if delimiter is None else (rf" *{re.escape(delimiter)} *", " *")
    return re.compile(rf"{blank}{number}(?:{gap}{number}){{{width - 1}}}{blank}")


def _row(line: str, number: int, known: Cells, width: int) -> list[str] | None:
    """Return the cells of a row; None of a line that is none, as words between blocks."""
    raw = split(REMARK.sub("", line), known.delimiter)
    cells = _trimmed(raw)
    own = [cells[n] for n in known.numeric if n < len(cells)]
    numbers = sum(map(is_numeral, own))
    first = not known.rows
    if not numbers or (2 * numbers < len(known.numeric) and not all(map(_value, own))):
        return None
    short = len(own) < len(known.numeric) and len(raw) < width
    if first and (short or not all(map(_value, own))):
        return None
    if len(cells) > width or (len(raw) < width and (known.delimiter is None or len(raw) < 2)):
        if first:
            return None
        raise UnevenRowError(line.strip(), number, width)
    return cells + [""] * (width - len(cells))


def _value(word: str) -> bool:
    return is_numeral(word) or is_missing(word)


def _trimmed(cells: list[str]) -> list[str]:
    """Return cells without empty ones at the end."""
    end = len(cells)
    while end and not cells[end - 1]:
        end -= 1
    return cells[:end]


def _shape(sample: list[str]) -> tuple[str | None, int]:
    """Return the delimiter, and the count of cells of a row."""
    best: tuple[int, str | None, int] = (0, None, 1)
    for delimiter in DELIMITERS:
        rows = [_trimmed(split(REMARK.sub("", line), delimiter)) for line in sample]
        if delimiter == "," and _decimals(rows):
            continue
        score: Counter[int] = Counter()
        for row in rows:
            several = sum(1 for cell in row if cell in DELIMITERS or SEVERAL.match(cell))
            numbers = sum(map(is_numeral, row))
            score[len(row)] += numbers * (3 * numbers > len(row)) - 3 * several  # else words
        width, points = max(score.items(), key=lambda item: item[1], default=(1, 0))
        if points > best[0]:
            best = (points, delimiter, width)
    return best[1:]


def _decimals(rows: list[list[str]]) -> bool:
    """Return whether commas between two cells of every row are decimal: 1,05 is not 1 and 05."""
    pairs = [row for row in rows if all(map(is_numeral, row))]
    return (
        bool(pairs)
        and all(len(row) == 2 and "." not in "".join(row) for row in pairs)
        and any(ZEROS.fullmatch(row[1]) for row in pairs)
    )


def _numeric(rows: list[list[str]], width: int) -> list[int]:
    """Return the columns in which numbers stand in half of the rows at least."""
    rows = [row for row in rows if any(map(is_numeral, row)) and 2 * len(row) >= width]
    found = []
    for column in range(width):
        own = [row[column] for row in rows if column < len(row)]
        numbers = sum(map(is_numeral, own))
        if numbers and 2 * sum(map(_value, own)) >= len(rows):
            found.append(column)
    return found
