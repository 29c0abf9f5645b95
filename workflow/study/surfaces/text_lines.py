"""Lines in text files: columns of positions and heights, heights alone, matrices, points of a map.

The layout of a file follows from its titles, its remarks and its numbers.
"""

import json
import re

import numpy as np

from ...ground import UserError, counted
from ...text_tables import UNREAD_NAME, TextTable, Title, is_numeral, read_text_table, unit_of
from ..columns import count_named
from .positions import grid_of, is_uniform, precision, repeats
from .raw_lines import (
    KEY,
    MAX_MAP_ASPECT,
    MIN_SAMPLES,
    LineFile,
    RawLines,
    check_numbered,
    metres,
    row_spacing,
)
from .remarks import (
    HEIGHT_REMARK,
    PITCH_REMARK,
    WIDTH_REMARK,
    check_scale,
    remarks_of,
    stated_code,
    stated_length,
    stated_unit,
)

INDEX = r"^(index|idx|no\.?|nr\.?|n|i|#|number|point|sample|row|line|id)$"
TIME_NAME = r"^(t|time)$"
POSITION_NAME = r"^(x|s)$|pos|dist|later|scan|travel|absciss|length|^x\b"
HEIGHT_NAME = r"^z$|height|raw|profil|depth|topo|elev|amplitude|surface|^z\b"
MIN_MATRIX_COLUMNS = 3  # from which a table without titles may be a matrix of heights
MIN_MAP_ROWS = 32  # of a matrix that may be a map
POINT_COLUMNS = 3  # x, y and z of the points of a map


def read_text_lines(file: LineFile) -> RawLines:
    """Return the lines of a text file in its units.

    Raises UserError as ``read_text_table`` does, for columns that the file does not have, for a
    file that does not determine the columns of positions and heights, and for positions that
    repeat without forming a map.
    """
    table = read_text_table(KEY, file.path, file.name)
    raw = _lines_of_table(file, table)
    if (code := stated_code(table)) is not None:
        raw = raw._replace(heights=np.where(raw.heights == code, np.nan, raw.heights))
    if table.passed_over:
        lines = counted(len(table.passed_over), "line")
        note = f"; {lines} of words below the first row passed over"
        raw = raw._replace(description=raw.description + note)
    return raw


def _lines_of_table(file: LineFile, table: TextTable) -> RawLines:
    check_numbered(file)
    if any(column not in table.numeric for column in file.columns):
        raise UserError(
            f"surface.columns = {list(file.columns)!r}: {file.name!r} holds {table.columns_text}"
            f", numbers in {', '.join(map(str, table.numeric))}"
        )
    check_scale(file, table)
    if file.step is not None or len(table.numeric) == 1 or _is_matrix(file, table):
        return _heights_alone(file, table)
    if file.columns:
        return _lines_of_columns(file, table, file.columns, "as given")
    columns = _columns_by_titles(file, table)
    if len(columns) == POINT_COLUMNS:
        x, y, z = columns
        raw = _lines_of_points(file, table, (x, z), (y,))
        return raw or _lines_of_columns(file, table, (x, z), "by their names")
    source = "by their names" if table.titles else "the first two, as nothing names others"
    return _lines_of_columns(file, table, columns, source)


def _lines_of_columns(file: LineFile, table: TextTable, columns: tuple, source: str) -> RawLines:
    """Return the lines of a column of positions and one or more columns of heights."""
    x = table.values(columns[0])
    if x.size > MIN_SAMPLES and repeats(x):
        others = tuple(n for n in table.numeric if n not in columns)
        if raw := _lines_of_points(file, table, columns, others):
            return raw
        raise table.refused(
            f"positions in column {columns[0]} repeat, as in a list of points of a map; no other "
            "column makes a grid of them: give surface.columns"
        )
    heights = np.array([table.values(n) for n in columns[1:]])
    unnamed = not file.columns and not table.titles
    if unnamed and is_uniform(heights[0], _precisions(table, columns[1])):
        raise table.refused(
            "columns 0 and 1 both go in equal steps, as positions do: give surface.columns, out of "
            f"{table.width}, from 0"
        )
    units = tuple(_unit(file, table, column) for column in columns)
    description = f"columns {', '.join(_label(table, n) for n in columns)}, {source}"
    return RawLines(heights, units, description, x, _precisions(table, columns[0]))


def _lines_of_points(
    file: LineFile, table: TextTable, columns: tuple, others: tuple[int, ...]
) -> RawLines | None:
    """Return the lines of a list of points, or None if no other column forms a grid with x.

    columns : of x and z. Lines run along the x that the user gives.
    """
    x, z, *_ = columns
    for y in others:
        if _is_other_quantity(table.title(y)):
            continue
        of_x, of_y, of_z = (table.values(n) for n in (x, y, z))
        if (grid := grid_of(of_x, of_y, of_z, bool(file.columns))) is None:
            continue
        along, across = (y, x) if grid.turned else (x, y)
        description = (
            f"map of points in columns {_label(table, along)}, {_label(table, across)}, heights in "
            f"{_label(table, z)}"
        )
        units = _unit(file, table, along), _unit(file, table, z)
        precisions = _precisions(table, along)[grid.first]
        rows = row_spacing(grid.rows, file.units[0] if file.units else table.title(across).unit)
        return RawLines(grid.heights, units, description, grid.x, precisions, row_spacing=rows)
    return None


def _heights_alone(file: LineFile, table: TextTable) -> RawLines:
    """Return lines without positions: columns of heights, or the rows of a matrix.

    The step is given by the user or by a remark.
    """
    columns = file.columns or table.numeric
    matrix = not file.columns and len(columns) > 1
    if matrix and any(title.name for title in table.titles):
        raise table.refused(
            f"holds {table.columns_text}, from 0: give those of heights, as surface.columns = [1]"
        )
    if matrix and len(table.blocks) > 1:
        line = table.lines[table.blocks[1].start]
        raise table.refused(
            f"another block begins at line {line}, as of a second channel: part the file there"
        )
    values = np.array([table.values(n) for n in columns])
    heights = values.T if matrix else values
    content = "a matrix of heights, a row for each line" if matrix else "heights alone"
    pitch, width, height = (
        stated_length(file, table, pattern)
        for pattern in (PITCH_REMARK, WIDTH_REMARK, HEIGHT_REMARK)
    )
    step = file.step or pitch or (width or 0.0) / heights.shape[1]
    if not step:
        raise table.refused(
            f"holds {content}, without positions: give surface.step, the distance of two samples "
            "along a line, in m"
        )
    description = f"{content}, step {'as given' if file.step else 'as the file says'}"
    spacing = height / len(heights) if matrix and height else None
    rows, samples = sorted(heights.shape)
    if matrix and spacing is None and rows > MIN_MAP_ROWS and samples <= MAX_MAP_ASPECT * rows:
        description += (
            '; if its rows are one step apart, scene.body = "half-space" reads them as a map'
        )
    units = ("", _unit(file, table, columns[0]) or stated_unit(table))
    return RawLines(heights, units, description, step=step, row_spacing=spacing)


def _is_matrix(file: LineFile, table: TextTable) -> bool:
    """Return whether a table without titles holds heights in every column."""
    few = len(table.numeric) < MIN_MATRIX_COLUMNS
    if file.columns or few or any(title.name for title in table.titles):
        return False
    if any(map(WIDTH_REMARK.fullmatch, remarks_of(table))):
        return True
    first = table.numeric[0]
    if len(table.numeric) == POINT_COLUMNS and repeats(table.values(first)):
        return False
    uniform = is_uniform(table.values(first), _precisions(table, first))
    return table.width >= MIN_SAMPLES and not uniform


def _columns_by_titles(file: LineFile, table: TextTable) -> tuple[int, ...]:
    """Return the columns of positions and heights, or x, y and z of a map, from the titles."""
    numeric = table.numeric
    if not table.titles:
        if len(numeric) >= POINT_COLUMNS and any(
            count_named(line, (POSITION_NAME, HEIGHT_NAME)) == 2 for line in table.above
        ):
            raise _unclear_columns(file, table)
        points = len(numeric) == POINT_COLUMNS and repeats(table.values(numeric[0]))
        return numeric[:POINT_COLUMNS] if points else numeric[:2]
    if any(table.title(n).name == UNREAD_NAME for n in numeric):
        raise _unclear_columns(file, table)
    candidates = [n for n in numeric if not _is_other_quantity(table.title(n))]
    lengths = [n for n in candidates if metres(table.title(n).unit) is not None]
    for group in (candidates, lengths):
        if len(group) == 2:
            one, two = group
            turned = _has_name(table, one, HEIGHT_NAME) and _has_name(table, two, POSITION_NAME)
            return (two, one) if turned else (one, two)
        names = [table.title(n).name.lower()[:1] for n in group]
        if sorted(names) == ["x", "y", "z"]:
            return tuple(group[names.index(name)] for name in "xyz")
        x = [n for n in group if _has_name(table, n, POSITION_NAME)]
        z = [n for n in group if _has_name(table, n, HEIGHT_NAME)]
        if len(x) == len(z) == 1 and x != z:
            return x[0], z[0]
    raise _unclear_columns(file, table)


def _unclear_columns(file: LineFile, table: TextTable) -> UserError:
    """Return the error for columns that the file does not determine, with example settings."""
    columns = list(table.numeric[:2])
    units = [table.title(n).unit for n in columns]
    if any(unit.startswith("1/") for unit in units):
        return table.refused(
            f"holds {table.columns_text}: a power spectrum, as its units state; give "
            f'surface.spectrum = {{file = "{file.name}", kind = "2D"}} in its place'
        )
    pairs = zip(units, ("mm", "um"), strict=True)
    units = [unit if metres(unit) else default for unit, default in pairs]
    return table.refused(
        f"holds {table.columns_text}, from 0: it is not clear which hold positions and heights; "
        f"give surface.columns and surface.units, as columns = {columns} and units = "
        f"{json.dumps(units)}, or surface.step in place of positions"
    )


def _has_name(table: TextTable, column: int, pattern: str) -> bool:
    return bool(re.search(pattern, table.title(column).name, re.IGNORECASE))


def _is_other_quantity(title: Title) -> bool:
    """Return whether a column holds an index, a time, or a quantity other than a length."""
    unit = unit_of(title.unit)
    if unit is not None and title.stated:
        return unit.family != "length"
    return (
        bool(re.search(f"{INDEX}|{TIME_NAME}", title.name, re.IGNORECASE))
        and metres(title.unit) is None
    )


def _unit(file: LineFile, table: TextTable, column: int) -> str:
    """Return the unit in the title of a column; "" without one.

    Raises UserError for a stated unit that is not a length, unless the user gives units.
    """
    title = table.title(column)
    if metres(title.unit) is not None or file.units or not title.unit:
        return title.unit
    if title.stated:
        known = unit_of(title.unit)
        raise table.refused(
            f"the unit {title.unit!r:.40} of column {_label(table, column)} is "
            + (
                "not a unit of length: give surface.columns"
                if known
                else "not known: give surface.units"
            )
        )
    return ""


def _label(table: TextTable, column: int) -> str:
    name = table.title(column).name
    return f"{column} {name}" if name else str(column)


def _precisions(table: TextTable, column: int) -> np.ndarray:
    """Return the precision of the written numbers of a column."""
    words = (word if is_numeral(word) else "0" for word in table.words(column))
    return precision(map(table.marks.plain, words))
