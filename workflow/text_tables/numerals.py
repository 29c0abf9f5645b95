"""Parsing of numbers: decimal commas, thousands separators, missing values."""

import math
import re
from collections.abc import Iterable
from functools import lru_cache
from typing import NamedTuple

MISSING_TEXT = (
    " nan na n/a #n/a - -- --- ---- * ** *** null none bad inf +inf -inf infinity #num! #div/0! "
    "#value! err error invalid missing ?"
)
MISSING_CELLS = set(MISSING_TEXT.split(" "))
NUMERAL = re.compile(  # at most one decimal mark and one other mark, or grouped digits
    r"[+-]?(?:\d+(?:\.(?:\d+(?:,\d+)?)?|,\d+(?:\.\d*)?)?|[.,]\d+"
    r"|[1-9]\d{0,2}(?:(?:,\d{3})+(?:\.\d*)?|(?:\.\d{3})+(?:,\d+)?))(?:[eEdD][+-]?\d+)?"
)
NUMERAL_TEXT = r"[-+]?\d[\d.,:]*(?:[eE][-+]?\d+)?"  # in prose
CLOCK = re.compile(r"(\d{1,3}):([0-5]\d):([0-5]\d(?:[.,]\d+)?)")  # h:min:s
EXPONENT_MARK = re.compile(r"[eEdD]")
GROUPS = {  # 1,234,567.8 and 1.234.567,8
    mark: re.compile(rf"[+-]?[1-9]\d{{0,2}}(?:[{mark}]\d{{3}})+(?:[{other}]\d*)?")
    for mark, other in (",.", ".,")
}


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
        """Return the value of a word: NaN if it marks a missing value, infinite if not a number."""
        if is_missing(word):
            return math.nan
        try:
            return float(self.plain(word))
        except ValueError:
            return math.inf


def marks_of(words: Iterable[str]) -> Marks:
    """Return the separators of the numbers among the words of a table.

    Raises ValueError if they are ambiguous: 600,362 may be 600.362 or 600362. Numbers such as 0,5
    or 1,234.5 resolve this. A decimal point in another number does not, since the formats of two
    columns may differ.
    """
    uses: dict[tuple[str, str], str] = {}  # (mark, use) -> the first number with it
    for word in filter(is_numeral, words):
        digits = EXPONENT_MARK.split(word, maxsplit=1)[0]
        for mark, groups in GROUPS.items():
            if mark in digits:
                several = "groups" if len(re.findall("[,.]", digits)) > 1 else "either"
                uses.setdefault((mark, several if groups.fullmatch(digits) else "decimal"), word)
    advice = "write decimal points and no marks between thousands"
    # Numbers in which the decimal mark cannot be a point, and those in which it cannot be a comma.
    commas, points = (
        uses.get((other, "decimal"), uses.get((mark, "groups"))) for mark, other in (".,", ",.")
    )
    if commas and points:
        raise ValueError(f"holds both {commas} and {points}: {advice}")
    either = uses.get((",", "either"))
    if either and (",", "decimal") not in uses and (",", "groups") not in uses:
        raise ValueError(
            f"{either} may be {either.replace(',', '.')} or {either.replace(',', '')}: {advice}"
        )
    decimal, thousands = ",." if commas else ".,"
    return Marks(decimal, thousands if any(mark == thousands for mark, _ in uses) else "")


@lru_cache(maxsize=1000)
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
