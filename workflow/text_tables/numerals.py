"""Decoding of text and parsing of numbers: decimal commas, thousands separators, missing values."""

import re
from collections.abc import Iterable
from typing import NamedTuple

MISSING_WORDS = (
    "nan na n/a #n/a - -- --- ---- * ** *** null none bad inf +inf -inf infinity #num! #div/0! "
    "#value! err error invalid missing ?"
)
MISSING_CELLS = {"", *MISSING_WORDS.split()}
NUMERAL = re.compile(r"[+-]?(?:\d+(?:[.,]\d+)*\.?|[.,]\d+)(?:[eEdD][+-]?\d+)?")
EXPONENT_MARK = re.compile(r"[eEdD]")
COMMA_GROUPS = re.compile(r"[+-]?[1-9]\d{0,2}(?:,\d{3})+(?:\.\d*)?")  # 1,234,567.8
POINT_GROUPS = re.compile(r"[+-]?[1-9]\d{0,2}(?:\.\d{3})+(?:,\d*)?")  # 1.234.567,8
TEXT_BYTES = bytes(byte for byte in range(256) if byte >= 32 or byte in b"\t\n\r\f\v")
CLEAN_BYTES = 4096  # bytes at the start of a text that hold no control character
CONTROL_SHARE = 1e-3  # of the bytes of a text
ARCHIVE_SIGNATURES = {
    b"PK\x03\x04": "a zip archive",
    b"\x1f\x8b": "a gzip archive",
    b"BZh": "a bzip2 archive",
    b"\xfd7zXZ": "an xz archive",
    b"7z\xbc\xaf": "a 7z archive",
    b"Rar!": "a rar archive",
}


class Marks(NamedTuple):
    """Decimal and thousands separators of a table; the latter may be empty."""

    decimal: str = "."
    thousands: str = ""

    def plain(self, word: str) -> str:
        """Return a number with a decimal point, an exponent mark e and no thousands separators."""
        if self.thousands:
            word = word.replace(self.thousands, "")
        return EXPONENT_MARK.sub("e", word.replace(self.decimal, "."))

    def number(self, word: str) -> float:
        """Return the value of a word. Raises ValueError if it is not a number."""
        return float(self.plain(word))


def marks_of(words: Iterable[str]) -> Marks:
    """Return the separators of the numbers of a table.

    Raises ValueError if they are ambiguous: 600,362 may be 600.362 or 600362. Numbers such as 0,5
    or 1,234.5 resolve this. A decimal point in another number does not, since the formats of two
    columns may differ.
    """
    commas, points = set(), set()
    for word in words:
        mantissa = EXPONENT_MARK.split(word, maxsplit=1)[0]
        if "," in mantissa:
            commas.add(mantissa)
        if "." in mantissa:
            points.add(mantissa)
    if not commas:
        grouped = any(word.count(".") > 1 for word in points)
        return Marks("," if grouped else ".", "." if grouped else "")
    if all(map(COMMA_GROUPS.fullmatch, commas)):  # all may be integers in groups of three digits
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
    if not NUMERAL.fullmatch(word):
        return False
    several = word.count(".") > 1 or word.count(",") > 1  # grouped digits, or a date
    mantissa = EXPONENT_MARK.split(word, maxsplit=1)[0]
    return not several or bool(COMMA_GROUPS.fullmatch(mantissa) or POINT_GROUPS.fullmatch(mantissa))


def is_missing(word: str) -> bool:
    """Return whether a word marks a missing value; an empty word does."""
    return word.lower() in MISSING_CELLS


def archive_kind(data: bytes) -> str:
    """Return the kind of archive with these first bytes, in words; "" for other files."""
    if data[257:262] == b"ustar":
        return "a tar archive"
    return next((kind for begin, kind in ARCHIVE_SIGNATURES.items() if data.startswith(begin)), "")


def is_text(data: bytes) -> bool:
    """Return whether a file is text.

    The first CLEAN_BYTES bytes of a text hold no control character except whitespace, and
    the rest hold very few. The rest is examined because binary data may follow a text header.
    """
    if _utf_16_encoding(data):
        return True
    data = data.rstrip(b"\x1a\0")  # end marks of old systems
    controls = data.translate(None, TEXT_BYTES)
    return not data[:CLEAN_BYTES].translate(None, TEXT_BYTES) and len(
        controls
    ) <= CONTROL_SHARE * len(data)


def _utf_16_encoding(data: bytes) -> str:
    """Return the variant of UTF-16 of a text; "" for other encodings.

    Without a byte order mark, every other byte must be zero at the start and half of them overall.
    """
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        return "utf-16"
    for first, encoding in ((1, "utf-16-le"), (0, "utf-16-be")):
        high, low = data[first::2], data[1 - first :: 2]
        if len(high) > 8 and not any(high[:32]) and 2 * high.count(0) > len(high):
            return encoding if is_text(low) else ""
    return ""


def decoded(data: bytes) -> str:
    """Return the text of a file. Its encoding is inferred, as instruments seldom state it."""
    if encoding := _utf_16_encoding(data):
        text = data.decode(encoding, errors="replace")
    else:
        try:
            text = data.decode("utf-8-sig")
        except UnicodeDecodeError:
            text = data.decode("latin-1")  # decodes every byte, also the micro sign
    return text.replace("\u2212", "-")
