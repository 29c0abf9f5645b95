"""Run of a measured study: measure, then write the result file durably."""

import os
import sys
from functools import partial
from pathlib import Path

from ..result import origin, write_datasets
from ..store import enter_result
from ..study import THIS_MACHINE, Measured
from ..system import DiskRetry, Reporter, check_place, duration, import_dask, make_folder
from .status import check_owner


def run_measured(study: Measured, result: Path) -> list[str]:
    """Measure, and write the result file durably; return the lines to print.

    An interrupted measurement writes nothing, so that an earlier result stays unchanged.
    """
    import_dask()
    lines, seconds = study.script.outline(study.settings)
    print("\n".join(lines), file=sys.stderr)
    make_folder(result.parent)
    check_place(result)
    check_owner(study, result)
    began = sum(os.times()[:4])
    with Reporter("measuring", seconds) as reporter:
        groups = study.script.measure(study.settings, study.seed, reporter.advance)
    used = sum(os.times()[:4]) - began  # CPU time of this process and its finished children
    origins = origin(study)
    marked = {name: data.assign_attrs(origins | data.attrs) for name, data in groups.items()}
    patience = DiskRetry(THIS_MACHINE.patience)
    patience(partial(write_datasets, result, marked))
    patience(partial(enter_result, result))
    summary = study.script.summary(groups) if hasattr(study.script, "summary") else []
    time_line = f"{duration(used)} of core time used, {duration(seconds)} predicted"
    return [*summary, time_line]
