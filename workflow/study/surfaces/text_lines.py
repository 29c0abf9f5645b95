"""Lines in text files: columns of positions and heights, heights alone, matrices, points of a map.

Which of them a file holds follows from its titles, its remarks and its numbers.
"""

import re

import numpy as np

from ...ground import UserError, counted
from ...text_tables import (
    UNREAD,
    TextTable,
    Title,
    count_named,
    quantity_of,
    read_text_table,
    unit_of,
)
from .positions import PointGrid, grid_of, is_uniform, precision, repeats
from .raw_lines import KEY, MIN_SAMPLES, LineFile, RawLines, check_numbered, metres, row_spacing

INDEX = r"^(index|idx|no\.?|nr\.?|n|i|#|number|point|sample|row|line|id)$"
TIME = r"^(t|time)$"
POSITION = r"^(x|s)$|pos|dist|later|scan|travel|absciss|length|^x\b"
HEIGHT = r"^z$|height|raw|profil|depth|topo|elev|amplitude|surface|^z\b"
PITCH = re.compile(
    r"(pitch|step|(sampl\w*|point|data|x|lateral)?[-_ ]*(spacing|step|interval|increment|pitch)"
    r"|d_?x|delta[-_ ]?x|x[-_ ]?(scale|resolution)|xy?[-_ ]?calibration|pixel[-_ ]?size)"
)
OF_A_SAMPLE = re.compile(r"\s*(/|per\s)\s*(pixel|px|point|pt|sample)s?$", re.IGNORECASE)
WIDTH = re.compile(
    r"(width|breite|x[-_ ]?(size|range|length|extent)|scan[-_ ]?(size|width|length))"
)
TALL = re.compile(r"(height|höhe|y[-_ ]?(size|range|length|extent))")
VALUE_UNIT = re.compile(r"(value|z|height|data|y)?[-_ ]*units?")
SCALE = re.compile(
    r"(z|height|data|value)?s?[-_ ]*(scal(e|ing)|factor|multiplier|calibration)[-_ ]*(factor)?"
)
MANY = 3  # columns, from which on numbers alone may be a matrix


def read_text_lines(asked: LineFile) -> RawLines:
    """Return the lines of a text file as they stand there.

    Raises UserError for what ``read_text_table`` refuses, for columns that are not there, for a
    file that does not say which of its columns hold positions and heights, and for positions that
    repeat without making a map.
    """
    table = read_text_table(KEY, asked.path, asked.name)
    raw = _lines_of_table(asked, table)
    if table.passed_over:
        lines = counted(len(table.passed_over), "line")
        over = f"; {lines} of words below the first row passed over"
        raw = raw._replace(description=raw.description + over)
    return raw


def _lines_of_table(asked: LineFile, table: TextTable) -> RawLines:
    check_numbered(asked)
    if any(column not in table.numeric for column in asked.columns):
        raise UserError(
            f"surface.columns = {list(asked.columns)!r}: {asked.name!r} holds {table.columns_text}"
            f", numbers in {', '.join(map(str, table.numeric))}"
        )
    for name, text in table.remarks.items():
        if SCALE.fullmatch(name) and quantity_of(text) != (1.0, ""):
            raise UserError(
                f"{KEY} = {asked.name!r}: states {name}: {text}, which is not read: multiply the "
                "heights and leave that line out"
            )
    if asked.step is not None or len(table.numeric) == 1 or _is_matrix(asked, table):
        return _heights_alone(asked, table)
    if asked.columns:
        return _columns(asked, table, asked.columns, "as given")
    found = _found_columns(asked, table)
    if len(found) == MANY:
        raw = _map(asked, table, found[0], found[2], (found[1],))
        return raw or _columns(asked, table, (found[0], found[2]), "by their names")
    whose = "by their names" if table.titles else "the first two, as nothing names others"
    return _columns(asked, table, found, whose)


def _columns(asked: LineFile, table: TextTable, columns: tuple, whose: str) -> RawLines:
    """Return the lines of a column of positions and one or several of heights."""
    x = table.values(columns[0])
    if x.size > MIN_SAMPLES and repeats(x):
        others = tuple(n for n in table.numeric if n not in columns)
        raw = _map(asked, table, columns[0], columns[1], others, along_x=bool(asked.columns))
        if raw is None:
            raise UserError(
                f"{KEY} = {asked.name!r}: positions in column {columns[0]} repeat, as in a list of "
                "points of a map; no other column makes a grid of them: give surface.columns"
            )
        return raw
    heights = np.array([table.values(n) for n in columns[1:]])
    if not asked.columns and not table.titles and is_uniform(heights[0], _known(table, columns[1])):
        raise UserError(
            f"{KEY} = {asked.name!r}: columns 0 and 1 both go in equal steps, as positions do: "
            f"give surface.columns, out of {table.width}, from 0"
        )
    units = tuple(_unit(asked, table, column) for column in columns)
    told = f"columns {', '.join(_named(table, n) for n in columns)}, {whose}"
    return RawLines(heights, x, _known(table, columns[0]), None, units, told)


def _map(
    asked: LineFile,
    table: TextTable,
    x: int,
    z: int,
    others: tuple[int, ...],
    along_x: bool = False,
) -> RawLines | None:
    """Return the lines of a list of points; None where no other column makes a grid with x."""
    for y in others:
        if _is_other(table.title(y)):
            continue
        grid = grid_of(table.values(x), table.values(y), table.values(z), along_x)
        if grid is not None:
            return _of_grid(asked, table, grid, (x, y, z))
    return None


def _of_grid(
    asked: LineFile, table: TextTable, grid: PointGrid, places: tuple[int, int, int]
) -> RawLines:
    x, y, z = places
    along, across = (y, x) if grid.turned else (x, y)
    units = (_unit(asked, table, along), _unit(asked, table, z))
    told = (
        f"a list of points of a map: lines along column {_named(table, along)}, one for each value "
        f"of column {_named(table, across)}, heights of column {_named(table, z)}"
    )
    known = _known(table, along)[grid.first]
    rows = row_spacing(grid.rows, asked.units[0] if asked.units else table.title(across).unit)
    return RawLines(grid.heights, grid.x, known, None, units, told, rows)


def _heights_alone(asked: LineFile, table: TextTable) -> RawLines:
    """Return lines whose step is given by the user or a remark: one column, or the rows of many."""
    columns = asked.columns or table.numeric
    if len(columns) > 1 and not asked.columns and any(title.name for title in table.titles):
        raise UserError(
            f"{KEY} = {asked.name!r}: holds {table.columns_text}, from 0: give those of heights, "
            "as surface.columns = [1]"
        )
    values = np.array([table.values(n) for n in columns])
    matrix = not asked.columns and len(columns) > 1
    heights = values.T if matrix else values
    what = "a matrix of heights, a row for each line" if matrix else "heights alone"
    units = (_unit(asked, table, columns[0]) or _remarked_unit(table),)
    step = asked.step if asked.step is not None else _step_of_remarks(asked, table, heights)
    if step is None:
        raise UserError(
            f"{KEY} = {asked.name!r}: holds {what}, without positions: give surface.step, the "
            "distance of two samples along a line, in m"
        )
    whose = "as given" if asked.step is not None else "as the file says"
    told = f"{what}, step {whose}"
    rows = _quantity_of_remarks(asked, table, TALL) if matrix else None
    between = None if rows is None else rows / len(heights)
    return RawLines(heights, None, np.empty(0), step, ("", *units), told, between)


def _step_of_remarks(asked: LineFile, table: TextTable, heights: np.ndarray) -> float | None:
    """Return the step (m) that a remark such as "pitch = 0.5 um" or "Width: 96 um" says."""
    pitch, width = (_quantity_of_remarks(asked, table, each) for each in (PITCH, WIDTH))
    return width / heights.shape[1] if pitch is None and width is not None else pitch


def _quantity_of_remarks(asked: LineFile, table: TextTable, names: re.Pattern[str]) -> float | None:
    """Return the length (m) that the first remark of such a name says; None without one."""
    for name, text in table.remarks.items():
        quantity = quantity_of(text)
        if quantity is None or not names.fullmatch(re.sub(r"\s*[\[(].*", "", name)):
            continue
        own = quantity[1] or "".join(re.findall(r"[\[(](.*?)[\])]", name))
        if not own and asked.units and names is PITCH:  # a bare width may be a count of samples
            own = asked.units[0]
        factor = metres(OF_A_SAMPLE.sub("", own))
        if factor is not None and quantity[0] > 0.0:
            return quantity[0] * factor
    return None


def _remarked_unit(table: TextTable) -> str:
    """Return the unit of heights that a remark such as "Value units: m" says; "" without one."""
    found = [text for name, text in table.remarks.items() if VALUE_UNIT.fullmatch(name)]
    return next((unit for unit in found if metres(unit) is not None), "")


def _is_matrix(asked: LineFile, table: TextTable) -> bool:
    """Return whether a table without titles holds heights in every column."""
    if asked.columns or len(table.numeric) < MANY or any(title.name for title in table.titles):
        return False
    if any(WIDTH.fullmatch(name) for name in table.remarks):
        return True
    if len(table.numeric) == MANY and repeats(table.values(table.numeric[0])):
        return False
    first = table.numeric[0]
    return table.width >= MIN_SAMPLES and not is_uniform(table.values(first), _known(table, first))


def _found_columns(asked: LineFile, table: TextTable) -> tuple[int, ...]:
    """Return the columns of positions and heights, or x, y and z of a map; by names and units."""
    numeric = table.numeric
    if not table.titles:
        if len(numeric) >= MANY and any(map(_names_both, table.above)):
            raise _not_clear(asked, table)
        points = len(numeric) == MANY and repeats(table.values(numeric[0]))
        return numeric[:MANY] if points else numeric[:2]
    if any(table.title(n).name == UNREAD for n in numeric):
        raise _not_clear(asked, table)
    own = [n for n in numeric if not _is_other(table.title(n))]
    lengths = [n for n in own if metres(table.title(n).unit) is not None]
    for some in (own, lengths):
        if len(some) == 2:
            turned = _named_as(table, some[0], HEIGHT) and _named_as(table, some[1], POSITION)
            return (some[1], some[0]) if turned else tuple(some)
        names = [table.title(n).name.lower()[:1] for n in some]
        if sorted(names) == ["x", "y", "z"]:
            return tuple(some[names.index(name)] for name in "xyz")
        x = [n for n in some if _named_as(table, n, POSITION)]
        z = [n for n in some if _named_as(table, n, HEIGHT)]
        if len(x) == len(z) == 1 and x != z:
            return x[0], z[0]
    raise _not_clear(asked, table)


def _not_clear(asked: LineFile, table: TextTable) -> UserError:
    return UserError(
        f"{KEY} = {asked.name!r}: holds {table.columns_text}, from 0: give those of positions and "
        "of heights, as surface.columns = [0, 1], or surface.step in place of positions"
    )


def _names_both(line: str) -> bool:
    """Return whether a line names positions and heights, though not of which columns."""
    return count_named(line, (POSITION, HEIGHT)) == 2


def _named_as(table: TextTable, column: int, names: str) -> bool:
    return bool(re.search(names, table.title(column).name, re.IGNORECASE))


def _is_other(title: Title) -> bool:
    """Return whether a column is a count, a time, or another quantity than a length."""
    unit = unit_of(title.unit)
    if unit is not None and title.stated:
        return unit.family != "length"
    return (
        bool(re.search(f"{INDEX}|{TIME}", title.name, re.IGNORECASE)) and metres(title.unit) is None
    )


def _unit(asked: LineFile, table: TextTable, column: int) -> str:
    """Return the unit of a column as its title has it, "" without one.

    Raises UserError for one that is stated and is no length, unless the user gives units.
    """
    title = table.title(column)
    if metres(title.unit) is not None or asked.units or not title.unit:
        return title.unit
    if title.stated:
        known = unit_of(title.unit)
        what = "is no unit of length" if known else "is not known"
        way = "surface.columns" if known else "surface.units"
        raise UserError(
            f"{KEY} = {asked.name!r}: the unit {title.unit!r} of column {_named(table, column)} "
            f"{what}: give {way}"
        )
    return ""


def _named(table: TextTable, column: int) -> str:
    name = table.title(column).name
    return f"{column} {name}" if name else str(column)


def _known(table: TextTable, column: int) -> np.ndarray:
    """Return to how much each number of a column is written."""
    return precision(table.marks.plain(word) or "0" for word in table.words(column))
