"""What the commands do with each kind of study: one look-up, no case by case."""

import argparse
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

from workflow.cli.outline import outline_grid, outline_measured
from workflow.cli.run import run_grid, run_measured_study
from workflow.run import result_line, status_lines
from workflow.store import store_folder
from workflow.study import Measured, Study


class Kind(NamedTuple):
    """The commands of one kind of study; each takes the study and its result file."""

    outline: Callable[[Any, Path], list[str]]  # lines of `plan`
    run: Callable[[argparse.Namespace, Any, Path], int]  # exit status
    status: Callable[[Any, Path], list[str]]  # lines of `status`
    table: Callable[[Any, Path], Path]  # writes it


def _grid_status(study: Study, result: Path) -> list[str]:
    return status_lines(study, result, store_folder(result))


def _measured_status(study: Measured, result: Path) -> list[str]:
    del study
    return [result_line(result)]


def _grid_table(study: Study, result: Path) -> Path:
    from workflow.report import write_grid_table

    return write_grid_table(study, result)


def _measured_table(study: Measured, result: Path) -> Path:
    from workflow.report import write_measured_table

    return write_measured_table(study, result)


KINDS = {
    "grid": Kind(outline_grid, run_grid, _grid_status, _grid_table),
    "measured": Kind(outline_measured, run_measured_study, _measured_status, _measured_table),
}
