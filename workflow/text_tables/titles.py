"""Names and units of columns from the lines above the numbers."""

import re
from collections.abc import Iterable
from itertools import pairwise
from typing import NamedTuple

from .cells import DELIMITERS, is_comment, split
from .numerals import is_numeral
from .units import is_product, unit_of

MAX_UNIT_LINES = 200  # lines above the rows that are searched for unread units
MAX_TITLE_LINES = 4  # lines above the rows that may hold titles
TITLE_WITH_BRACKETS = re.compile(
    r"(.*?)\s*(?:\[([^\[\]]*)\]|\(([^()]*)\)|<([^<>]*)>|\{([^{}]*)\})([^\[\](){}<>]*)"
)
MAX_UNIT_WORDS = 3  # for example mm per s
UNREAD_NAME = "?"  # stands for a name that was not understood
BRACKETED = re.compile(r"[\[(<{].*[\])>}]")
ARGUMENTS = frozenset(
    ("t", "ω", "omega", "w", "f", "x", "y", "q", "T", "i", "a", "τ", "delta", "δ", "aT", "a_T")
)  # E(t), G'(ω)
COMMENT_MARK = re.compile(r"^\s*(?:#+|%(?=%\s*[;\t|,])|%+|!+|//)")
UNITS_LABEL = re.compile(r"[#%/!\s]*units?\s*[:=]\s*(.*)", re.IGNORECASE)  # units: mm, um
NUMERAL_TEXT = r"[-+]?\d[\d.,:]*(?:[eE][-+]?\d+)?"
# Separators of a name and its unit. After whitespace or _ the unit is not marked as such.
SEPARATOR = re.compile(r"\s+in\s+|\s+[-\u2013]\s+|\s*[/,;:|]\s*|(?<=\S)[-.]\s*|[\s_]+")
SET_OFF_SEPARATOR = re.compile(r"\s+in\s+|\s+[-\u2013]\s+|\s*[/,;:|]\s*")  # end a name
# Last words of names that are not units.
NAME_WORDS_TEXT = (
    "abs absolute act actual amplitude angular average avg axis channel cmd coef coeff "
    "coefficient command commanded corrected d data delta displacement drive elapsed factor "
    "filt filtered force frequency friction horizontal index lateral length lin load log lp "
    "mean measured moduli modulus motor nominal normal number of oscillation point pos "
    "position prime ratio raw ref rel relative sensor set setpoint shear signal slider "
    "speed stage step storage strain stress target test time tot total value values vel "
    "velocity vertical x y z \u03b4"
)
NAME_WORDS = frozenset(NAME_WORDS_TEXT.split())
# Units that are also English words.
ENGLISH_UNIT_WORDS = frozenset(("in", "day", "days", "turn", "turns", "foot", "feet", "none", "at"))


class Title(NamedTuple):
    """Name and unit of a column as written in the file."""

    name: str = ""
    unit: str = ""  # as written; "" without a unit
    stated: bool = False  # whether marked as a unit, not only the last word of the name


def title_of(cell: str) -> Title | None:
    """Return name and unit of a title; None for other texts such as "T = 25" or "tip 2 µm"."""
    text = cell.strip()
    if "=" in text or text.endswith(":") or _holds_quantity(text) or is_numeral(text):
        return None
    bracket = TITLE_WITH_BRACKETS.fullmatch(text)
    if bracket:
        inside = next(part for part in bracket.groups()[1:5] if part is not None).strip()
        name = f"{bracket[1]} {bracket[6]}".strip()
        if inside in ARGUMENTS and not unit_of(inside) and bracket[1]:
            outer = title_of(f"{bracket[1]}{bracket[6]}")
            return outer._replace(name=text) if outer and outer.unit else Title(text)
        return Title(name, inside, stated=True) if inside else Title(name)
    if len(text) > 1 and unit_of(text):
        return Title("", text, stated=True)
    return _split_title(text)


def _split_title(text: str) -> Title:
    """Return a title split before its longest unit: v in mm/s, Lateral. um, velocity_mm_per_s."""
    for match in SEPARATOR.finditer(text):
        name, unit, separator = text[: match.start()], text[match.end() :], match[0].strip()
        unit = re.sub("_per_|_", "/", unit) if separator == "_" else unit
        is_number = match[0] in ("-", ".") and unit == "1"  # Height-1 is a name
        if name and unit_of(unit) and not is_number and not re.match(r"/|in\s", unit):
            return Title(name, unit, stated=separator not in ("", "_"))
        if name and re.match("[a-zµ]?[A-Z]", unit) and is_product(unit):  # of torque, as mN m
            return Title(name, unit, stated=True)
    return Title(text)


def _holds_quantity(text: str) -> bool:
    """Return whether a text contains a number with a unit, such as "2 µm" or "02:10 PM"."""
    words = text.split()
    pairs = pairwise(words)
    return any(
        re.fullmatch(NUMERAL_TEXT, one) and (unit_of(other.strip(",;")) or other in ("AM", "PM"))
        for one, other in pairs
    )


def count_named(line: str, patterns: Iterable[str]) -> int:
    """Return the number of patterns of column names that match a word of a line."""
    words = line.lstrip("#%!/ ").split()
    return sum(
        any(re.search(pattern, word, re.IGNORECASE) for word in words) for pattern in patterns
    )


def unread_unit(name: str, names: str) -> str:
    """Return the part of a name that may be an unknown or misplaced unit; "" without one.

    names : pattern of the words that name such a column; its last word may be one of them.
    """
    words = [word for word in re.split(r"[\s.-]+|_(?=\w\w|V\b)", name) if word]
    last = words[-1] if len(words) > 1 and not words[-1].isdecimal() else ""
    set_off = SET_OFF_SEPARATOR.search(name)
    tail = name[set_off.start() :] if set_off else ""
    for text in filter(None, (tail, last)):
        word = SET_OFF_SEPARATOR.sub("", text, count=1) if text is tail else text
        flags = re.IGNORECASE if len(text) > 1 else 0  # V is volt, not velocity
        if word.lower() not in NAME_WORDS and not re.search(names, text, flags):
            return word
    return next(filter(_contains_unit, words), "")


def _contains_unit(word: str) -> bool:
    """Return whether a word is a unit or contains one, such as "velocity_mm_s"."""
    title = None if word.lower().strip(",.;:()") in ENGLISH_UNIT_WORDS else title_of(word)
    return title is not None and (title.stated or len(title.unit) > 1) and bool(unit_of(title.unit))


def unread_line(above: list[str], delimiter: str | None, width: int) -> str:
    """Return a line near the rows with units or names that no title contains; "" without one.

    "Cutoff 0.8 mm" does not count, as its unit belongs to a number.
    """
    titles = titles_of(above, delimiter, width)
    known = {title.unit for title in titles} - {""}
    near = _nearest_lines(above)
    if near and not titles and not is_comment(near[0]) and _is_name_line(near[0], width):
        return near[0].strip()
    for line in reversed(above[-MAX_UNIT_LINES:]):
        line_units = {title.unit for title in titles_of([line], delimiter, width)} - {""}
        if line_units and line_units <= known:
            continue
        words, bare = _bare_words(line)
        if any(map(_contains_unit, words)) or any(map(unit_of, re.findall(r"\bin\s+(\S+)", bare))):
            return line.strip()
    for line in () if known else near[:2]:  # here 1 is a unit
        words = COMMENT_MARK.sub("", line).split(delimiter)
        several = len(words) < width and any(map(_bare_unit, words))
        if len(words) > 1 and (several if delimiter else _unit_words(words)):
            return line.strip()
    nearest = _bare_words(near[0])[0] if near else []
    units = [word for word in nearest if (unit := unit_of(word)) and unit.family != "number"]
    apart = not {title.name for title in titles} & set(nearest)
    if titles and units and apart and not known and len(nearest) <= width:  # units below names
        return near[0].strip()
    return ""


def _bare_words(line: str) -> tuple[list[str], str]:
    """Return the words of a line, and the line, without numbers and their units."""
    bare = re.sub(rf"(?<![\w^.-]){NUMERAL_TEXT}\s*[^\s,;]+", " ", line.replace('"', " "))
    return [word for word in re.split(r"[\s,;|]+", bare.lstrip("#%!/ ")) if word], bare


def _is_name_line(line: str, width: int) -> bool:
    """Return whether a line may name ``width`` columns: enough words, and not a remark."""
    words = [word for word in re.split(r"[\s,;|]+", line) if word]
    return len(words) >= width and title_of(line) is not None and not re.search(":", line)


def _nearest_lines(above: list[str]) -> list[str]:
    """Return the lines above the rows that may hold titles, the last one first."""
    return [line for line in above if re.search(r"\w", line)][: -MAX_TITLE_LINES - 1 : -1]


def titles_of(above: list[str], delimiter: str | None, width: int) -> tuple[Title, ...]:
    """Return the titles of the columns; empty if the file has none.

    above : lines before the rows; the last MAX_TITLE_LINES are searched. A line of units belongs
    to the names above it. Among several lines of names, the one with the most units is used; in a
    tie, the last one.
    """
    units: list[str] = []
    best: tuple[Title, ...] = ()
    near = _nearest_lines(above)
    if any(re.match(r"\s*%+ *[^\s;|,%]", line) for line in near):  # % begins a comment
        near = [re.sub(r"^\s*% *", "", line) for line in near]
    for place, line in enumerate(near):
        cells, labelled = _cells_of_line(line, delimiter, width)
        if not cells:
            continue
        names = _cells_of_line("".join(near[place + 1 : place + 2]), delimiter, width)[0]
        if not units and not _unit_count(best) and _all_units(cells, labelled, bool(names or best)):
            units = [_bare_unit(cell) or cell for cell in cells]
            if best:
                return _with_units(best, units)
            continue
        parsed = [title_of(cell) for cell in cells]
        if any(title is None for title in parsed) or all(map(is_numeral, filter(None, cells))):
            continue
        titles = tuple(title for title in parsed if title is not None)
        if units:
            return _with_units(titles, units)
        if _unit_count(titles) > _unit_count(best) or not best:
            best = titles
    if units:
        rest = near[1:2]
        name = UNREAD_NAME if rest and _is_name_line(rest[0], width) else ""
        return tuple(Title(name, unit, bool(unit)) for unit in units)
    return best


def _cells_of_line(line: str, delimiter: str | None, width: int) -> tuple[list[str], bool]:
    """Return the cells of a line of titles, and whether it is labelled as a line of units."""
    labelled = UNITS_LABEL.fullmatch(line)
    cells = _cells_of_title(labelled[1] if labelled else line, delimiter, width)
    if len(cells) > 2 and cells[0].endswith(":"):  # a label of the line
        cells = ["", *cells[1:]]
    return [re.sub(r'^"(.*)"$', r"\1", cell.strip()).strip() for cell in cells], bool(labelled)


def _with_units(titles: tuple[Title, ...], units: list[str]) -> tuple[Title, ...]:
    pairs = zip(titles, units, strict=True)
    return tuple(title._replace(unit=unit, stated=True) if unit else title for title, unit in pairs)


def _unit_count(titles: tuple[Title, ...]) -> int:
    return sum(bool(title.unit) for title in titles)


def _bare_unit(cell: str) -> str | None:
    text = cell.strip()
    bare = text.strip("[](){}<>").strip()
    known = bare and (unit_of(bare) or bare == "#" or is_product(bare) or BRACKETED.fullmatch(text))
    return bare if known else None


def _all_units(cells: list[str], labelled: bool, named: bool) -> bool:
    """Return whether a line holds only units, with at least one longer than a letter or bracketed.

    named : whether a line of names is above it; then up to half of its units may be unknown.
    """
    filled = [cell for cell in cells if cell.strip()]
    if filled and (labelled or all(map(BRACKETED.fullmatch, filled))):
        return True
    known = list(filter(_bare_unit, filled))
    distinctive = any(len(cell) > 1 or cell in "1-%#" for cell in known)
    if len(known) == len(filled):
        return any(len(cell) > 1 for cell in filled) or (named and distinctive)
    return named and distinctive and 2 * len(known) >= len(filled)


def _cells_of_title(line: str, delimiter: str | None, width: int) -> list[str]:
    """Return the cells of a line of titles, one for each column; empty for other lines."""
    text = line.strip("\r\n")
    if not re.match(r"%\s*[;\t|,]", text):  # % is then the unit of the first column
        text = COMMENT_MARK.sub("", text)
    quoted = re.findall(r'"([^"]*)"', text)
    if len(quoted) == width:
        return quoted
    if delimiter is None and len(wide := re.split(r"\s{2,}|\t", text.strip())) == width:
        return wide
    words = re.findall(r"[\[({<][^\])}>]*[\])}>]|\S+", text)  # [mN m] is one word
    units = _unit_words(words) if delimiter is None or delimiter not in text else []
    families = [unit and unit.family for unit in map(unit_of, units)]
    if len(units) == width and ("force", "length") not in pairwise(families):  # N m is one unit
        return units
    if delimiter is None and len(units) > 1:  # their columns are unknown
        return []
    candidates = dict.fromkeys((delimiter, "\t", *DELIMITERS))
    for candidate in candidates:
        if candidate is None:
            continue
        cells = split(text, candidate)
        while len(cells) > width and not cells[-1]:
            cells.pop()
        if delimiter is None and any(map(_begins_with_unit, cells)):  # of the previous name
            continue
        if len(cells) > width and len(pairs := _joined_units(cells)) == width:
            return pairs
        few = (
            candidate == delimiter
            and 2 * len(cells) >= width
            and _all_units(cells, labelled=False, named=False)
        )
        if 1 < len(cells) <= width and (len(cells) == width or few):
            return cells + [""] * (width - len(cells))
    if delimiter is not None and delimiter in text:
        return []
    joined = _joined_cells(text)
    return joined if len(joined) == width else _cells_by_units(text, width)


def _joined_units(cells: list[str]) -> list[str]:
    """Return cells with units in brackets after the names before them: x; mm gives x [mm]."""
    joined: list[str] = []
    for cell in cells:
        if joined and not joined[-1].endswith("]") and _bare_unit(cell):
            joined[-1] += f" [{cell}]"
        else:
            joined.append(cell)
    return joined


def _begins_with_unit(cell: str) -> bool:
    first, _, rest = cell.partition(" ")
    return bool(rest) and unit_of(first) is not None and unit_of(cell) is None


def _joined_cells(text: str) -> list[str]:
    """Return titles separated by whitespace; units in brackets or after a slash stay with names."""
    marked = re.sub(r"\s+(?=[\[({<])|\s*/\s*|(?<=\s)in\s+", lambda m: m[0].replace(" ", "\0"), text)
    marked = re.sub(r"[\[(][^\])]*[\])]", lambda m: m[0].replace(" ", "\0"), marked)
    marked = re.sub(r"\s+(?=in\0)", "\0", marked)
    return [word.replace("\0", " ").strip() for word in marked.split()]


def _cells_by_units(text: str, width: int) -> list[str]:
    """Return titles of several words, each with a unit at its end; empty for other lines."""
    bracketed = re.findall(r"[^\[\]()]*[\[(][^\])]*[\])]", text)
    if len(bracketed) == width:
        return [cell.strip() for cell in bracketed]
    words = re.sub(r"\s+([-\u2013])\s+(?=\S)", "\0\\1\0", text).split()
    cells, start = list[str](), 0
    for end in range(1, len(words) + 1):
        title = title_of(_joined_words(words[start:end]))
        if end <= start or title is None or not title.name or not title.unit:
            continue
        for stop in range(min(end + MAX_UNIT_WORDS, len(words)), end, -1):
            longer = title_of(_joined_words(words[start:stop]))
            if longer is not None and longer.unit and longer.name == title.name:
                break
        else:
            stop = end
        if words[stop - 1] == "in" and stop < len(words):  # the preposition, not the inch
            continue
        cells.append(_joined_words(words[start:stop]))
        start = stop
    cells += [_joined_words(words[start:])] * (start < len(words))  # the last may have no unit
    return cells if len(cells) == width else []


def _joined_words(words: list[str]) -> str:
    return " ".join(words).replace("\0", " ")


def _unit_words(words: list[str]) -> list[str]:
    """Return the units in a list of words; empty if it contains anything else."""
    units, start = list[str](), 0
    while start < len(words):
        ends = range(min(start + MAX_UNIT_WORDS, len(words)), start, -1)
        end = next((end for end in ends if _is_unit(words[start:end])), None)
        if end is None:
            return []
        units.append(" ".join(words[start:end]))
        start = end
    return units


def _is_unit(words: list[str]) -> bool:
    """Return whether words form one unit; a unit of several words excludes 1 and %."""
    units = [unit_of(word) for word in words]
    numbers = any(unit is not None and unit.family == "number" for unit in units)
    whole = " ".join(words)
    return bool(_bare_unit(whole)) if len(words) == 1 else not numbers and bool(unit_of(whole))
