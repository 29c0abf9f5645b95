"""Numbers as they are written, in any encoding: decimal commas, thousands marks, missing values."""

import re
from collections.abc import Iterable
from typing import NamedTuple

WORDS = (
    "nan na n/a #n/a - -- --- ---- * ** *** null none bad inf +inf -inf infinity #num! #div/0! "
    "#value! err error invalid missing ?"
)
MISSING = {"", *WORDS.split()}
NUMERAL = re.compile(r"[+-]?(?:\d+(?:[.,]\d+)*\.?|[.,]\d+)(?:[eEdD][+-]?\d+)?")
EXPONENT = re.compile(r"[eEdD]")
BY_COMMAS = re.compile(r"[+-]?[1-9]\d{0,2}(?:,\d{3})+(?:\.\d*)?")  # 1,234,567.8
BY_POINTS = re.compile(r"[+-]?[1-9]\d{0,2}(?:\.\d{3})+(?:,\d*)?")  # 1.234.567,8
PRINTED = bytes(byte for byte in range(256) if byte >= 32 or byte in b"\t\n\r\f\v")
HEAD = 4096  # bytes of a text without a control character
STRAY = 1e-3  # share of control characters in one
ARCHIVES = {
    b"PK\x03\x04": "a zip archive",
    b"\x1f\x8b": "a gzip archive",
    b"BZh": "a bzip2 archive",
    b"\xfd7zXZ": "an xz archive",
    b"7z\xbc\xaf": "a 7z archive",
    b"Rar!": "a rar archive",
}


class Marks(NamedTuple):
    """What stands before decimals, and between thousands ("" where nothing does)."""

    decimal: str = "."
    thousands: str = ""

    def plain(self, word: str) -> str:
        """Return a number with a decimal point, e before the exponent and no other marks."""
        if self.thousands:
            word = word.replace(self.thousands, "")
        return EXPONENT.sub("e", word.replace(self.decimal, "."))

    def number(self, word: str) -> float:
        """Return the number that a word is. Raises ValueError for a word that is none."""
        return float(self.plain(word))


def marks_of(words: Iterable[str]) -> Marks:
    """Return how numbers are written, all of a table.

    Raises ValueError where that cannot be told: 600,362 may be 600.362 or 600362, unless a number
    shows which, as 0,5 does, or 1,234.5. A point in another number alone does not: that may be
    written otherwise.
    """
    commas, points = set(), set()
    for word in words:
        mantissa = EXPONENT.split(word, maxsplit=1)[0]
        if "," in mantissa:
            commas.add(mantissa)
        if "." in mantissa:
            points.add(mantissa)
    if not commas:
        many = any(word.count(".") > 1 for word in points)
        return Marks("," if many else ".", "." if many else "")
    if all(map(BY_COMMAS.fullmatch, commas)):  # each may be a whole number in groups of three
        if any("." in word or word.count(",") > 1 for word in commas):
            return Marks(".", ",")
        word = min(commas)
        raise ValueError(
            f"{word} may be {word.replace(',', '.')} or {word.replace(',', '')}: write decimal "
            "points and no marks between thousands"
        )
    if all(map(BY_POINTS.fullmatch, points)):
        return Marks(",", "." if points else "")
    raise ValueError(
        f"holds both {min(commas)} and {min(points)}: write decimal points and no marks between "
        "thousands"
    )


def is_numeral(word: str) -> bool:
    """Return whether a word is a number, with whatever marks."""
    if not NUMERAL.fullmatch(word):
        return False
    several = word.count(".") > 1 or word.count(",") > 1  # grouped, or a date
    mantissa = EXPONENT.split(word, maxsplit=1)[0]
    return not several or bool(BY_COMMAS.fullmatch(mantissa) or BY_POINTS.fullmatch(mantissa))


def is_missing(word: str) -> bool:
    """Return whether a word says that a value is missing; an empty one does."""
    return word.lower() in MISSING


def archive_kind(data: bytes) -> str:
    """Return which archive the first bytes of a file begin, in words; "" where they do not."""
    if data[257:262] == b"ustar":
        return "a tar archive"
    return next((kind for begin, kind in ARCHIVES.items() if data.startswith(begin)), "")


def is_text(data: bytes) -> bool:
    """Return whether a file is text: no control characters but blanks, or hardly any far behind.

    Binary numbers may begin behind a header that is text.
    """
    if _utf_16(data):
        return True
    data = data.rstrip(b"\x1a\0")  # with which old systems end a text
    controls = data.translate(None, PRINTED)
    return not data[:HEAD].translate(None, PRINTED) and len(controls) <= STRAY * len(data)


def _utf_16(data: bytes) -> str:
    """Return which UTF-16 a text is in; "" where every other byte is not zero."""
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        return "utf-16"
    for first, encoding in ((1, "utf-16-le"), (0, "utf-16-be")):
        high, low = data[first::2], data[1 - first :: 2]
        if len(high) > 8 and not any(high[:32]) and 2 * high.count(0) > len(high):
            return encoding if is_text(low) else ""
    return ""


def decoded(data: bytes) -> str:
    """Return the text of a file; instruments seldom say which encoding they write."""
    if encoding := _utf_16(data):
        text = data.decode(encoding, errors="replace")
    else:
        try:
            text = data.decode("utf-8-sig")
        except UnicodeDecodeError:
            text = data.decode("latin-1")  # knows every byte, and the micro sign
    return text.replace("\u2212", "-")
