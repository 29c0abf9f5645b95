"""Names and units of columns from the lines above the numbers, and what else is stated there."""

import re
from itertools import pairwise
from typing import NamedTuple

from .cells import DELIMITERS, split
from .numerals import is_numeral
from .units import unit_of

NEAR = 4  # lines above the numbers in which names and units of columns are looked for
BRACKETS = re.compile(
    r"(.*?)\s*(?:\[([^\[\]]*)\]|\(([^()]*)\)|<([^<>]*)>|\{([^{}]*)\})([^\[\](){}<>]*)"
)
ARGUMENTS = frozenset(
    ("t", "ω", "omega", "w", "f", "x", "y", "q", "T", "i", "a", "τ", "delta", "δ", "aT", "a_T")
)  # E(t), G'(ω)
LABELLED = re.compile(r"[#%/!\s]*units?\s*[:=]\s*(.*)", re.IGNORECASE)  # units: mm, um
REMARKED = re.compile(r"[#%/!;\s]*([^:=;\t]+?)\s*[:=]\s*(.*?)\s*[;,\t]*")  # Width: 96 µm
QUANTITY = re.compile(r"([-+]?\d[\d.,:]*(?:[eE][-+]?\d+)?)\s*(\S.*)?")


class Title(NamedTuple):
    """Name and unit of a column as the file has them."""

    name: str = ""
    unit: str = ""  # as it is written; "" where none is
    stated: bool = False  # whether set off as a unit is, and not only the last word of the name


def title_of(cell: str) -> Title | None:
    """Return name and unit of a title; None of what is none, as "cut-off 0.8 mm" or "T = 25"."""
    text = cell.strip().strip('"').strip()
    if "=" in text or text.endswith(":") or _holds_quantity(text):
        return None
    bracket = BRACKETS.fullmatch(text)
    if bracket:
        inside = next(part for part in bracket.groups()[1:5] if part is not None).strip()
        name = f"{bracket[1]} {bracket[6]}".strip()
        if inside in ARGUMENTS and not unit_of(inside) and bracket[1]:
            return Title(text)
        return Title(name, inside, stated=True) if inside else Title(name)
    for pattern in (r"(.*\S)\s+in\s+(\S.*)", r"(.*?\S)\s*/\s*(\S.*)", r"(.*\S)\s*,\s*(\S+)"):
        parts = re.fullmatch(pattern, text)
        if parts and unit_of(parts[2]) and not unit_of(text):
            return Title(parts[1], parts[2], stated=True)
    if len(text) > 1 and unit_of(text):
        return Title("", text, stated=True)
    return _last_words(text)


def _last_words(text: str) -> Title:
    """Return a title whose last word is a unit: G_storage_MPa, velocity_mm_s, Lateral um."""
    parts = [part for part in text.split("_") if part]
    for count in (2, 1):
        unit = "/".join(parts[-count:]) if "per" not in parts else text.rpartition("_per_")[2]
        if "per" in parts:
            before = text.rpartition("_per_")[0].rpartition("_")
            unit, name = f"{before[2]}/{unit}", before[0]
        else:
            name = "_".join(parts[:-count])
        if name and unit_of(unit):
            return Title(name, unit)
    name, _, last = text.rpartition(" ")
    return Title(name.strip(), last) if name and unit_of(last) else Title(text)


def _holds_quantity(text: str) -> bool:
    """Return whether a number stands before a unit in a text, as in "stylus 2 µm" or "02:10 PM"."""
    words = text.split()
    pairs = pairwise(words)
    return any(
        re.fullmatch(r"[-+]?\d[\d.,:]*(?:[eE][-+]?\d+)?", one)
        and (unit_of(other.strip(",;")) or other in ("AM", "PM"))
        for one, other in pairs
    )


def titles_of(above: list[str], delimiter: str | None, width: int) -> tuple[Title, ...]:
    """Return the titles of columns, empty where the file names none.

    above : the lines before the rows, of which the last NEAR count. A line of units goes with the
    names above it; of several lines with names the one with most units counts, then the last.
    """
    near = [line for line in above if re.search(r"\w", line)][-NEAR:]
    units: list[str] = []
    best: tuple[Title, ...] = ()
    for line in reversed(near):
        labelled = LABELLED.fullmatch(line)
        cells = _cells_of_title(labelled[1] if labelled else line, delimiter, width)
        if not cells:
            continue
        only_units = [_bare_unit(cell) for cell in cells]
        if not units and not best and _all_units(cells, bool(labelled)):
            units = [unit or "" for unit in only_units]
            continue
        found = [title_of(cell) for cell in cells]
        if any(title is None for title in found) or all(map(is_numeral, filter(None, cells))):
            continue
        titles = tuple(title for title in found if title is not None)
        if units:
            return tuple(
                own._replace(unit=unit, stated=True) if unit else own
                for own, unit in zip(titles, units, strict=True)
            )
        if _stated(titles) > _stated(best) or not best:
            best = titles
    if units:
        return tuple(Title("", unit, bool(unit)) for unit in units)
    return best


def _stated(titles: tuple[Title, ...]) -> int:
    return sum(bool(title.unit) for title in titles)


def _bare_unit(cell: str) -> str | None:
    text = cell.strip().strip("[](){}<>").strip()
    return text if text and (unit_of(text) or text == "#") else None


def _all_units(cells: list[str], labelled: bool) -> bool:
    """Return whether a line holds units alone, one of which is more than a letter or bracketed."""
    filled = [cell for cell in cells if cell.strip()]
    bracketed = [cell for cell in filled if re.fullmatch(r"[\[(<{].*[\])>}]", cell)]
    if filled and len(bracketed) == len(filled):
        return True
    plain = all(map(_bare_unit, filled))
    return bool(filled) and plain and (labelled or any(len(cell) > 1 for cell in filled))


def _cells_of_title(line: str, delimiter: str | None, width: int) -> list[str]:
    """Return the cells of a line of titles, as many as there are columns; none where it is none."""
    text = line.strip("\r\n").lstrip("#%!").removeprefix("//")
    order = dict.fromkeys((delimiter, *DELIMITERS))
    for each in order:
        if each is None:
            continue
        cells = split(text, each)
        while len(cells) > width and not cells[-1]:
            cells.pop()
        few = each == delimiter and 2 * len(cells) >= width  # empty ones at the end left out
        if 1 < len(cells) <= width and (len(cells) == width or few):
            return cells + [""] * (width - len(cells))
    for found in (re.split(r"\s{2,}|\t", text.strip()), _joined(text)):
        if len(found) == width:
            return found
    return _by_units(text, width)


def _joined(text: str) -> list[str]:
    """Return blank-separated titles, units in brackets or behind a slash with their names."""
    marked = re.sub(r"\s+(?=[\[({<])|\s*/\s*|(?<=\s)in\s+", lambda m: m[0].replace(" ", "\0"), text)
    marked = re.sub(r"[\[(][^\])]*[\])]", lambda m: m[0].replace(" ", "\0"), marked)
    marked = re.sub(r"\s+(?=in\0)", "\0", marked)
    return [word.replace("\0", " ").strip() for word in marked.split()]


def _by_units(text: str, width: int) -> list[str]:
    """Return titles of several words that each end in a unit; none where they do not."""
    bracketed = re.findall(r"[^\[\]()]*[\[(][^\])]*[\])]", text)
    if len(bracketed) == width:
        return [cell.strip() for cell in bracketed]
    found, words = [], []
    for word in text.split():
        words.append(word)
        if len(words) > 1 and unit_of(word):
            found.append(" ".join(words))
            words = []
    return found if len(found) == width and not words else []


def remarks_of(above: list[str], delimiter: str | None, width: int) -> dict[str, str]:
    """Return what lines such as "Width: 96 µm" or "pitch = 0.5 um" state, by names in lower case.

    A line may hold several, and one of two cells, in a table of other rows, a name and its value.
    """
    found: dict[str, str] = {}
    for line in above:
        cells = split(line, delimiter) if delimiter is not None else []
        if len(cells) == 2 != width and all(cells):
            found.setdefault(cells[0].lower(), cells[1])
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
