"""Tables of numbers in text files, and their columns by what the file says of them.

Use it as follows; ``key`` stands before every refusal, and options are named where they go on::

    table = read_text_table("prony", path)
    wanted = (
        ColumnSpec("a frequency", "frequency", r"freq|omega|ω|^f$|^w$", "rad/s", "--frequency"),
        ColumnSpec("a storage modulus G'", "pressure", r"stor|^[GE]'$", "Pa", "--modulus"),
    )
    omega, storage = select_columns(table, wanted, columns=None, option="--columns")
    phase = find_column(table, ColumnSpec("tan delta", "number", r"tan", "1"))  # or None
    omega.values            # rad/s, NaN where a value is missing
    storage.title.name      # "E'" where that is what the file says
    describe_columns(table, (omega, storage))   # one line: what was read

Columns are found by the numbers that the user gives, else by their names, else by their units,
else by their order where the file names none. A unit that the file states is obeyed, or refused by
its name; the default is taken where the file states none, and ``told`` says so.
"""

import re
from collections.abc import Sequence
from functools import cached_property
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

import numpy as np

from ..ground import UserError, counted, read_plain
from .cells import Cells, UnevenRowError, cells_of, is_comment
from .codes import missing_code
from .numerals import Marks, archive_kind, decoded, is_missing, is_numeral, is_text, marks_of
from .remarks import remarks_of
from .titles import NEAR, UNREAD, Title, count_named, titles_of, unread_line, unread_unit
from .units import Unit, unit_of


class ColumnSpec(NamedTuple):
    """What a column is to hold, and how it is known."""

    meaning: str  # in words, for messages: "a storage modulus G'"
    family: str  # of its unit, one of FAMILIES; "number" takes what has none, and %
    names: str  # a pattern that its name holds, in whatever case
    default: str  # the unit where the file states none
    option: str = ""  # by which the user gives the unit
    unit: str | None = None  # as the user gives it; goes before that of the file


class Column(NamedTuple):
    """A column as it was read."""

    number: int  # from 0
    title: Title
    values: np.ndarray  # in SI units (rad/s, K), shape (rows,); NaN where one is missing
    unit: Unit
    unit_source: str  # "given", "of the file" or "assumed"
    spec: ColumnSpec
    code: float | None = None  # that stands for a missing value


SHOWN = 12  # columns in a message
LOGARITHM = r"^(log|lg|ln)([\W_\d]|$)"  # names of columns that hold logarithms
STRESS = r"^(?!.*modul).*(stress|spannung)"  # a name of what is no modulus, in its unit
ANGULAR = r"omega|\u03c9|^w$|angular|circular|kreis"  # names of frequencies whose 1/s are rad/s
LEAST_BLOCK = 3  # rows, where empty lines or comments alone part blocks


def _is_words(line: str) -> bool:
    return bool(re.search(r"\w", line)) and not is_comment(line)


class TextTable:
    """The rows of a text file, their titles, and what stands beside them."""

    def __init__(self, key: str, name: str, cells: Cells) -> None:
        """Keep the rows; ``key`` and ``name`` of the file are for messages."""
        self.key, self.name = key, name
        self.rows = cells.rows  # as they are written: lists of as many words each
        self.lines = cells.lines  # the number of the line of each row, from 1
        self.numeric = tuple(cells.numeric)  # the numbers of the columns that hold numbers
        self.delimiter = cells.delimiter
        self.above = tuple(cells.above)  # the lines before the first row
        self.between = cells.between  # (index of the row below, lines) between blocks
        self.titles = titles_of(cells.above, cells.delimiter, self.width)  # empty: none are named
        self.unread = unread_line(cells.above, cells.delimiter, self.width)
        self.remarks = remarks_of(cells.above, cells.delimiter, self.width)  # name: value
        self._check_blocks()
        self.plain = cells.plain
        self.marks = Marks() if cells.plain else self._marks()

    @property
    def width(self) -> int:
        """Return the number of columns, those of words included."""
        return len(self.rows[0]) if self.rows else 0

    @cached_property
    def blocks(self) -> tuple[slice, ...]:
        """Return the rows of each block: stretches that words or empty lines part."""
        inner = [(at, lines) for at, lines in self.between if 0 < at < len(self.rows)]
        words = [at for at, lines in inner if any(map(_is_words, lines))]
        blank = [at for at, _ in inner]
        many = len(blank) * LEAST_BLOCK > len(self.rows)  # as where every other line is empty
        starts = [0, *(words if many else blank), len(self.rows)]
        return tuple(slice(a, b) for a, b in pairwise(starts) if b > a)

    def block_header(self, block: int) -> tuple[str, ...]:
        """Return the lines before a block; those of the first are ``above``."""
        start = self.blocks[block].start
        return self.above if not start else tuple(dict(self.between).get(start, ()))

    def _check_blocks(self) -> None:
        """Raise UserError where titles below the first row state other units or another order."""
        for at, lines in self.between[:-1]:
            titles = titles_of(lines, self.delimiter, self.width)
            names = [[title.name for title in each] for each in (titles, self.titles)]
            units = [[unit_of(title.unit) for title in each] for each in (titles, self.titles)]
            pairs = zip(*units, strict=False)
            other = any(one and two and one[1:] != two[1:] for one, two in pairs)
            if other or (names[0] != names[1] and sorted(names[0]) == sorted(names[1])):
                raise UserError(
                    f"{self.key} = {self.name!r}: the titles above line {self.lines[at]} name "
                    "other units or another order of columns than those above the first row: part "
                    "the file there"
                )

    @property
    def passed_over(self) -> tuple[str, ...]:
        """Return the lines of words below the first row."""
        return tuple(line.strip() for _, lines in self.between for line in lines if _is_words(line))

    def title(self, column: int) -> Title:
        """Return the title of a column, an empty one where the file names none."""
        return self.titles[column] if self.titles else Title()

    def words(self, column: int) -> tuple[str, ...]:
        """Return a column as it is written."""
        return tuple(row[column] for row in self.rows)

    def values(self, column: int) -> np.ndarray:
        """Return a column, shape (rows,), as written and without units; NaN where one is missing.

        Raises UserError, naming the line, for a word that is no number.
        """
        words = self.words(column)
        if self.plain:
            return np.array(list(map(float, words)))
        try:
            number = self.marks.number
            return np.array([np.nan if is_missing(word) else number(word) for word in words])
        except ValueError:
            bad = next(n for n, w in enumerate(words) if not (is_numeral(w) or is_missing(w)))
            raise UserError(
                f"{self.key}: line {self.lines[bad]} of {self.name!r} reads "
                f"{' '.join(self.rows[bad])!r:.40}: must hold a number in column {column}"
            ) from None

    def _marks(self) -> Marks:
        own = (row[n] for row in self.rows for n in self.numeric)
        try:
            return marks_of(word for word in own if is_numeral(word))
        except ValueError as error:
            raise UserError(f"{self.key}: {self.name!r}: {error}") from None

    @property
    def columns_text(self) -> str:
        """Return the columns in words, with their numbers."""
        if not self.titles:
            return f"{self.width} columns without names"
        named = [
            f"{n} {title.name or '(no name)'}{f' [{title.unit}]' if title.unit else ''}"
            for n, title in enumerate(self.titles[:SHOWN])
        ]
        return f"the columns {', '.join([*named, '...'] if self.width > SHOWN else named)}"


def read_text_table(key: str, path: Path, name: str | None = None) -> TextTable:
    """Return the table of a text file; ``name`` is what messages call it, the path by default.

    Raises UserError, which begins with ``key``, for a file that cannot be read, is an archive or
    no text, holds no row of numbers, rows of several lengths, or numbers that can be read in two
    ways.
    """
    name = str(path) if name is None else name
    try:
        data = read_plain(path)
    except (OSError, ValueError) as error:  # ValueError: no name of a file
        reason = getattr(error, "strerror", None) or error
        raise UserError(f"{key} = {name!r}: cannot be read: {reason}") from None
    if kind := archive_kind(data):
        raise UserError(f"{key} = {name!r}: is {kind}: unpack it and name one file")
    if not is_text(data):
        raise UserError(f"{key} = {name!r}: cannot be read: it is no text")
    return table_of_text(key, name, decoded(data))


def table_of_text(key: str, name: str, text: str) -> TextTable:
    """Return the table of a text. Raises UserError as ``read_text_table``."""
    try:
        cells = cells_of(text)
    except UnevenRowError as error:
        line, number, width = error.args
        raise UserError(
            f"{key}: line {number} of {name!r} reads {line!r:.40}: must hold {width} "
            f"{'entry' if width == 1 else 'entries'} as the rows before it"
        ) from None
    if not cells.rows:
        raise UserError(f"{key} = {name!r}: holds no row of numbers")
    return TextTable(key, name, cells)


def select_columns(
    table: TextTable,
    wanted: Sequence[ColumnSpec],
    columns: Sequence[int] | None = None,
    option: str = "--columns",
) -> tuple[Column, ...]:
    """Return the columns that are wanted, in that order.

    columns : their numbers, from 0, as the user gives them, one for each. option : by which they
    are given. Raises UserError where the file does not say which they are, where a name fits
    several, for a unit that is not known and for one of another family.
    """
    places = _places(table, wanted, option) if columns is None else list(columns)
    for column in places:
        if column >= table.width:
            raise UserError(
                f"{table.key}: {option} asks for column {column} of {table.name!r}: it holds "
                f"{table.columns_text}, from 0"
            )
    pairs = zip(wanted, places, strict=True)
    return tuple(_read(table, one, place, option) for one, place in pairs)


def find_column(table: TextTable, one: ColumnSpec, option: str = "--columns") -> Column | None:
    """Return the column of a name, None without one. Raises UserError as ``select_columns``."""
    own = [column for column in table.numeric if _named(table.title(column), one)]
    if len(own) > 1:
        raise _unclear(table, (one,), option)
    return _read(table, one, own[0], option) if own else None


def _places(table: TextTable, wanted: Sequence[ColumnSpec], option: str) -> list[int]:
    """Return the number of the column of each: by names, by units, else by the order."""
    free, places = list(table.numeric), dict[int, int]()
    for index, one in enumerate(wanted):
        own = [column for column in free if _named(table.title(column), one)]
        # A name without a unit is not surer than the unit of a column that nothing names.
        rivals = (
            [] if any(table.title(column).unit for column in own) else _rivals(table, wanted, one)
        )
        if len(own) > 1 or (own and rivals):
            raise _unclear(table, wanted, option)
        places.update((index, column) for column in own)
    free = [column for column in free if column not in places.values()]
    for index, one in enumerate(wanted):
        own = [column for column in free if _by_unit(table.title(column), one)]
        single = sum(other.family == one.family for other in wanted) == 1
        if index not in places and single and len(own) == 1:
            places[index] = own[0]
            free.remove(own[0])
    missing = [index for index in range(len(wanted)) if index not in places]
    unknown = any(table.title(n).name and not table.title(n).stated for n in free)
    named = len(missing) > 1 and (bool(table.unread) or any(table.title(n).name for n in free))
    named = named or (bool(missing) and any(title.name == UNREAD for title in table.titles))
    named = named or (not table.titles and _names_several(table, wanted))
    twice = len(set(places.values())) < len(places)
    if twice or named or (missing and (len(missing) != len(free) or (unknown and places))):
        raise _unclear(table, wanted, option)
    places |= dict(zip(missing, free, strict=False))
    return [places[index] for index in range(len(wanted))]


def _rivals(table: TextTable, wanted: Sequence[ColumnSpec], one: ColumnSpec) -> list[int]:
    """Return the columns that by their unit may be what is wanted, and by their name nothing is."""
    titles = {column: table.title(column) for column in table.numeric}
    return [
        column
        for column, title in titles.items()
        if title.name and _by_unit(title, one) and not any(_named(title, own) for own in wanted)
    ]


def _names_several(table: TextTable, wanted: Sequence[ColumnSpec]) -> bool:
    """Return whether a line above the rows names several columns, though not which."""
    patterns = [one.names for one in wanted]
    return any(count_named(line, patterns) > 1 for line in table.above[-NEAR:])


def _named(title: Title, one: ColumnSpec) -> bool:
    unit = unit_of(title.unit)
    loose = not title.stated and unit is not None and unit.family != "temperature"
    fitting = unit is None or loose or _same_family(unit, one)
    return bool(title.name) and fitting and bool(re.search(one.names, title.name, re.IGNORECASE))


def _of_family(title: Title, one: ColumnSpec) -> bool:
    unit = unit_of(title.unit)
    return unit is not None and _same_family(unit, one)


def _by_unit(title: Title, one: ColumnSpec) -> bool:
    """Return whether a unit says what a column is; 1 or % of a column with a name says nothing."""
    unit = unit_of(title.unit)
    number = unit is not None and unit.family == "number"
    return _of_family(title, one) and not (number and title.name not in ("", UNREAD))


def _same_family(unit: Unit, one: ColumnSpec) -> bool:
    return unit.family == one.family or (unit.family, one.family) == ("rate", "frequency")


def _unclear(table: TextTable, wanted: Sequence[ColumnSpec], option: str) -> UserError:
    names = " and ".join(one.meaning for one in wanted)
    return UserError(
        f"{table.key} = {table.name!r}: holds {table.columns_text}, from 0: it is not clear which "
        f"holds {names}; give {option}"
    )


def _read(table: TextTable, one: ColumnSpec, column: int, option: str) -> Column:
    title = table.title(column)
    where = f"{table.key} = {table.name!r}: column {column}{f' {title.name!r}' * bool(title.name)}"
    way = f"; give {one.option}" if one.option else f"; give {option}"
    if re.match(LOGARITHM, title.name, re.IGNORECASE) and not re.search(one.names, "log"):
        raise UserError(
            f"{where}: holds logarithms, not {one.meaning}: write the numbers themselves"
        )
    if one.family == "pressure" and re.search(STRESS, title.name, re.IGNORECASE):
        raise UserError(f"{where}: holds a stress, not {one.meaning}: divide it by the strain")
    if one.unit is not None:
        unit, whose = unit_of(one.unit), "given"
        if unit is None or not _same_family(unit, one):
            raise UserError(f"{table.key}: {one.option} {one.unit}: is no unit of {one.meaning}")
    elif title.unit and (title.stated or _of_family(title, one)):
        unit, whose = unit_of(title.unit), "of the file"
        if unit is None:
            raise UserError(f"{where}: the unit {title.unit!r} of {one.meaning} is not known{way}")
        if not _same_family(unit, one):
            raise UserError(
                f"{where}: is in {title.unit!r}, which is no unit of {one.meaning}; give {option}"
            )
    else:
        inside = [word for word in title.name.split()[:-1] if _of_family(Title(unit=word), one)]
        other = unit_of(title.unit)  # not set off, and of another family
        foreign = title.unit if other and other.family != "number" else ""
        unread = table.unread if one.family != "number" else ""
        doubt = "".join(inside[:1]) or foreign or unread_unit(title.name, one.names) or unread
        if doubt:
            raise UserError(f"{where}: it is not clear what {doubt!r:.60} says of its unit{way}")
        unit, whose = unit_of(one.default), "assumed"
        assert unit is not None
    if unit.family == "rate" != one.family and not re.search(ANGULAR, title.name, re.IGNORECASE):
        raise UserError(f"{where}: {unit.text!r} may be Hz or rad/s{way}")
    values = table.values(column)
    code = missing_code(values, repeated=False)
    if code is not None:
        values = np.where(values == code.value, np.nan, values)
    return Column(column, title, unit.si(values), unit, whose, one, code and code.value)


def describe_columns(table: TextTable, columns: Sequence[Column]) -> str:
    """Return in one line which columns were read as what, in which units, and whose they are."""
    parts = []
    for one in columns:
        name = f" {one.title.name}" if one.title.name else ""
        unit = f" in {one.unit.text}" if one.unit.family != "number" else ""
        whose = "" if one.unit_source == "of the file" or not unit else f" ({one.unit_source})"
        parts.append(f"column {one.number}{name} as {one.spec.meaning}{unit}{whose}")
    missing = sum(int(np.isnan(one.values).sum()) for one in columns)
    text = f"{table.name}: {len(table.rows)} rows; {', '.join(parts)}"
    if len(table.blocks) > 1:
        text += f"; {len(table.blocks)} blocks"
    if missing:
        codes = ", ".join(f"{one.code:g}" for one in columns if one.code is not None)
        text += f"; {counted(missing, 'value')} missing{f' ({codes})' if codes else ''}"
    if table.passed_over:
        text += f"; passed over {counted(len(table.passed_over), 'line')} of words"
    return text
