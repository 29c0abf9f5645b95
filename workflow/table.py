"""Coefficient table of a result as CSV: one row per grid point, one column per estimate."""

import contextlib
from pathlib import Path

from workflow.durable import write_durably
from workflow.results import BROKEN, ROOT, broken, open_result
from workflow.study import AXES, Study


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
