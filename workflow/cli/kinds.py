"""What the commands do with each kind of study: one look-up, no case by case.

What is slow to import (workflow.report) is loaded by the command that needs it alone.
"""

import argparse
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

from workflow import report
from workflow.cli.outline import outline_grid, outline_measured
from workflow.cli.run import run_grid, run_measured_study
from workflow.run import result_line, status_lines
from workflow.store import store_folder


class Kind(NamedTuple):
    """The commands of one kind of study; each takes the study and its result file."""

    plan: Callable[[Any, Path], list[str]]  # lines of the command
    run: Callable[[argparse.Namespace, Any, Path], int]  # exit status
    status: Callable[[Any, Path], list[str]]  # lines of the command
    table: Callable[[Any, Path], Path]  # writes it


KINDS = {
    "grid": Kind(
        outline_grid,
        run_grid,
        lambda study, result: status_lines(study, result, store_folder(result)),
        lambda study, result: report.write_grid_table(study, result),
    ),
    "measured": Kind(
        outline_measured,
        run_measured_study,
        lambda study, result: [result_line(result)],
        lambda study, result: report.write_measured_table(study, result),
    ),
}
