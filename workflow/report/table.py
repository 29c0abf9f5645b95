"""Coefficient table of a result as CSV: one row per grid point, one column per estimate."""

import contextlib
from collections.abc import Callable
from pathlib import Path

import pandas as pd

from workflow.errors import UserError
from workflow.result import BROKEN, ROOT, Groups, broken, open_result
from workflow.study import AXES, AnyStudy, Measured, Study
from workflow.system import write_durably


def write_grid_table(study: Study, result: Path) -> Path:
    """Write NAME.csv beside a result file and return it; SI units, as in the netCDF file.

    Raises UserError where there is no result, or the disk refuses the table.
    """
    return _write(study, result, _estimates, "%.10g", index=True)


def write_measured_table(study: Measured, result: Path) -> Path:
    """Write NAME.csv, the table that measure.py makes, beside a result file and return it.

    Raises UserError where the study has no table, or as for a grid.
    """
    if not hasattr(study.script, "table"):
        raise UserError(f"study {study.name!r}: has no table")
    return _write(study, result, study.script.table, "%.4g", index=False)


def _estimates(groups: Groups) -> pd.DataFrame:
    root = groups[ROOT]
    columns = [name for name in root.data_vars if set(root[name].dims) == set(AXES)]
    return root[columns].to_dataframe(dim_order=list(AXES))


def _write(
    study: AnyStudy, result: Path, table: Callable[[Groups], pd.DataFrame], digits: str, index: bool
) -> Path:
    with contextlib.ExitStack() as stack:
        groups = open_result(study, result, stack)
        try:
            frame = table(groups)
        except BROKEN as error:
            raise broken(study, result, error) from error
    path = result.with_suffix(".csv")
    write_durably(path, frame.to_csv(index=index, float_format=digits).encode())
    return path
