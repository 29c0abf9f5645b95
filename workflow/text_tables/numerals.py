"""Parsing of numbers: decimal commas, thousands separators, missing values."""

import math
import re
from collections.abc import Iterable
from typing import NamedTuple

MISSING_WORDS = (
    "nan na n/a #n/a - -- --- ---- * ** *** null none bad inf +inf -inf infinity #num! #div/0! "
    "#value! err error invalid missing ?"
)
MISSING_CELLS = {"", *MISSING_WORDS.split()}
NUMERAL = re.compile(  # at most one decimal mark and one other mark, or grouped digits
    r"[+-]?(?:\d+(?:\.(?:\d+(?:,\d+)?)?|,\d+(?:\.\d*)?)?|[.,]\d+"
    r"|[1-9]\d{0,2}(?:(?:,\d{3})+(?:\.\d*)?|(?:\.\d{3})+(?:,\d+)?))(?:[eEdD][+-]?\d+)?"
)
NUMERAL_TEXT = r"[-+]?\d[\d.,:]*(?:[eE][-+]?\d+)?"  # in prose
CLOCK = re.compile(r"(\d{1,3}):([0-5]\d):([0-5]\d(?:[.,]\d+)?)")  # h:min:s
EXPONENT_MARK = re.compile(r"[eEdD]")
COMMA_GROUPS = re.compile(r"[+-]?[1-9]\d{0,2}(?:,\d{3})+(?:\.\d*)?")  # 1,234,567.8
POINT_GROUPS = re.compile(r"[+-]?[1-9]\d{0,2}(?:\.\d{3})+(?:,\d*)?")  # 1.234.567,8


class Marks(NamedTuple):
    """Decimal and thousands separators of a table; the latter may be empty."""

    decimal: str = "."
    thousands: str = ""

    def plain(self, word: str) -> str:
        """Return a number with a decimal point, an exponent mark e and no thousands separators."""
        if self.thousands:
            word = word.replace(self.thousands, "")
        return word.replace(self.decimal, ".").lower().replace("d", "e")

    def number(self, word: str) -> float:
        """Return the value of a word. Raises ValueError if it is not a number."""
        return float(self.plain(word))


def marks_of(words: Iterable[str]) -> Marks:
    """Return the separators of the numbers of a table.

    Raises ValueError if they are ambiguous: 600,362 may be 600.362 or 600362. Numbers such as 0,5
    or 1,234.5 resolve this. A decimal point in another number does not, since the formats of two
    columns may differ.
    """
    commas, points = set[str](), set[str]()
    marked = ((",", commas), (".", points))
    for word in words:
        for mark, words_with_it in marked:
            if mark in word:
                words_with_it.add(EXPONENT_MARK.split(word, maxsplit=1)[0])
    if not commas:
        grouped = any(word.count(".") > 1 for word in points)
        return Marks("," if grouped else ".", "." if grouped else "")
    if all(map(COMMA_GROUPS.fullmatch, commas)):  # every comma may separate thousands
        if any("." in word or word.count(",") > 1 for word in commas):
            return Marks(".", ",")
        word = min(commas)
        raise ValueError(
            f"{word} may be {word.replace(',', '.')} or {word.replace(',', '')}: write decimal "
            "points and no marks between thousands"
        )
    if all(map(POINT_GROUPS.fullmatch, points)):
        return Marks(",", "." if points else "")
    raise ValueError(
        f"holds both {min(commas)} and {min(points)}: write decimal points and no marks between "
        "thousands"
    )


def is_numeral(word: str) -> bool:
    """Return whether a word is a number, with any separators."""
    return bool(NUMERAL.fullmatch(word))


def seconds_of(word: str) -> float:
    """Return the seconds of a time of day, such as 10:15:03.5, or NaN for other words."""
    match = CLOCK.fullmatch(word)
    if not match:
        return math.nan
    return 3600.0 * int(match[1]) + 60.0 * int(match[2]) + float(match[3].replace(",", "."))


def is_missing(word: str) -> bool:
    """Return whether a word marks a missing value; an empty word does."""
    return word.lower() in MISSING_CELLS
