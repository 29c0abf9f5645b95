"""Names and units of columns, recognised by patterns.

One of LINE_SEPARATORS divides a line above the rows into one title per column. SEPARATOR, or
brackets, divide a title into name and unit. A line is unread if no pattern divides it, if two
patterns divide it differently, or if it holds a unit that belongs to no column. Below an unread
line, columns without a unit are refused.
"""

import re
from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

from .cells import MAX_TITLE_CHARACTERS, Cells, is_comment, split
from .numerals import NUMERAL_TEXT, is_numeral
from .units import CLOCK_WORDS, unit_of

MAX_TITLE_LINES = 4  # lines above the rows that may hold titles
UNREAD_NAME = "?"  # stands for names in an unread line


# Separators of titles, in lines without the delimiter of the rows.
LINE_SEPARATORS = (
    r'"[\s;,|]*"',  # "x" "z"
    r"\t+|\s{2,}",  # Test time  v [mm/s]
    r"\|",  # x [mm] | z [um]
    ";",  # x [mm]; z [um]
    ",",  # x [mm], z [um]
    r"(?<=[\])>}])(?<!\([twfx]\))\s+(?![\[(<{])",  # Raw x [mm] Raw z [um]
    # Names of one word, x [mm] z_um:
    r"(?<!\s/)(?<!\sin)(?<!\s)\s++(?!/\s|in\s|[\[(<{])(?![^\[(<{]{0,60}[\])>}])",
)
# Separators of a name and its unit: t / s, x in mm, Fx, N, v - mm/s
UNIT_MARK = r"\s*/\s*|\s+in\s+|\s*[,;:|]\s*|\s+[-\u2013]\s+"
# v.mm/s; or, as words of the name, Lateral um, velocity_mm_s
SEPARATOR = re.compile(rf"{UNIT_MARK}|(?<=\S)[-.]\s*|\s+|_")
TITLE_WITH_BRACKETS = re.compile(
    r"(.*?)(?:\[([^\[\]]*)\]|\(([^()]*)\)|<([^<>]*)>|\{([^{}]*)\})([^\[\](){}<>]*)"
)
REMARK_WITH_UNIT = re.compile(r"[\])]\s*[:;,\t]\s*[-+.\d]")  # Pixel size [µm]: 0.5
ARGUMENT = re.compile(r"(?<=\S)\((t|ω|omega|w|f|x|y|q|T|i|a|τ|delta|δ|aT|a_T)\)")  # E(t), G'(ω)
BRACKETED = re.compile(r"[\[(<{].*[\])>}]")
COMMENT_MARK = re.compile(r"^\s*(?:#+|!+|//|%(?!\s*[;\t|,])) ?")  # % may be the first unit
UNITS_LABEL = re.compile(r"\s*units?\s*[:=]\s*", re.IGNORECASE)  # units: mm, um
QUANTITY = re.compile(rf"(?<![\w^./-]){NUMERAL_TEXT}\s*[^\s,;]+")  # 0.8 mm
# Units that are also English words.
ENGLISH_UNIT_WORDS = frozenset(("in", "day", "days", "turn", "turns", "foot", "feet", "none", "at"))


class Title(NamedTuple):
    """Name and unit of a column as written in the file."""

    name: str = ""
    unit: str = ""  # as written; "" without a unit
    stated: bool = False  # whether marked as a unit, not only the last word of the name


def header_of(above: Sequence[str], table: Cells) -> tuple[tuple[Title, ...], str]:
    """Return the titles of all columns, or none, and a line with units that no title contains.

    above : lines above the rows; the last MAX_TITLE_LINES may hold titles. A line of units belongs
    to the names above it, or below it. Among several lines of names, the one with the most units
    is used; in a tie, the last one.
    """
    width = table.width
    near = [line for line in above if re.search(r"\w|%", line)][: -MAX_TITLE_LINES - 1 : -1]
    if sum(line.lstrip().startswith("%") for line in near[:2]) == 2:  # a mark, not a unit
        return header_of([re.sub(r"^\s*%", "!", line) for line in above], table)
    lines = [_cells_of(line, table) for line in near]
    read = [tuple(filter(None, map(title_of, cells))) for cells in lines]
    named = [
        titles if any(cells) and len(titles) == len(cells) else ()  # all cells are titles
        for titles, cells in zip(read, lines, strict=True)
    ]
    counts = [sum(unit_of(title.unit) is not None for title in titles) for titles in named]
    for place, cells in enumerate(lines):
        beside = [n for n in (place + 1, place - 1) if 0 <= n < len(lines)]
        names_at = next((n for n in beside if named[n]), None)
        labelled = bool(UNITS_LABEL.match(COMMENT_MARK.sub("", near[place])))
        if not cells or not (labelled or _are_units(cells, names_at is not None)):
            continue
        if names_at is not None and counts[names_at]:
            break
        unread = any(_may_be_names(near[n], width) for n in beside)
        names = (Title(UNREAD_NAME * unread),) * width if names_at is None else named[names_at]
        used = [near[n] for n in (place, names_at) if n is not None]
        units = [_bare_unit(cell) or cell for cell in cells]
        pairs = zip(names, units, strict=True)
        titles = (name._replace(unit=unit, stated=True) if unit else name for name, unit in pairs)
        return tuple(titles), _unread_line(above, near, used)
    if of_names := [n for n, titles in enumerate(named) if any(title.name for title in titles)]:
        best = max(of_names, key=counts.__getitem__)
        return named[best], _unread_line(above, near, [near[best]])
    if near and not is_comment(near[0]) and _may_be_names(near[0], width):
        return (), near[0].strip()
    return (), _unread_line(above, near, [])


def _cells_of(line: str, table: Cells) -> list[str]:
    """Return the cells of a line of titles, one per column; empty for an unread line."""
    delimiter, width = table.delimiter, table.width
    text = UNITS_LABEL.sub("", COMMENT_MARK.sub("", line).strip("\r\n"), count=1)
    if delimiter is None and text.count("\t") >= width:  # more titles than cells
        return [cell.strip() for cell in text.split("\t")[:width]]
    if delimiter is not None and delimiter in text:
        cells = split(text, delimiter)
        while len(cells) > width and not cells[-1]:
            cells.pop()
        if len(cells) == width + 1 and not cells[0]:  # a tab behind a comment mark
            del cells[0]
        if len(cells) > 2 and cells[0].endswith(":"):  # a label of the line
            cells[0] = ""
        short = 2 * len(cells) >= width and _are_units(cells, named=False)
        fits = len(cells) == width or (short and len(cells) < width)
        return cells + [""] * (width - len(cells)) if fits else []
    divided = _divided(text, width)
    numbered = [table.row(n)[0] for n in range(len(table.lines[:2]))] in (["0", "1"], ["1", "2"])
    if divided is None and delimiter is None and numbered and line.startswith("#"):  # of the column
        named = _divided(line, width) or []
        return [] if any(map(_bare_unit, named[1:])) else named
    return divided or []


def _divided(text: str, width: int) -> list[str] | None:
    """Return the titles of a line as all patterns divide it; None if none does."""

    def fits(cells: tuple[str, ...]) -> bool:
        # No cell begins with the unit of the title before it, as "K lg a_T".
        begun = [cell for cell in cells if " " in cell and unit_of(cell.partition(" ")[0])]
        return len(cells) == width and all(
            (title := title_of(c)) is None or title.unit for c in begun
        )

    divided = (re.split(separator, text.strip()) for separator in LINE_SEPARATORS)
    readings = {tuple(cell.strip(' \t";,|') for cell in cells) for cells in divided}
    fitting = list(filter(fits, readings))
    return (list(fitting[0]) if len(fitting) == 1 else []) if fitting else None


def title_of(cell: str) -> Title | None:
    """Return name and unit of a title; None for other texts such as "T = 25" or "tip 2 µm"."""
    text = cell.strip()
    if len(text) > MAX_TITLE_CHARACTERS or _is_remark(text) or is_numeral(text):
        return None
    bracket = TITLE_WITH_BRACKETS.fullmatch(text)
    if bracket and not ARGUMENT.match(text, bracket.end(1)):
        inside = next(part for part in bracket.groups()[1:5] if part is not None).strip()
        return Title(f"{bracket[1].strip()} {bracket[6]}".strip(), inside, stated=bool(inside))
    if len(text) > 1 and unit_of(text):
        return Title("", text, stated=True)
    for match in SEPARATOR.finditer(text):  # the first match leaves the longest unit
        name, unit = text[: match.start()], text[match.end() :]
        if match[0] == "_":
            unit = re.sub("_per_|_", "/", unit)
        is_number = unit == "1" and (match[0] in "-._" or match[0].isspace())  # Height-1, Set 1
        if name and unit_of(unit) and not is_number and not re.match(r"/|in\s", unit):
            return Title(name, unit, stated=match[0].strip() not in ("", "_"))
    return Title(text)


def _is_remark(text: str) -> bool:
    """Return whether a text is a label or contains a quantity, such as "2 µm" or "02:10 PM"."""
    quantity = any(
        re.fullmatch(NUMERAL_TEXT, one) and (unit_of(other.strip(",;")) or other in CLOCK_WORDS)
        for one, other in pairwise(re.split(r"[\s:]+|(?<!\d),", text))
    )
    return quantity or "=" in text or text.endswith(":") or bool(REMARK_WITH_UNIT.search(text))


def _bare_unit(cell: str) -> str:
    """Return the unit in a cell, without brackets; "" for other cells."""
    text = cell.strip()
    bare = text.strip("[](){}<>").strip()
    return bare if unit_of(bare) or BRACKETED.fullmatch(text) else ""


def _are_units(cells: list[str], named: bool) -> bool:
    """Return whether cells hold only units, at least one of them bracketed or of several letters.

    named : whether an adjacent line holds names; then up to half of the units may be unknown.
    """
    filled = [cell for cell in cells if cell.strip()]
    known = list(filter(_bare_unit, filled))
    long = any(len(cell) > 1 for cell in known)
    distinctive = named and (long or any(cell in "1-%#" for cell in known))
    return (len(known) == len(filled) and long) or (distinctive and 2 * len(known) >= len(filled))


def contains_unit(word: str) -> bool:
    """Return whether a word is a unit or contains one, such as "velocity_mm_s"."""
    title = None if word.lower().strip(",.;:()") in ENGLISH_UNIT_WORDS else title_of(word)
    return title is not None and (title.stated or len(title.unit) > 1) and bool(unit_of(title.unit))


def _unread_line(above: Sequence[str], near: list[str], used: list[str]) -> str:
    """Return the last line with units that no title contains; "" without one.

    near : lines above the rows, the last one first. used : those with the titles. A unit after a
    number, as in "Cutoff 0.8 mm", does not count. One letter counts only in the last two lines.
    """
    for line in reversed(above):
        if line in used:
            continue
        words = _words(line) if line in near[:2] else []
        units = [word for word in words if unit_of(word) and word not in ENGLISH_UNIT_WORDS]
        mostly_units = len(words) > 1 and 2 * len(units) >= len(words)
        if mostly_units or any(map(contains_unit, _words(QUANTITY.sub(" ", line)))):
            return line.strip()
    return ""


def _words(line: str) -> list[str]:
    """Return the words of a line without its comment mark."""
    text = COMMENT_MARK.sub("", line)
    return [word.strip('"') for word in re.split(r"[\s,;|]+", text) if word.strip('"')]


def _may_be_names(line: str, width: int) -> bool:
    """Return whether a line (not a remark) has words for all ``width`` columns, or all but "#"."""
    return len(_words(line)) >= width - 1 and ":" not in line and not _is_remark(line.strip())
