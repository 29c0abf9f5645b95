"""Coefficient table of a result as CSV: one row per grid point, one column per estimate."""

import contextlib
from pathlib import Path

from workflow.errors import UserError
from workflow.result.netcdf import BROKEN, ROOT, broken, open_result
from workflow.study.grid import AXES
from workflow.study.measured import Measured
from workflow.study.study import Study
from workflow.system.files import write_durably


def write_table(study: Study, result: Path) -> Path:
    """Write NAME.csv beside a result file and return it; SI units, as in the netCDF file.

    Raises UserError where there is no result, or the disk refuses the table.
    """
    with contextlib.ExitStack() as stack:
        dataset = open_result(study, result, stack)[ROOT]
        columns = [name for name in dataset.data_vars if set(dataset[name].dims) == set(AXES)]
        try:
            frame = dataset[columns].to_dataframe(dim_order=list(AXES))
        except BROKEN as error:
            raise broken(study, result, error) from error
    table = result.with_suffix(".csv")
    write_durably(table, frame.to_csv(float_format="%.10g").encode())
    return table


def write_measured_table(study: Measured, result: Path) -> Path:
    """Write NAME.csv beside a result file and return it."""
    if not hasattr(study.script, "table"):
        raise UserError(f"study {study.name!r}: has no table")
    from workflow.result.netcdf import BROKEN, broken

    path = result.with_suffix(".csv")
    try:
        frame = study.script.table(result)
    except BROKEN as error:
        raise broken(study, result, error) from error
    write_durably(path, frame.to_csv(index=False, float_format="%.4g").encode())
    return path
