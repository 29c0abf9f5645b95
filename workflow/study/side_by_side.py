"""Sweeps that stand side by side in a table, over one column of frequencies or times.

Example: columns w, G', G'', G', G'' under a line with 20 °C and 40 °C above the moduli.
"""

from collections.abc import Sequence

from ..text_tables import TextTable, is_numeral, split, unit_of
from .columns import ColumnSpec
from .sweeps import temperature_in


def below_one_another(
    table: TextTable, over: ColumnSpec, wanted: Sequence[ColumnSpec], given: Sequence[float]
) -> TextTable:
    """Return a table with one block per sweep, or the same table without sweeps side by side.

    over : quantity of the common column. wanted : quantities of each sweep. given : temperatures of
    the sweeps. Raises UserError for sweeps of other units, and for sweeps without temperatures.
    """
    named = {n: table.title(n) for n in table.numeric}
    common = [n for n in named if over.fits_name(named[n])]
    columns = [[n for n in named if spec.fits_name(named[n])] for spec in wanted]
    sweeps = list(zip(*columns, strict=False))
    flat = [n for sweep in sweeps for n in sweep]
    uneven = len({len(one) for one in columns}) > 1
    if len(common) != 1 or len(sweeps) < 2 or uneven or flat != sorted(flat):
        return table
    for sweep in sweeps:
        if [unit_of(named[n].unit) for n in sweep] != [unit_of(named[n].unit) for n in sweeps[0]]:
            raise table.refused(
                "sweeps side by side are in several units: give the columns of one with --columns "
                f"{','.join(map(str, common + list(sweep)))}"
            )
    heads = [_head(table, common[0], sweep[0], sweeps[0][0]) for sweep in sweeps]
    if not given and any(temperature_in([head]) is None for head in heads):
        one = ",".join(map(str, common + list(sweeps[0])))
        raise table.refused(
            f"holds {len(sweeps)} sweeps side by side: give --temperatures, one for each in order, "
            f"or the columns of one with --columns {one}"
        )
    return _unfolded(table, [common + list(sweep) for sweep in sweeps], heads)


def _head(table: TextTable, common: int, column: int, first: int) -> str:
    """Return what stands above a sweep in the lines of cells, with the unit of their first cell."""
    heads = []
    for line in table.above:
        cells = split(line, table.delimiter)
        if len(cells) > column:
            label = cells[common] if common < first and is_numeral(cells[column]) else ""
            heads.append(f"{cells[column]} {'°C' if '°C' in label else ''}")
    return " ".join(heads)


def _unfolded(table: TextTable, sweeps: Sequence[Sequence[int]], heads: Sequence[str]) -> TextTable:
    """Return the table in which each sweep is a block below its head."""
    rows = [table.row(n) for n in range(len(table.lines))]
    blocks = ["\n".join("\t".join(row[n] for n in sweep) for row in rows) for sweep in sweeps]
    text = "\n".join(f"# {head}\n{block}" for head, block in zip(heads, blocks, strict=True))
    unfolded = TextTable(table.key, table.name, text)
    if len(unfolded.lines) == len(sweeps) * len(rows):
        unfolded.lines = table.lines * len(sweeps)
    unfolded.marks = table.marks
    unfolded.titles = tuple(table.title(n) for n in sweeps[0])
    unfolded.above, unfolded.unread = (*table.above, heads[0]), table.unread
    return unfolded
