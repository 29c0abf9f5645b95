"""What the commands do with each kind of study: one look-up, no case by case.

What is slow to import (workflow.report) is loaded by the command that needs it alone.
"""

from collections.abc import Callable
from typing import Any

from .. import report
from ..run import result_line, status_lines
from ..store import store_folder
from .outline import outline_grid, outline_measured
from .run import run_grid, run_measured_study

# Of each kind what `plan` and `status` print, as lines and as data for --json, what `run` does and
# returns as exit status, and what writes its `table`; each takes the study and its result file.
KINDS: dict[str, dict[str, Callable[..., Any]]] = {
    "grid": {
        "plan": outline_grid,
        "run": run_grid,
        "status": lambda study, result: status_lines(study, result, store_folder(result)),
        "table": lambda study, result: report.write_grid_table(study, result),
    },
    "measured": {
        "plan": outline_measured,
        "run": run_measured_study,
        "status": lambda study, result: ([result_line(result)], {"written": result.is_file()}),
        "table": lambda study, result: report.write_measured_table(study, result),
    },
}
