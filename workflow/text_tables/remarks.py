"""What is stated above the numbers beside names and units of columns: pitch = 0.5 um."""

import re

from .cells import split
from .numerals import is_numeral
from .titles import NUMBER

REMARKED = re.compile(r"[#%/!;\s]*([^:=;\t]+?)\s*[:=]\s*(.*?)\s*[;,\t]*")  # Width: 96 µm
QUANTITY = re.compile(rf"({NUMBER})\s*(\S.*)?")


def remarks_of(above: list[str], delimiter: str | None, width: int) -> dict[str, str]:
    """Return what lines such as "Width: 96 µm" or "pitch = 0.5 um" state, by names in lower case.

    A line may hold several, and one of two cells, in a table of other rows, a name and its value.
    """
    found: dict[str, str] = {}
    for line in above:
        cells = split(line, delimiter) if delimiter is not None else []
        few = len(cells) == 2 or (len(cells) == 3 and is_numeral(cells[1]))
        if few and len(cells) != width and all(cells):
            found.setdefault(cells[0].lower(), " ".join(cells[1:]))
        for part in re.split(r"[,;\t]\s*(?=[^\W\d])", line.strip()):
            match = REMARKED.fullmatch(part.strip())
            if match and match[2]:
                found.setdefault(match[1].strip().lower(), match[2].strip('" '))
    return found


def quantity_of(text: str) -> tuple[float, str] | None:
    """Return number and unit of a text such as "0.5 um"; None of any other text."""
    match = QUANTITY.fullmatch(text.strip())
    if not match:
        return None
    try:
        return float(match[1].replace(",", ".")), (match[2] or "").strip()
    except ValueError:
        return None
