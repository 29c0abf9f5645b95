"""Selection of the columns of a text table by name, unit and order.

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
from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np

from ..ground import UserError, counted
from ..text_tables import (
    MAX_TITLE_LINES,
    UNIT_MARK,
    UNREAD_NAME,
    TextTable,
    Title,
    Unit,
    contains_unit,
    unit_of,
)
from .codes import missing_code

LOGARITHM_NAME = r"^(log|lg|ln)([\W_\d]|$)"  # name of a column of logarithms
STRESS_NAME = r"^(?!.*modul).*(stress|spannung)"  # a stress has the unit of a modulus
ANGULAR_NAME = r"omega|\u03c9|^w$|angular|circular|kreis"  # with the unit 1/s it is in rad/s

# Words at the end of a column name that are not units.
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
MARK = re.compile(UNIT_MARK)


class ColumnSpec(NamedTuple):
    """Requested quantity of a column, with the names and units that identify it."""

    meaning: str  # quantity in words, for messages: "a storage modulus G'"
    family: str  # of its unit, one of FAMILIES; "number" for no unit and %
    names: str  # pattern to search for in column names, ignoring case
    default: str  # unit if the file states none
    option: str = ""  # command-line option for the unit
    unit: str | None = None  # given by the user; replaces that of the file
    clock: bool = False  # whether times of day are accepted, since only differences count

    def is_named(self, title: Title) -> bool:
        """Return whether a title names the quantity, whatever its unit."""
        return bool(title.name) and bool(re.search(self.names, title.name, re.IGNORECASE))

    def has_unit(self, unit: Unit | None) -> bool:
        """Return whether a unit is a unit of the quantity; 1/s counts for a frequency."""
        families = (self.family, "rate") if self.family == "frequency" else (self.family,)
        return unit is not None and unit.family in families

    def fits_name(self, title: Title) -> bool:
        """Return whether a title names the quantity and does not state a unit of another one."""
        unit = unit_of(title.unit)
        loose = not title.stated and unit is not None and unit.family != "temperature"
        return self.is_named(title) and (unit is None or loose or self.has_unit(unit))

    def fits_unit(self, title: Title) -> bool:
        """Return whether the unit of a title fits; for 1 and %, the title must have no name."""
        unnamed = title.name in ("", UNREAD_NAME)
        return self.has_unit(unit_of(title.unit)) and (self.family != "number" or unnamed)


class Column(NamedTuple):
    """Values of a selected column, with its title and unit."""

    number: int  # from 0
    title: Title
    values: np.ndarray  # in SI units (rad/s, K), shape (rows,); NaN if missing
    unit: Unit
    unit_source: str  # "given", "of the file" or "assumed"
    spec: ColumnSpec
    code: float | None = None  # missing-value code of the column


def select_columns(
    table: TextTable,
    wanted: Sequence[ColumnSpec],
    columns: Sequence[int] | None = None,
    option: str = "--columns",
) -> tuple[Column, ...]:
    """Return the requested columns, in the order of ``wanted``.

    columns : column numbers given by the user, from 0, one per quantity. option : name of the
    option that gives them, for messages. Raises UserError if the file does not determine the
    columns, if a name fits several columns, and for a unit that is unknown or of another family.
    """
    numbers = _column_numbers(table, wanted, option) if columns is None else columns
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
    matches = [column for column in table.numeric if spec.fits_name(table.title(column))]
    if len(matches) > 1:
        raise _unclear_columns(table, (spec,), option)
    return _read_column(table, spec, matches[0], option) if matches else None


def _column_numbers(table: TextTable, wanted: Sequence[ColumnSpec], option: str) -> list[int]:
    """Return the number of each requested column, found by name, by unit, or by order."""
    clocks = table.clocks if any(spec.clock for spec in wanted) else ()
    readable = sorted((*table.numeric, *clocks))
    titles = {column: table.title(column) for column in readable}
    numbers = dict[ColumnSpec, int]()
    for spec in wanted:
        matches = [column for column, title in titles.items() if spec.fits_name(title)]
        contradicted = not matches and any(map(spec.is_named, titles.values()))
        if len(matches) > 1 or contradicted or (matches and _has_rival(titles, wanted, spec)):
            raise _unclear_columns(table, wanted, option)
        numbers.update((spec, column) for column in matches)
    if len(set(numbers.values())) < len(numbers):  # one name fits two quantities
        raise _unclear_columns(table, wanted, option)
    missing = [spec for spec in wanted if spec not in numbers]
    free = [column for column in readable if column not in numbers.values()]
    for spec in list(missing):
        matches = [column for column in free if spec.has_unit(unit_of(titles[column].unit))]
        fits = len(matches) == 1 and spec.fits_unit(titles[matches[0]])
        if fits and sum(other.family == spec.family for other in missing) == 1:
            numbers[spec] = matches[0]
            missing.remove(spec)
            free.remove(matches[0])
    if missing and (len(missing) != len(free) or _names_columns(table, wanted, free)):
        raise _unclear_columns(table, wanted, option)
    numbers |= dict(zip(missing, free, strict=False))
    return [numbers[spec] for spec in wanted]


def _has_rival(titles: dict[int, Title], wanted: Sequence[ColumnSpec], spec: ColumnSpec) -> bool:
    """Return whether a column with an unknown name but a fitting unit competes for a quantity.

    A column that fits by its name and also has a unit has no rival.
    """
    if any(title.unit for title in titles.values() if spec.fits_name(title)):
        return False
    unknown = [
        title
        for title in titles.values()
        if title.name and not any(other.fits_name(title) for other in wanted)
    ]
    return any(map(spec.fits_unit, unknown))


def _names_columns(table: TextTable, wanted: Sequence[ColumnSpec], free: Sequence[int]) -> bool:
    """Return whether the file names the free columns, so that their order means nothing."""
    if len(table.numeric) == len(wanted) == 1:
        return False
    titles = [table.title(column) for column in free]
    named = any(title.name and not (title.stated and len(free) == 1) for title in titles)
    patterns = [spec.names for spec in wanted]
    several = any(count_named(line, patterns) > 1 for line in table.above[-MAX_TITLE_LINES:])
    return named or bool(table.unread) or (not table.titles and several)


def _unclear_columns(table: TextTable, wanted: Sequence[ColumnSpec], option: str) -> UserError:
    """Return the error for columns that the file does not determine, with example options."""
    for n in range(table.width):
        if n not in table.numeric and any(spec.fits_name(table.title(n)) for spec in wanted):
            raise table.refused(
                f"column {n} {table.title(n).name!r} holds {table.row(0)[n]!r:.40}: write numbers, "
                "of times the seconds since the start"
            )
    names = " and ".join(spec.meaning for spec in wanted)
    remedy = option
    if option.startswith("--"):
        units = {spec.option: spec.unit or spec.default for spec in wanted if spec.option}
        example = " " + ",".join(map(str, table.numeric[: len(wanted)])) if wanted[1:] else ""
        remedy = " ".join([f"{option}{example}", *(f"{key} {unit}" for key, unit in units.items())])
    return table.refused(
        f"holds {table.columns_text}, from 0: it is not clear which holds {names}; give {remedy}"
    )


def _read_column(table: TextTable, spec: ColumnSpec, column: int, option: str) -> Column:
    """Return a column in SI units. Raises UserError for another quantity and unclear units."""
    title = table.title(column)
    prefix = f"{table.prefix}: column {column}{f' {title.name!r}' * bool(title.name)}"
    if re.match(LOGARITHM_NAME, title.name, re.IGNORECASE) and not re.search(spec.names, "log"):
        raise UserError(
            f"{prefix}: holds logarithms, not {spec.meaning}: write the numbers themselves"
        )
    is_stress = spec.family == "pressure" and re.search(STRESS_NAME, title.name, re.IGNORECASE)
    if is_stress and not re.search(spec.names, "stress"):
        raise UserError(f"{prefix}: holds a stress, not {spec.meaning}: divide it by the strain")
    if spec.family == "pressure" and re.search(r"complian", title.name, re.IGNORECASE):
        raise UserError(f"{prefix}: holds a compliance (creep test), not a modulus: invert it")
    unit, source = _unit_of_column(table, spec, title, prefix, option)
    angular = re.search(ANGULAR_NAME, title.name, re.IGNORECASE)
    if unit.family == "rate" and spec.family == "frequency" and not angular:
        remedy = spec.option or option
        raise UserError(f"{prefix}: {unit.text!r} may be Hz or rad/s; give {remedy}")
    is_clock = spec.clock and column in table.clocks
    if is_clock != (":" in unit.text) and (":" in unit.text or unit.factor != 1.0):
        word = table.row(0)[column]
        raise UserError(f"{prefix}: is in {unit.text!r}, but holds {word!r:.40}: write seconds")
    values = table.clocks[column] if is_clock else table.values(column)
    code = missing_code(values, repeated=False)
    if code is not None:
        values = np.where(values == code.value, np.nan, values)
    return Column(column, title, unit.si(values), unit, source, spec, code and code.value)


def _unit_of_column(
    table: TextTable, spec: ColumnSpec, title: Title, prefix: str, option: str
) -> tuple[Unit, str]:
    """Return the unit of a column and its source: "given", "of the file" or "assumed"."""
    stated = unit_of(title.unit)
    if spec.unit is not None:
        unit = unit_of(spec.unit)
        if unit is None or not spec.has_unit(unit):
            raise UserError(
                f"{table.key}: {spec.option} {spec.unit}: is not a unit of {spec.meaning}"
            )
        return unit, "given"
    remedy = f"give {spec.option or option}"
    if title.stated and stated is None:
        raise UserError(
            f"{prefix}: the unit {title.unit!r} of {spec.meaning} is not known; {remedy}"
        )
    if stated is not None and spec.has_unit(stated):
        return stated, "of the file"
    if title.stated:
        raise UserError(
            f"{prefix}: is in {title.unit!r}, not a unit of {spec.meaning}; give {option}"
        )
    inside = [word for word in title.name.split()[:-1] if spec.has_unit(unit_of(word))]
    foreign = title.unit if stated is not None and stated.family != "number" else ""
    unread = table.unread if spec.family != "number" else ""
    text = "".join(inside[:1]) or foreign or _unread_unit(title.name, spec.names) or unread
    if text:
        raise UserError(f"{prefix}: it is not clear what {text!r:.60} says of its unit; {remedy}")
    unit = unit_of(spec.default)
    assert unit is not None
    return unit, "assumed"


def describe_columns(table: TextTable, columns: Sequence[Column]) -> str:
    """Return one line that lists the columns with their quantities, units and unit sources."""
    parts = []
    for column in columns:
        name = f" {column.title.name}" if column.title.name else ""
        unit = f" in {column.unit.text}" if column.unit.family != "number" else ""
        source = f" ({column.unit_source})" if unit and column.unit_source != "of the file" else ""
        parts.append(f"column {column.number}{name} as {column.spec.meaning}{unit}{source}")
    missing = sum(int(np.isnan(column.values).sum()) for column in columns)
    text = f"{table.name}: {len(table.lines)} rows; {', '.join(parts)}"
    if len(table.blocks) > 1:
        text += f"; {len(table.blocks)} blocks"
    titles = 1 + max((line.count("\t") for line in table.above), default=0)
    if table.titles and table.delimiter is None and titles > table.width:
        text += f"; the first {table.width} of {titles} titles"
    if missing:
        codes = ", ".join(f"{column.code:g}" for column in columns if column.code is not None)
        text += f"; {counted(missing, 'value')} missing{f' ({codes})' if codes else ''}"
    if table.passed_over:
        text += f"; passed over {counted(len(table.passed_over), 'line')} of words"
    return text


def count_named(line: str, patterns: Iterable[str]) -> int:
    """Return the number of patterns of column names that match a word of a line."""
    words = re.findall(r"""[\w'"/^*]+""", line)
    return sum(
        any(re.search(pattern, word, re.IGNORECASE) for word in words) for pattern in patterns
    )


def _unread_unit(name: str, names: str) -> str:
    """Return the part of a name that may be an unknown or misplaced unit; "" without one.

    names : pattern of words that name the quantity; these are not taken as units.
    """
    words = [word for word in re.split(r"[\s.-]+|_(?=\w\w|V\b)", name) if word]
    last = words[-1] if len(words) > 1 and not words[-1].isdecimal() else ""
    marked = MARK.search(name)
    tail = name[marked.start() :] if marked else ""
    for text in filter(None, (tail, last)):
        word = MARK.sub("", text, count=1) if text is tail else text
        flags = re.IGNORECASE if len(text) > 1 else 0  # V is volt, not velocity
        if word.lower() not in NAME_WORDS and not re.search(names, text, flags):
            return word
    return next(filter(contains_unit, words), "")
