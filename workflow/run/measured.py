"""Run a measured study: measure, then write its result file durably."""

import os
import sys
from functools import partial
from pathlib import Path

from workflow.result import origin, write_datasets
from workflow.study import HERE, Measured
from workflow.system import Patience, Reporter, check_place, duration, make_folder


def run_measured(study: Measured, result: Path) -> str:
    """Measure, write the result file durably; return what to print: a summary and the time.

    An interrupted measurement writes nothing: an earlier result stays as it was.
    """
    lines, seconds = study.script.outline(study.settings)
    print("\n".join(lines), file=sys.stderr)
    make_folder(result.parent)
    check_place(result)
    began = sum(os.times()[:4])
    with Reporter("measuring", seconds) as reporter:
        groups = study.script.measure(study.settings, study.seed, reporter.advance)
    used = sum(os.times()[:4]) - began  # of this process and of those it waited for
    origins = origin(study)
    marked = {name: data.assign_attrs(origins | data.attrs) for name, data in groups.items()}
    Patience(HERE.patience)(partial(write_datasets, result, marked))
    summary = study.script.summary(groups) if hasattr(study.script, "summary") else []
    time_line = f"{duration(used)} of core time used, {duration(seconds)} predicted"
    return "\n".join([*summary, time_line])
