"""CSV tables of a result: a row per grid point and variant, a column per estimate."""

import contextlib
from pathlib import Path

import pandas as pd

from ..ground import UserError
from ..result import BROKEN, ROOT, Groups, broken, open_result
from ..study import AnyStudy, Measured, Study
from ..system import write_durably

VARIANT_COLUMN = "variant"
STUDY_VARIANT = "study"  # value of VARIANT_COLUMN for the study itself, not a comparison
COLUMN_TABLE = "columns"  # label of the table with the units and meanings of all columns

Tables = dict[str, pd.DataFrame]  # by label: "" for NAME.csv, others for NAME-LABEL.csv


def write_table(study: AnyStudy, result: Path) -> list[Path]:
    """Write the tables of a result to its folder, in SI units, and return their paths.

    For a grid, NAME.csv holds the estimates at each point, NAME-exponents.csv the fitted exponents
    for each Hurst exponent, if any, and NAME-columns.csv the unit and meaning of every column. For
    a measured study, NAME.csv is the table made by its script. Raises UserError if the result is
    missing, if the study has no table, or if the disk refuses a file.
    """
    if isinstance(study, Measured) and not hasattr(study.script, "table"):
        raise UserError(f"study {study.name!r}: has no table")
    with contextlib.ExitStack() as stack:
        return write_tables(study, open_result(study, result, stack), result)


def write_tables(study: AnyStudy, groups: Groups, result: Path) -> list[Path]:
    """Write the tables of an opened result; a measured study may have none."""
    try:
        tables: Tables = {}
        if isinstance(study, Study):
            both = {"": _rows(groups, study.axes), "exponents": _rows(groups, ("hurst",))}
            tables = {label: frame for label, frame in both.items() if frame.columns.size}
            tables[COLUMN_TABLE] = _meanings(groups, tables)
        elif isinstance(study, Measured) and hasattr(study.script, "table"):
            frame = study.script.table(groups)
            tables[""] = frame.set_index(frame.columns[0])
    except BROKEN as error:
        raise broken(study, result, error) from error
    paths = []
    for label, frame in tables.items():
        paths.append(result.with_name(f"{result.stem}{'-' if label else ''}{label}.csv"))
        digits = "%.10g" if isinstance(study, Study) else "%.4g"
        write_durably(paths[-1], frame.to_csv(float_format=digits).encode())
    return paths


def _rows(groups: Groups, axes: tuple[str, ...]) -> pd.DataFrame:
    """Return the variables whose dimensions are exactly ``axes``: a row per point and variant."""
    frames = {}
    for label, data in groups.items():
        names = [name for name in data.data_vars if set(data[name].dims) == set(axes)]
        if names:
            frames[label or STUDY_VARIANT] = data[names].to_dataframe(dim_order=list(axes))
    return pd.concat(frames, names=[VARIANT_COLUMN]) if frames else pd.DataFrame()


def _meanings(groups: Groups, tables: Tables) -> pd.DataFrame:
    """Return a table with the unit and meaning of every column of ``tables``."""
    meanings = {
        VARIANT_COLUMN: ("", f"{STUDY_VARIANT}: the study itself; else the name of a comparison")
    }
    for data in (*groups.values(), groups[ROOT]):
        for name in data.variables:
            attributes = data[name].attrs
            meanings[str(name)] = (attributes.get("units", ""), attributes.get("long_name", ""))
    used = {str(name) for table in tables.values() for name in (*table.index.names, *table.columns)}
    rows = [(name, *meaning) for name, meaning in meanings.items() if name in used]
    return pd.DataFrame(rows, columns=["column", "unit", "meaning"]).set_index("column")
