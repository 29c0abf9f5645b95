"""Coefficients of a result as CSV: a row per grid point and variant, a column per estimate."""

import contextlib
from pathlib import Path

import pandas as pd

from ..ground import UserError
from ..result import BROKEN, ROOT, Groups, broken, open_result
from ..study import AnyStudy, Measured, Study
from ..system import write_durably

VARIANT = "variant"  # column: a comparison, or
OWN = "study"  # the study itself
COLUMNS = "columns"  # table of what the columns of the others are

Tables = dict[str, pd.DataFrame]  # "" is NAME.csv, the others are NAME-LABEL.csv


def write_table(study: AnyStudy, result: Path) -> list[Path]:
    """Write the tables of a result beside it and return them; SI units, as in the netCDF file.

    Of a grid NAME.csv has all that is known of each point, NAME-exponents.csv the exponents of each
    Hurst exponent, if any, and NAME-columns.csv unit and meaning of every column. Of a measured
    study NAME.csv is the table that measure.py makes. Raises UserError where there is no result,
    where the study has no table, or the disk refuses one.
    """
    if isinstance(study, Measured) and not hasattr(study.script, "table"):
        raise UserError(f"study {study.name!r}: has no table")
    with contextlib.ExitStack() as stack:
        return write_tables(study, open_result(study, result, stack), result)


def write_tables(study: AnyStudy, groups: Groups, result: Path) -> list[Path]:
    """Write the tables of an opened result; none of a measured study that makes no table."""
    try:
        found: Tables = {}
        if isinstance(study, Study):
            both = {"": _rows(groups, study.axes), "exponents": _rows(groups, ("hurst",))}
            found = {label: frame for label, frame in both.items() if frame.columns.size}
            found[COLUMNS] = _meanings(groups, found)
        elif isinstance(study, Measured) and hasattr(study.script, "table"):
            frame = study.script.table(groups)
            found[""] = frame.set_index(frame.columns[0])
    except BROKEN as error:
        raise broken(study, result, error) from error
    paths = []
    for label, frame in found.items():
        paths.append(result.with_name(f"{result.stem}{'-' if label else ''}{label}.csv"))
        digits = "%.10g" if isinstance(study, Study) else "%.4g"
        write_durably(paths[-1], frame.to_csv(float_format=digits).encode())
    return paths


def _rows(groups: Groups, axes: tuple[str, ...]) -> pd.DataFrame:
    """Return what depends on exactly these axes, a row for each of their values and variant."""
    frames = {}
    for label, data in groups.items():
        names = [name for name in data.data_vars if set(data[name].dims) == set(axes)]
        frames[label or OWN] = data[names].to_dataframe(dim_order=list(axes)) if names else None
    there = {label: frame for label, frame in frames.items() if frame is not None}
    return pd.concat(there, names=[VARIANT]) if there else pd.DataFrame()


def _meanings(groups: Groups, tables: Tables) -> pd.DataFrame:
    """Return unit and meaning of every column of some tables."""
    found = {VARIANT: ("", f"{OWN}: the study itself; else the name of a comparison")}
    for data in (*groups.values(), groups[ROOT]):
        for name in data.variables:
            told = data[name].attrs
            found[str(name)] = (told.get("units", ""), told.get("long_name", ""))
    used = {str(name) for each in tables.values() for name in (*each.index.names, *each.columns)}
    rows = [(name, *said) for name, said in found.items() if name in used]
    return pd.DataFrame(rows, columns=["column", "unit", "meaning"]).set_index("column")
