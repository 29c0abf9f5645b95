"""Lines of text parted into cells, and which of them are rows of a table."""

import csv
import re
from collections import Counter
from typing import NamedTuple

from .numerals import is_missing, is_numeral

DELIMITERS = (";", "\t", ",", None)  # None: any blanks
COMMENTS = ("#", "%", "//", "!")
REMARK = re.compile(r"(?:(?<=\s)|(?<=\d))#(?!N/A|DIV|NUM|VALUE).*$")  # behind a row
SEVERAL = re.compile(r"\d[\s;]+[-+.\d]")  # numbers in one cell: the delimiter is another
ZEROS = re.compile(r"0\d+")  # no whole number is written so, but decimals are
LOOKED_AT = 250  # lines from the beginning and from the middle that decide on the delimiter


class Cells(NamedTuple):
    """The rows of a file, and what stands between them."""

    rows: list[list[str]]  # each of as many cells
    lines: list[int]  # the number of the line of each row, from 1
    numeric: list[int]  # the columns that hold numbers
    above: list[str]  # the lines before the first row
    between: list[tuple[int, list[str]]]  # before which row, and the lines that stand there
    delimiter: str | None


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
    middle = len(bare) // 2
    sample = [line for _, line in bare[:LOOKED_AT] + bare[max(middle, LOOKED_AT) :][:LOOKED_AT]]
    delimiter, width = _shape(sample)
    parts = [_trimmed(split(REMARK.sub("", line), delimiter)) for line in sample]
    numeric = _numeric([row for row in parts if len(row) <= width], width)
    found = Cells([], [], numeric, [], [], delimiter)
    if not numeric:
        return found._replace(above=lines)
    pending: list[str] = []
    for number, line in enumerate(lines, 1):
        row = None if not line.strip() or is_comment(line) else _row(line, number, found, width)
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
    return found


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
            several = sum(1 for cell in row if SEVERAL.search(cell))
            score[len(row)] += sum(map(is_numeral, row)) - 3 * several
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
