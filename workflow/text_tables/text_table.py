"""Tables of numbers in text files, and the selection of their columns by name, unit and order.

Example. ``key`` opens every error message, and messages name the options that resolve them::

    table = read_text_table("prony", path)
    wanted = (
        ColumnSpec("a frequency", "frequency", r"freq|omega|ω|^f$|^w$", "rad/s", "--frequency"),
        ColumnSpec("a storage modulus G'", "pressure", r"stor|^[GE]'$", "Pa", "--modulus"),
    )
    omega, storage = select_columns(table, wanted, columns=None, option="--columns")
    phase = find_column(table, ColumnSpec("tan delta", "number", r"tan", "1"))  # or None
    omega.values            # rad/s, NaN where a value is missing
    storage.title.name      # "E'" if the file names the column so
    describe_columns(table, (omega, storage))   # one line: the columns and units

Columns are selected by the numbers that the user gives, else by their names, else by their units,
else by their order if the file does not name them. A unit stated by the file is applied, or
refused if it is not known. If the file states no unit, the default applies, and the description
says so.
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
from .titles import (
    MAX_TITLE_LINES,
    UNREAD_NAME,
    Title,
    count_named,
    titles_of,
    unread_line,
    unread_unit,
)
from .units import Unit, unit_of


class ColumnSpec(NamedTuple):
    """Requested quantity of a column, with the names and units that identify it."""

    meaning: str  # quantity in words, for messages: "a storage modulus G'"
    family: str  # of its unit, one of FAMILIES; "number" for no unit and %
    names: str  # pattern to search for in column names, ignoring case
    default: str  # unit if the file states none
    option: str = ""  # command-line option for the unit
    unit: str | None = None  # given by the user; replaces that of the file


class Column(NamedTuple):
    """Values of a selected column, with its title and unit."""

    number: int  # from 0
    title: Title
    values: np.ndarray  # in SI units (rad/s, K), shape (rows,); NaN if missing
    unit: Unit
    unit_source: str  # "given", "of the file" or "assumed"
    spec: ColumnSpec
    code: float | None = None  # missing-value code of the column


MAX_LISTED = 12  # columns in one message
LOGARITHM_NAME = r"^(log|lg|ln)([\W_\d]|$)"  # name of a column of logarithms
STRESS_NAME = r"^(?!.*modul).*(stress|spannung)"  # stress: same unit as a modulus
ANGULAR_NAME = r"omega|\u03c9|^w$|angular|circular|kreis"  # of a frequency in rad/s if in 1/s
MIN_BLOCK_ROWS = 3  # mean size, if empty lines or comments separate blocks


def _is_words(line: str) -> bool:
    return bool(re.search(r"\w", line)) and not is_comment(line)


class TextTable:
    """Rows of a text file, with titles, remarks and the lines between blocks."""

    def __init__(self, key: str, name: str, cells: Cells) -> None:
        """Store the rows. ``key`` and the ``name`` of the file appear in messages."""
        self.key, self.name = key, name
        self.rows = cells.rows  # of words as written, all of equal length
        self.lines = cells.lines  # line number of each row, from 1
        self.numeric = tuple(cells.numeric)  # indices of the columns of numbers
        self.delimiter = cells.delimiter
        self.above = tuple(cells.above)  # lines before the first row
        self.between = cells.between  # (index of the next row, lines) between blocks
        self.titles = titles_of(cells.above, cells.delimiter, self.width)  # may be empty
        self.unread = unread_line(cells.above, cells.delimiter, self.width)
        self.remarks = remarks_of(cells.above, cells.delimiter, self.width)  # name: value
        self._check_blocks()
        self.plain = cells.plain
        self.marks = Marks() if cells.plain else self._marks()

    @property
    def width(self) -> int:
        """Return the number of columns, including columns of words."""
        return len(self.rows[0]) if self.rows else 0

    @cached_property
    def blocks(self) -> tuple[slice, ...]:
        """Return the rows of each block. Lines of words, or empty lines, separate blocks."""
        inner = [(at, lines) for at, lines in self.between if 0 < at < len(self.rows)]
        words = [at for at, lines in inner if any(map(_is_words, lines))]
        blank = [at for at, _ in inner]
        many = len(blank) * MIN_BLOCK_ROWS > len(self.rows)  # e.g. every other line is empty
        starts = [0, *(words if many else blank), len(self.rows)]
        return tuple(slice(a, b) for a, b in pairwise(starts) if b > a)

    def block_header(self, block: int) -> tuple[str, ...]:
        """Return the lines before a block; ``above`` for the first block."""
        start = self.blocks[block].start
        return self.above if not start else tuple(dict(self.between).get(start, ()))

    def _check_blocks(self) -> None:
        """Raise UserError if titles below the first row state other units or another order."""
        for at, lines in self.between[:-1]:
            titles = titles_of(lines, self.delimiter, self.width)
            names = [[title.name for title in header] for header in (titles, self.titles)]
            units = [[unit_of(title.unit) for title in header] for header in (titles, self.titles)]
            pairs = zip(*units, strict=False)
            differ = any(first and second and first[1:] != second[1:] for first, second in pairs)
            if differ or (names[0] != names[1] and sorted(names[0]) == sorted(names[1])):
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
        """Return the title of a column; an empty title if the file has none."""
        return self.titles[column] if self.titles else Title()

    def words(self, column: int) -> tuple[str, ...]:
        """Return the cells of a column as written."""
        return tuple(row[column] for row in self.rows)

    def values(self, column: int) -> np.ndarray:
        """Return the numbers of a column, shape (rows,), before unit conversion; NaN if missing.

        Raises UserError, naming the line, for a word that is not a number.
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
        words = (row[n] for row in self.rows for n in self.numeric)
        try:
            return marks_of(word for word in words if is_numeral(word))
        except ValueError as error:
            raise UserError(f"{self.key}: {self.name!r}: {error}") from None

    @property
    def columns_text(self) -> str:
        """Return a list of the columns for messages, with their numbers and units."""
        if not self.titles:
            return f"{self.width} columns without names"
        named = [
            f"{n} {title.name or '(no name)'}{f' [{title.unit}]' if title.unit else ''}"
            for n, title in enumerate(self.titles[:MAX_LISTED])
        ]
        return f"the columns {', '.join([*named, '...'] if self.width > MAX_LISTED else named)}"


def read_text_table(key: str, path: Path, name: str | None = None) -> TextTable:
    """Return the table of a text file; ``name`` is its name in messages, by default the path.

    Raises UserError, which begins with ``key``, for a file that cannot be read, is an archive or
    not text, has no row of numbers or rows of different lengths, or has ambiguous numbers.
    """
    name = str(path) if name is None else name
    try:
        data = read_plain(path)
    except (OSError, ValueError) as error:  # ValueError: invalid file name
        reason = getattr(error, "strerror", None) or error
        raise UserError(f"{key} = {name!r}: cannot be read: {reason}") from None
    if kind := archive_kind(data):
        raise UserError(f"{key} = {name!r}: is {kind}: unpack it and name one file")
    if not is_text(data):
        raise UserError(f"{key} = {name!r}: cannot be read: it is not text")
    return table_of_text(key, name, decoded(data))


def table_of_text(key: str, name: str, text: str) -> TextTable:
    """Return the table of a text. Raises UserError as ``read_text_table`` does."""
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
    """Return the requested columns, in the order of ``wanted``.

    columns : column numbers given by the user, from 0, one for each. option : the option for them,
    for messages. Raises UserError if the file does not determine the columns, if a name fits
    several columns, and for a unit that is unknown or of another family.
    """
    numbers = _column_numbers(table, wanted, option) if columns is None else list(columns)
    for column in numbers:
        if column >= table.width:
            raise UserError(
                f"{table.key}: {option} asks for column {column} of {table.name!r}: it holds "
                f"{table.columns_text}, from 0"
            )
    pairs = zip(wanted, numbers, strict=True)
    return tuple(_read_column(table, spec, column, option) for spec, column in pairs)


def find_column(table: TextTable, spec: ColumnSpec, option: str = "--columns") -> Column | None:
    """Return the column whose name fits, or None. Raises UserError as ``select_columns`` does."""
    matches = [column for column in table.numeric if _fits_name(table.title(column), spec)]
    if len(matches) > 1:
        raise _unclear_columns(table, (spec,), option)
    return _read_column(table, spec, matches[0], option) if matches else None


def _column_numbers(table: TextTable, wanted: Sequence[ColumnSpec], option: str) -> list[int]:
    """Return the number of each requested column, found by names, by units, or by the order."""
    free, numbers = list(table.numeric), dict[int, int]()
    for index, spec in enumerate(wanted):
        matches = [column for column in free if _fits_name(table.title(column), spec)]
        # The unit of a column of unknown name is as good evidence as a name without a unit.
        rivals = (
            []
            if any(table.title(column).unit for column in matches)
            else _rivals(table, wanted, spec)
        )
        if len(matches) > 1 or (matches and rivals):
            raise _unclear_columns(table, wanted, option)
        numbers.update((index, column) for column in matches)
    free = [column for column in free if column not in numbers.values()]
    for index, spec in enumerate(wanted):
        matches = [column for column in free if _fits_unit(table.title(column), spec)]
        single = sum(other.family == spec.family for other in wanted) == 1
        if index not in numbers and single and len(matches) == 1:
            numbers[index] = matches[0]
            free.remove(matches[0])
    missing = [index for index in range(len(wanted)) if index not in numbers]
    unknown = any(table.title(n).name and not table.title(n).stated for n in free)
    ambiguous = len(missing) > 1 and (bool(table.unread) or any(table.title(n).name for n in free))
    ambiguous = ambiguous or (
        bool(missing) and any(title.name == UNREAD_NAME for title in table.titles)
    )
    ambiguous = ambiguous or (not table.titles and _names_several(table, wanted))
    shared = len(set(numbers.values())) < len(numbers)
    if shared or ambiguous or (missing and (len(missing) != len(free) or (unknown and numbers))):
        raise _unclear_columns(table, wanted, option)
    numbers |= dict(zip(missing, free, strict=False))
    return [numbers[index] for index in range(len(wanted))]


def _rivals(table: TextTable, wanted: Sequence[ColumnSpec], spec: ColumnSpec) -> list[int]:
    """Return the named columns whose unit fits a spec and whose name fits none of ``wanted``."""
    titles = {column: table.title(column) for column in table.numeric}
    return [
        column
        for column, title in titles.items()
        if title.name
        and _fits_unit(title, spec)
        and not any(_fits_name(title, other) for other in wanted)
    ]


def _names_several(table: TextTable, wanted: Sequence[ColumnSpec]) -> bool:
    """Return whether a line above the rows names several columns without assigning them."""
    patterns = [spec.names for spec in wanted]
    return any(count_named(line, patterns) > 1 for line in table.above[-MAX_TITLE_LINES:])


def _fits_name(title: Title, spec: ColumnSpec) -> bool:
    unit = unit_of(title.unit)
    loose = not title.stated and unit is not None and unit.family != "temperature"
    fitting = unit is None or loose or _same_family(unit, spec)
    return bool(title.name) and fitting and bool(re.search(spec.names, title.name, re.IGNORECASE))


def _fits_family(title: Title, spec: ColumnSpec) -> bool:
    unit = unit_of(title.unit)
    return unit is not None and _same_family(unit, spec)


def _fits_unit(title: Title, spec: ColumnSpec) -> bool:
    """Return whether a column fits by its unit. The units 1 and % do not suffice beside a name."""
    unit = unit_of(title.unit)
    number = unit is not None and unit.family == "number"
    return _fits_family(title, spec) and not (number and title.name not in ("", UNREAD_NAME))


def _same_family(unit: Unit, spec: ColumnSpec) -> bool:
    return unit.family == spec.family or (unit.family, spec.family) == ("rate", "frequency")


def _unclear_columns(table: TextTable, wanted: Sequence[ColumnSpec], option: str) -> UserError:
    names = " and ".join(spec.meaning for spec in wanted)
    return UserError(
        f"{table.key} = {table.name!r}: holds {table.columns_text}, from 0: it is not clear which "
        f"holds {names}; give {option}"
    )


def _read_column(table: TextTable, spec: ColumnSpec, column: int, option: str) -> Column:
    title = table.title(column)
    prefix = f"{table.key} = {table.name!r}: column {column}{f' {title.name!r}' * bool(title.name)}"
    remedy = f"; give {spec.option}" if spec.option else f"; give {option}"
    if re.match(LOGARITHM_NAME, title.name, re.IGNORECASE) and not re.search(spec.names, "log"):
        raise UserError(
            f"{prefix}: holds logarithms, not {spec.meaning}: write the numbers themselves"
        )
    if spec.family == "pressure" and re.search(STRESS_NAME, title.name, re.IGNORECASE):
        raise UserError(f"{prefix}: holds a stress, not {spec.meaning}: divide it by the strain")
    if spec.unit is not None:
        unit, source = unit_of(spec.unit), "given"
        if unit is None or not _same_family(unit, spec):
            raise UserError(
                f"{table.key}: {spec.option} {spec.unit}: is not a unit of {spec.meaning}"
            )
    elif title.unit and (title.stated or _fits_family(title, spec)):
        unit, source = unit_of(title.unit), "of the file"
        if unit is None:
            raise UserError(
                f"{prefix}: the unit {title.unit!r} of {spec.meaning} is not known{remedy}"
            )
        if not _same_family(unit, spec):
            raise UserError(
                f"{prefix}: is in {title.unit!r}, not a unit of {spec.meaning}; give {option}"
            )
    else:
        inside = [word for word in title.name.split()[:-1] if _fits_family(Title(unit=word), spec)]
        other = unit_of(title.unit)  # not marked as a unit, and of another family
        foreign = title.unit if other and other.family != "number" else ""
        unread = table.unread if spec.family != "number" else ""
        text = "".join(inside[:1]) or foreign or unread_unit(title.name, spec.names) or unread
        if text:
            raise UserError(f"{prefix}: it is not clear what {text!r:.60} says of its unit{remedy}")
        unit, source = unit_of(spec.default), "assumed"
        assert unit is not None
    if unit.family == "rate" != spec.family and not re.search(
        ANGULAR_NAME, title.name, re.IGNORECASE
    ):
        raise UserError(f"{prefix}: {unit.text!r} may be Hz or rad/s{remedy}")
    values = table.values(column)
    code = missing_code(values, repeated=False)
    if code is not None:
        values = np.where(values == code.value, np.nan, values)
    return Column(column, title, unit.si(values), unit, source, spec, code and code.value)


def describe_columns(table: TextTable, columns: Sequence[Column]) -> str:
    """Return one line that lists the columns with their quantities, units and unit sources."""
    parts = []
    for column in columns:
        name = f" {column.title.name}" if column.title.name else ""
        unit = f" in {column.unit.text}" if column.unit.family != "number" else ""
        source = (
            "" if column.unit_source == "of the file" or not unit else f" ({column.unit_source})"
        )
        parts.append(f"column {column.number}{name} as {column.spec.meaning}{unit}{source}")
    missing = sum(int(np.isnan(column.values).sum()) for column in columns)
    text = f"{table.name}: {len(table.rows)} rows; {', '.join(parts)}"
    if len(table.blocks) > 1:
        text += f"; {len(table.blocks)} blocks"
    if missing:
        codes = ", ".join(f"{column.code:g}" for column in columns if column.code is not None)
        text += f"; {counted(missing, 'value')} missing{f' ({codes})' if codes else ''}"
    if table.passed_over:
        text += f"; passed over {counted(len(table.passed_over), 'line')} of words"
    return text
