"""Remarks above the rows of a table, such as pitch = 0.5 um."""

import re

from .cells import split
from .headers import NUMERAL_TEXT
from .numerals import is_numeral

REMARK = re.compile(r"[#%/!;\s]*([^:=;\t]+?)\s*[:=]\s*(.*?)\s*[;,\t]*")  # Width: 96 µm
QUANTITY_TEXT = re.compile(rf"({NUMERAL_TEXT})\s*(\S.*)?")


def remarks_of(above: list[str], delimiter: str | None, width: int) -> dict[str, str]:
    """Return the values of remarks such as "Width: 96 µm", by their names in lower case.

    A line may hold several remarks. A line of two cells is a name and its value, if the table has
    another number of columns.
    """
    remarks: dict[str, str] = {}
    for line in above:
        cells = split(line, delimiter) if delimiter is not None else []
        few = len(cells) == 2 or (len(cells) == 3 and is_numeral(cells[1]))
        if few and len(cells) != width and all(cells):
            remarks.setdefault(cells[0].lower(), " ".join(cells[1:]))
        for part in re.split(r"[,;\t]\s*(?=[^\W\d])", line.strip()):
            match = REMARK.fullmatch(part.strip())
            if match and match[2]:
                remarks.setdefault(match[1].strip().lower(), match[2].strip('" '))
    return remarks


def quantity_of(text: str) -> tuple[float, str] | None:
    """Return number and unit of a text such as "0.5 um"; None for other texts."""
    match = QUANTITY_TEXT.fullmatch(text.strip())
    if not match:
        return None
    try:
        return float(match[1].replace(",", ".")), (match[2] or "").strip()
    except ValueError:
        return None
