"""Run a measured study: measure, then write its result file durably."""

import os
import sys
from functools import partial
from pathlib import Path
from typing import NamedTuple

from ..plan import WHOLE, Pace, prediction
from ..result import origin, write_datasets
from ..store import enter_result
from ..study import THIS_MACHINE, Measured
from ..system import DiskRetry, Reporter, check_place, duration, import_dask, make_folder

Took = dict[tuple[str, str], float]  # (study, WHOLE) -> CPU seconds


class Done(NamedTuple):
    """What a measurement says, and what it took."""

    lines: list[str]
    spent: Took
    typical: Took  # what it takes on the typical machine


def run_measured(study: Measured, result: Path, pace: Pace) -> Done:
    """Measure, write the result file durably.

    An interrupted measurement writes nothing: an earlier result stays as it was.
    """
    import_dask()
    lines, typical = study.script.outline(study.settings)
    which = study.name, WHOLE
    seconds = prediction(pace, {which: typical}).seconds
    slower = seconds / typical  # than the typical machine
    print("\n".join(lines), file=sys.stderr)
    make_folder(result.parent)
    check_place(result)
    began = sum(os.times()[:4])
    with Reporter("measuring", seconds) as reporter:

        def advance(part: float) -> None:
            reporter.advance(slower * part)

        groups = study.script.measure(study.settings, study.seed, advance)
    used = sum(os.times()[:4]) - began  # of this process and of those it waited for
    origins = origin(study)
    marked = {name: data.assign_attrs(origins | data.attrs) for name, data in groups.items()}
    patience = DiskRetry(THIS_MACHINE.patience)
    patience(partial(write_datasets, result, marked))
    patience(partial(enter_result, result))
    summary = study.script.summary(groups) if hasattr(study.script, "summary") else []
    time_line = f"{duration(used)} of core time used, {duration(seconds)} predicted"
    return Done([*summary, time_line], {which: used}, {which: typical})
