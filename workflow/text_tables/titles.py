"""Names and units of columns from the lines above the numbers, and what else is stated there."""

import re
from itertools import pairwise
from typing import NamedTuple

from .cells import DELIMITERS, is_comment, split
from .numerals import is_numeral
from .units import unit_of

SHORTEST = 3  # letters of a last word that is taken for a unit which is not known
MOST = 200  # lines above the numbers in which units are looked for that no title has
NEAR = 4  # lines above the numbers in which names and units of columns are looked for
BRACKETS = re.compile(
    r"(.*?)\s*(?:\[([^\[\]]*)\]|\(([^()]*)\)|<([^<>]*)>|\{([^{}]*)\})([^\[\](){}<>]*)"
)
UNREAD = "?"  # the name of a column above whose unit a line stands that is not understood
BRACKETED = re.compile(r"[\[(<{].*[\])>}]")
ARGUMENTS = frozenset(
    ("t", "ω", "omega", "w", "f", "x", "y", "q", "T", "i", "a", "τ", "delta", "δ", "aT", "a_T")
)  # E(t), G'(ω)
LABELLED = re.compile(r"[#%/!\s]*units?\s*[:=]\s*(.*)", re.IGNORECASE)  # units: mm, um
REMARKED = re.compile(r"[#%/!;\s]*([^:=;\t]+?)\s*[:=]\s*(.*?)\s*[;,\t]*")  # Width: 96 µm
NUMBER = r"[-+]?\d[\d.,:]*(?:[eE][-+]?\d+)?"
QUANTITY = re.compile(rf"({NUMBER})\s*(\S.*)?")
SEPARATED = (
    r"(.*\S)\s+in\s+(\S.*)",
    r"(.*?\S)\s*/\s*(\S.*)",
    r"(.*\S)\s*[,;:|]\s*(\S+)",
    r"(.*\S)[-.](\S+)",  # of which the second is a unit only where it is known
)
# Last words of names that are no units.
SHORT = frozenset(
    (
        "abs",
        "rel",
        "set",
        "act",
        "avg",
        "raw",
        "cmd",
        "ref",
        "log",
        "lin",
        "tot",
        "pos",
        "vel",
        "lp",
    )
)
# Units that are words of sentences, too.
ENGLISH = frozenset(("in", "day", "days", "turn", "turns", "foot", "feet", "none", "at"))


class Title(NamedTuple):
    """Name and unit of a column as the file has them."""

    name: str = ""
    unit: str = ""  # as it is written; "" where none is
    stated: bool = False  # whether set off as a unit is, and not only the last word of the name


def title_of(cell: str) -> Title | None:
    """Return name and unit of a title; None of what is none, as "cut-off 0.8 mm" or "T = 25"."""
    text = cell.strip()
    if "=" in text or text.endswith(":") or _holds_quantity(text) or is_numeral(text):
        return None
    bracket = BRACKETS.fullmatch(text)
    if bracket:
        inside = next(part for part in bracket.groups()[1:5] if part is not None).strip()
        name = f"{bracket[1]} {bracket[6]}".strip()
        if inside in ARGUMENTS and not unit_of(inside) and bracket[1]:
            behind = title_of(f"{bracket[1]}{bracket[6]}")
            return behind._replace(name=text) if behind and behind.unit else Title(text)
        return Title(name, inside, stated=True) if inside else Title(name)
    for pattern in SEPARATED:
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
        re.fullmatch(NUMBER, one) and (unit_of(other.strip(",;")) or other in ("AM", "PM"))
        for one, other in pairs
    )


def unread_unit(name: str) -> str:
    """Return what in a name may be a unit that is not known, or is in no place for one; else ""."""
    for pattern in SEPARATED[:-1]:
        parts = re.fullmatch(pattern, name)
        if parts:
            return parts[2]
    words = [word for word in re.split(r"[\s.-]+", name) if word]
    if (
        len(words) > 1
        and len(words[-1]) <= SHORTEST
        and words[-1].lower() not in SHORT
        and not words[-1].isdecimal()
    ):
        return words[-1]
    return next(filter(_names_unit, words), "")


def _names_unit(word: str) -> bool:
    """Return whether a word is a unit, or holds one as "velocity_mm_s" does."""
    title = None if word.lower().strip(",.;:()") in ENGLISH else title_of(word)
    return title is not None and (title.stated or len(title.unit) > 1) and bool(unit_of(title.unit))


def unread_line(above: list[str], delimiter: str | None, width: int) -> str:
    """Return a line near the rows that says what no title has: units, or as many names; else "".

    "Cutoff 0.8 mm" names none: its unit is that of the number before it.
    """
    titles = titles_of(above, delimiter, width)
    known = {title.unit for title in titles} - {""}
    near = _near(above)
    if near and not titles and not is_comment(near[0]) and _is_names(near[0], width):
        return near[0].strip()
    for line in reversed(above[-MOST:]):
        own = {title.unit for title in titles_of([line], delimiter, width)} - {""}
        if own and own <= known:
            continue
        bare = re.sub(rf"(?<![^\W\d]){NUMBER}\s*[^\s,;]+", " ", line.replace('"', " "))
        words = [word for word in re.split(r"[\s,;|]+", bare) if word]
        if any(map(_names_unit, words)) or any(map(unit_of, re.findall(r"\bin\s+(\S+)", bare))):
            return line.strip()
    return ""


def _is_names(line: str, width: int) -> bool:
    """Return whether a line may name as many columns: of words, and no remark."""
    words = [word for word in re.split(r"[\s,;|]+", line) if word]
    return len(words) >= width and title_of(line) is not None and not re.search(":", line)


def _near(above: list[str]) -> list[str]:
    """Return the lines above the rows in which names and units are looked for, the last first."""
    return [line for line in above if re.search(r"\w", line)][: -NEAR - 1 : -1]


def titles_of(above: list[str], delimiter: str | None, width: int) -> tuple[Title, ...]:
    """Return the titles of columns, empty where the file names none.

    above : the lines before the rows, of which the last NEAR count. A line of units goes with the
    names above it; of several lines with names the one with most units counts, then the last.
    """
    units: list[str] = []
    best: tuple[Title, ...] = ()
    for line in _near(above):
        labelled = LABELLED.fullmatch(line)
        cells = _cells_of_title(labelled[1] if labelled else line, delimiter, width)
        cells = [cell.strip().strip('"').strip() for cell in cells]
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
        rest = _near(above)[1:2]
        name = UNREAD if rest and _is_names(rest[0], width) else ""
        return tuple(Title(name, unit, bool(unit)) for unit in units)
    return best


def _stated(titles: tuple[Title, ...]) -> int:
    return sum(bool(title.unit) for title in titles)


def _bare_unit(cell: str) -> str | None:
    text = cell.strip()
    bare = text.strip("[](){}<>").strip()
    known = bare and (unit_of(bare) or bare == "#" or BRACKETED.fullmatch(text))
    return bare if known else None


def _all_units(cells: list[str], labelled: bool) -> bool:
    """Return whether a line holds units alone, one of which is more than a letter or bracketed."""
    filled = [cell for cell in cells if cell.strip()]
    if filled and all(map(BRACKETED.fullmatch, filled)):
        return True
    plain = all(map(_bare_unit, filled))
    return bool(filled) and plain and (labelled or any(len(cell) > 1 for cell in filled))


def _cells_of_title(line: str, delimiter: str | None, width: int) -> list[str]:
    """Return the cells of a line of titles, as many as there are columns; none where it is none."""
    text = line.strip("\r\n")
    if not re.match(r"%\s*[;\t|,]", text):  # which is the unit of the first column
        text = text.lstrip("#%!").removeprefix("//")
    quoted = re.findall(r'"([^"]*)"', text)
    if len(quoted) == width:
        return quoted
    order = dict.fromkeys((delimiter, "\t", *DELIMITERS))
    for each in order:
        if each is None:
            continue
        cells = split(text, each)
        while len(cells) > width and not cells[-1]:
            cells.pop()
        few = each == delimiter and 2 * len(cells) >= width and _all_units(cells, labelled=False)
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
