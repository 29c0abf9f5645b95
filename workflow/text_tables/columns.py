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
from typing import NamedTuple

import numpy as np

from ..ground import UserError, counted
from .codes import missing_code
from .headers import MAX_TITLE_LINES, UNREAD_NAME, Title, count_named, unread_unit
from .text_table import TextTable
from .units import Unit, unit_of

LOGARITHM_NAME = r"^(log|lg|ln)([\W_\d]|$)"  # name of a column of logarithms
STRESS_NAME = r"^(?!.*modul).*(stress|spannung)"  # stress: same unit as a modulus
ANGULAR_NAME = r"omega|\u03c9|^w$|angular|circular|kreis"  # of a frequency in rad/s if in 1/s


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
        named_only = not any(table.title(column).unit for column in matches)
        contradicted = not matches and any(_has_name(table.title(n), spec) for n in free)
        rival = matches and named_only and _has_rival(table, wanted, spec)
        if len(matches) > 1 or contradicted or rival:
            raise _unclear_columns(table, wanted, option)
        numbers.update((index, column) for column in matches)
    if len(set(numbers.values())) < len(numbers):  # one name fits two quantities
        raise _unclear_columns(table, wanted, option)
    free = [column for column in free if column not in numbers.values()]
    for index, spec in enumerate(wanted):
        missing = [n for n in range(len(wanted)) if n not in numbers]
        matches = [column for column in free if _fits_unit(table.title(column), spec)]
        single = sum(wanted[n].family == spec.family for n in missing) == 1
        if index in missing and single and len(matches) == 1:
            numbers[index] = matches[0]
            free.remove(matches[0])
    missing = [index for index in range(len(wanted)) if index not in numbers]
    if missing and (len(missing) != len(free) or _names_columns(table, wanted, free)):
        raise _unclear_columns(table, wanted, option)
    numbers |= dict(zip(missing, free, strict=False))
    return [numbers[index] for index in range(len(wanted))]


def _has_rival(table: TextTable, wanted: Sequence[ColumnSpec], spec: ColumnSpec) -> bool:
    """Return whether a column of an unknown name has a unit that fits.

    Such a unit is as good evidence as a name without a unit.
    """
    titles = [table.title(column) for column in table.numeric]
    return any(
        title.name
        and _fits_unit(title, spec)
        and not any(_fits_name(title, other) for other in wanted)
        for title in titles
    )


def _names_columns(table: TextTable, wanted: Sequence[ColumnSpec], free: Sequence[int]) -> bool:
    """Return whether the file names the free columns, so that their order means nothing."""
    if len(table.numeric) == len(wanted) == 1:
        return False
    titles = [table.title(column) for column in free]
    named = any(title.name and not (title.stated and len(free) == 1) for title in titles)
    return named or bool(table.unread) or (not table.titles and _names_several(table, wanted))


def _names_several(table: TextTable, wanted: Sequence[ColumnSpec]) -> bool:
    """Return whether a line above the rows names several columns without assigning them."""
    patterns = [spec.names for spec in wanted]
    return any(count_named(line, patterns) > 1 for line in table.above[-MAX_TITLE_LINES:])


def _fits_name(title: Title, spec: ColumnSpec) -> bool:
    unit = unit_of(title.unit)
    loose = not title.stated and unit is not None and unit.family != "temperature"
    return _has_name(title, spec) and (unit is None or loose or _same_family(unit, spec))


def _has_name(title: Title, spec: ColumnSpec) -> bool:
    return bool(title.name) and bool(re.search(spec.names, title.name, re.IGNORECASE))


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
    example = ",".join(map(str, table.numeric[: len(wanted)]))
    return UserError(
        f"{table.key} = {table.name!r}: holds {table.columns_text}, from 0: it is not clear which "
        f"holds {names}; give {option}{f' {example}' if option.startswith('--') else ''}"
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
