"""Coefficient table of a result as CSV: one row per grid point, one column per estimate."""

from pathlib import Path

import xarray as xr

from workflow.durable import write_durably
from workflow.errors import UserError
from workflow.study import AXES


def write_table(result: Path) -> Path:
    """Write NAME.csv beside a result file and return it; SI units, as in the netCDF file.

    Raises UserError where there is no result.
    """
    if not result.is_file():
        raise UserError(f"{result}: not found; run the study first")
    with xr.open_dataset(result) as dataset:
        columns = [name for name in dataset.data_vars if set(dataset[name].dims) == set(AXES)]
        frame = dataset[columns].to_dataframe(dim_order=list(AXES))
    table = result.with_suffix(".csv")
    write_durably(table, frame.to_csv(float_format="%.10g").encode())
    return table
