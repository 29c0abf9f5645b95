"""Names and units of columns from the lines above the numbers."""

import re
from collections.abc import Iterable
from itertools import pairwise
from typing import NamedTuple

from .cells import DELIMITERS, is_comment, split
from .numerals import is_numeral
from .units import is_product, unit_of

MOST = 200  # lines above the numbers in which units are looked for that no title has
NEAR = 4  # lines above the numbers in which names and units of columns are looked for
BRACKETS = re.compile(
    r"(.*?)\s*(?:\[([^\[\]]*)\]|\(([^()]*)\)|<([^<>]*)>|\{([^{}]*)\})([^\[\](){}<>]*)"
)
LONGEST = 3  # words of a unit, as mm per s
UNREAD = "?"  # the name of a column above whose unit a line stands that is not understood
BRACKETED = re.compile(r"[\[(<{].*[\])>}]")
ARGUMENTS = frozenset(
    ("t", "ω", "omega", "w", "f", "x", "y", "q", "T", "i", "a", "τ", "delta", "δ", "aT", "a_T")
)  # E(t), G'(ω)
COMMENT = re.compile(r"^\s*(?:#+|%(?=%\s*[;\t|,])|%+|!+|//)")
LABELLED = re.compile(r"[#%/!\s]*units?\s*[:=]\s*(.*)", re.IGNORECASE)  # units: mm, um
NUMBER = r"[-+]?\d[\d.,:]*(?:[eE][-+]?\d+)?"
# What may stand between a name and its unit; where it is a blank or _, the unit is not set off.
SEPARATOR = re.compile(r"\s+in\s+|\s+[-\u2013]\s+|\s*[/,;:|]\s*|(?<=\S)[-.]\s*|[\s_]+")
SET_OFF = re.compile(r"\s+in\s+|\s+[-\u2013]\s+|\s*[/,;:|]\s*")  # behind which no name goes on
# Last words of names, which are no units.
NAMING = (
    "abs absolute act actual amplitude angular average avg axis channel cmd coef coeff "
    "coefficient command commanded corrected d data delta displacement drive elapsed factor "
    "filt filtered force frequency friction horizontal index lateral length lin load log lp "
    "mean measured moduli modulus motor nominal normal number of oscillation point pos "
    "position prime ratio raw ref rel relative sensor set setpoint shear signal slider "
    "speed stage step storage strain stress target test time tot total value values vel "
    "velocity vertical x y z \u03b4"
)
OF_NAMES = frozenset(NAMING.split())
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
    if len(text) > 1 and unit_of(text):
        return Title("", text, stated=True)
    return _parted(text)


def _parted(text: str) -> Title:
    """Return a title parted before its longest unit: v in mm/s, Lateral. um, velocity_mm_per_s."""
    for match in SEPARATOR.finditer(text):
        name, unit, between = text[: match.start()], text[match.end() :], match[0].strip()
        unit = re.sub("_per_|_", "/", unit) if between == "_" else unit
        counted = match[0] in ("-", ".") and unit == "1"  # Height-1 is a name
        if name and unit_of(unit) and not counted and not re.match(r"/|in\s", unit):
            return Title(name, unit, stated=between not in ("", "_"))
        if name and re.match("[a-zµ]?[A-Z]", unit) and is_product(unit):  # of torque, as mN m
            return Title(name, unit, stated=True)
    return Title(text)


def _holds_quantity(text: str) -> bool:
    """Return whether a number stands before a unit in a text, as in "stylus 2 µm" or "02:10 PM"."""
    words = text.split()
    pairs = pairwise(words)
    return any(
        re.fullmatch(NUMBER, one) and (unit_of(other.strip(",;")) or other in ("AM", "PM"))
        for one, other in pairs
    )


def count_named(line: str, patterns: Iterable[str]) -> int:
    """Return how many of some patterns of names of columns the words of a line hold."""
    words = line.lstrip("#%!/ ").split()
    return sum(any(re.search(one, word, re.IGNORECASE) for word in words) for one in patterns)


def unread_unit(name: str, names: str) -> str:
    """Return what in a name may be a unit that is not known, or is in no place for one; else "".

    names : a pattern of the words that name such a column, of which its last word may be one.
    """
    words = [word for word in re.split(r"[\s.-]+|_(?=\w\w|V\b)", name) if word]
    last = words[-1] if len(words) > 1 and not words[-1].isdecimal() else ""
    set_off = SET_OFF.search(name)
    tail = name[set_off.start() :] if set_off else ""
    for text in filter(None, (tail, last)):
        word = SET_OFF.sub("", text, count=1) if text is tail else text
        any_case = re.IGNORECASE if len(text) > 1 else 0  # V is no velocity, but volts
        if word.lower() not in OF_NAMES and not re.search(names, text, any_case):
            return word
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
        words, bare = _bare_words(line)
        if any(map(_names_unit, words)) or any(map(unit_of, re.findall(r"\bin\s+(\S+)", bare))):
            return line.strip()
    for line in () if known else near[:2]:  # in which 1 is a unit, and no number before one
        words = COMMENT.sub("", line).split(delimiter)
        several = len(words) < width and any(map(_bare_unit, words))
        if len(words) > 1 and (several if delimiter else _units_alone(words)):
            return line.strip()
    nearest = _bare_words(near[0])[0] if near else []
    units = [word for word in nearest if (unit := unit_of(word)) and unit.family != "number"]
    apart = not {title.name for title in titles} & set(nearest)
    if titles and units and apart and not known and len(nearest) <= width:  # below the names
        return near[0].strip()
    return ""


def _bare_words(line: str) -> tuple[list[str], str]:
    """Return the words of a line, but for numbers and what stands behind one, as its unit does."""
    bare = re.sub(rf"(?<![\w^.-]){NUMBER}\s*[^\s,;]+", " ", line.replace('"', " "))
    return [word for word in re.split(r"[\s,;|]+", bare.lstrip("#%!/ ")) if word], bare


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
    near = _near(above)
    if any(re.match(r"\s*%+ *[^\s;|,%]", line) for line in near):  # % begins a comment
        near = [re.sub(r"^\s*% *", "", line) for line in near]
    for place, line in enumerate(near):
        cells, labelled = _cells_of_line(line, delimiter, width)
        if not cells:
            continue
        names = _cells_of_line("".join(near[place + 1 : place + 2]), delimiter, width)[0]
        if not units and not _stated(best) and _all_units(cells, labelled, bool(names or best)):
            units = [_bare_unit(cell) or cell for cell in cells]
            if best:
                return _with_units(best, units)
            continue
        found = [title_of(cell) for cell in cells]
        if any(title is None for title in found) or all(map(is_numeral, filter(None, cells))):
            continue
        titles = tuple(title for title in found if title is not None)
        if units:
            return _with_units(titles, units)
        if _stated(titles) > _stated(best) or not best:
            best = titles
    if units:
        rest = near[1:2]
        name = UNREAD if rest and _is_names(rest[0], width) else ""
        return tuple(Title(name, unit, bool(unit)) for unit in units)
    return best


def _cells_of_line(line: str, delimiter: str | None, width: int) -> tuple[list[str], bool]:
    """Return the cells of a line of titles, and whether it says that they are units."""
    labelled = LABELLED.fullmatch(line)
    cells = _cells_of_title(labelled[1] if labelled else line, delimiter, width)
    if len(cells) > 2 and cells[0].endswith(":"):  # which names the line
        cells = ["", *cells[1:]]
    return [re.sub(r'^"(.*)"$', r"\1", cell.strip()).strip() for cell in cells], bool(labelled)


def _with_units(titles: tuple[Title, ...], units: list[str]) -> tuple[Title, ...]:
    pairs = zip(titles, units, strict=True)
    return tuple(own._replace(unit=unit, stated=True) if unit else own for own, unit in pairs)


def _stated(titles: tuple[Title, ...]) -> int:
    return sum(bool(title.unit) for title in titles)


def _bare_unit(cell: str) -> str | None:
    text = cell.strip()
    bare = text.strip("[](){}<>").strip()
    known = bare and (unit_of(bare) or bare == "#" or is_product(bare) or BRACKETED.fullmatch(text))
    return bare if known else None


def _all_units(cells: list[str], labelled: bool, named: bool) -> bool:
    """Return whether a line holds units alone, one of which is more than a letter or bracketed.

    named : whether names stand above it; half of its cells may then be no unit that is known.
    """
    filled = [cell for cell in cells if cell.strip()]
    if filled and (labelled or all(map(BRACKETED.fullmatch, filled))):
        return True
    known = list(filter(_bare_unit, filled))
    sure = any(len(cell) > 1 or cell in "1-%#" for cell in known)
    if len(known) == len(filled):
        return any(len(cell) > 1 for cell in filled) or (named and sure)
    return named and sure and 2 * len(known) >= len(filled)


def _cells_of_title(line: str, delimiter: str | None, width: int) -> list[str]:
    """Return the cells of a line of titles, as many as there are columns; none where it is none."""
    text = line.strip("\r\n")
    if not re.match(r"%\s*[;\t|,]", text):  # which is the unit of the first column
        text = COMMENT.sub("", text)
    quoted = re.findall(r'"([^"]*)"', text)
    if len(quoted) == width:
        return quoted
    if delimiter is None and len(wide := re.split(r"\s{2,}|\t", text.strip())) == width:
        return wide
    words = re.findall(r"[\[({<][^\])}>]*[\])}>]|\S+", text)  # [mN m] is one
    units = _units_alone(words) if delimiter is None or delimiter not in text else []
    families = [unit and unit.family for unit in map(unit_of, units)]
    if len(units) == width and ("force", "length") not in pairwise(families):  # a torque is one
        return units
    if delimiter is None and len(units) > 1:  # of which columns, it does not say
        return []
    order = dict.fromkeys((delimiter, "\t", *DELIMITERS))
    for each in order:
        if each is None:
            continue
        cells = split(text, each)
        while len(cells) > width and not cells[-1]:
            cells.pop()
        if delimiter is None and any(map(_begins_with_unit, cells)):  # of the name before it
            continue
        if len(cells) > width and len(pairs := _with_own_units(cells)) == width:
            return pairs
        few = (
            each == delimiter
            and 2 * len(cells) >= width
            and _all_units(cells, labelled=False, named=False)
        )
        if 1 < len(cells) <= width and (len(cells) == width or few):
            return cells + [""] * (width - len(cells))
    if delimiter is not None and delimiter in text:
        return []
    joined = _joined(text)
    return joined if len(joined) == width else _by_units(text, width)


def _with_own_units(cells: list[str]) -> list[str]:
    """Return cells, those that are units in brackets behind the names before them: x; mm; mu."""
    found: list[str] = []
    for cell in cells:
        if found and not found[-1].endswith("]") and _bare_unit(cell):
            found[-1] += f" [{cell}]"
        else:
            found.append(cell)
    return found


def _begins_with_unit(cell: str) -> bool:
    first, _, rest = cell.partition(" ")
    return bool(rest) and unit_of(first) is not None and unit_of(cell) is None


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
    words = re.sub(r"\s+([-\u2013])\s+(?=\S)", "\0\\1\0", text).split()
    found, start = list[str](), 0
    for end in range(1, len(words) + 1):
        own = title_of(_together(words[start:end]))
        if end <= start or own is None or not own.name or not own.unit:
            continue
        for stop in range(min(end + LONGEST, len(words)), end, -1):
            longer = title_of(_together(words[start:stop]))
            if longer is not None and longer.unit and longer.name == own.name:
                break
        else:
            stop = end
        if words[stop - 1] == "in" and stop < len(words):  # the word and not the inch
            continue
        found.append(_together(words[start:stop]))
        start = stop
    found += [_together(words[start:])] * (start < len(words))  # the last may have no unit
    return found if len(found) == width else []


def _together(words: list[str]) -> str:
    return " ".join(words).replace("\0", " ")


def _units_alone(words: list[str]) -> list[str]:
    """Return the units that words are, of one word or several; none where one is none."""
    found, start = list[str](), 0
    while start < len(words):
        ends = range(min(start + LONGEST, len(words)), start, -1)
        end = next((end for end in ends if _is_unit(words[start:end])), None)
        if end is None:
            return []
        found.append(" ".join(words[start:end]))
        start = end
    return found


def _is_unit(words: list[str]) -> bool:
    """Return whether words are one unit; of several none is a number, as 1 or %."""
    units = [unit_of(word) for word in words]
    numbers = any(unit is not None and unit.family == "number" for unit in units)
    whole = " ".join(words)
    return bool(_bare_unit(whole)) if len(words) == 1 else not numbers and bool(unit_of(whole))
