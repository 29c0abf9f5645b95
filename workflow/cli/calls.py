"""The commands plan, run and figure as Python functions, and the means of blocks."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

from .. import report
from ..ground import UserError
from ..result import open_tree, result_file
from ..study import AnyStudy, Measured, Study, read_study
from .command_line import MAX_FAILURES
from .commands import STUDY_ACTIONS
from .run_options import announced_plan

if TYPE_CHECKING:
    import xarray as xr


def plan_study(
    study: str | Path, *, scale: str | None = None, settings: list[str] | None = None
) -> dict[str, Any]:
    """Return what a run of a study would compute and cost, without a run.

    study : name under studies/, or path of a TOML file. scale : one of its [scales.NAME] tables.
    settings : overrides such as "grid.hurst=0.7".

    Returns the data of the command `plan STUDY --json`: numbers in SI units, times in s, memory in
    bytes. Raises UserError for invalid input.
    """
    checked, result = _study(study, scale, settings, "results")
    _, facts = STUDY_ACTIONS[checked.kind]["plan"](checked, result)
    return {"study": checked.name, "title": checked.title, "result": str(result), **facts}


def run_study(
    study: str | Path,
    *,
    scale: str | None = None,
    settings: list[str] | None = None,
    out: str | Path = "results",
    workers: int | None = None,
) -> "xr.Dataset":
    """Compute what is missing of a study, write its result file and return the dataset.

    Progress goes to the standard error stream. After an interruption, which raises
    KeyboardInterrupt, the same call continues with all finished work. A script calls it below
    ``if __name__ == "__main__":``, because worker processes import the script.

    study, scale, settings : as for ``plan``. out : folder of results, or path of the .nc file.
    workers : number of local processes; None: one per core, or none for short work.

    Returns the study without its comparisons, which ``open`` gives too. Raises UserError for
    invalid input, and if more than ten problems fail.
    """
    from ..run import RunOptions, run_measured, run_plan

    checked, result = _study(study, scale, settings, out)
    if isinstance(checked, Measured):
        run_measured(checked, result)
    elif isinstance(checked, Study):
        options = RunOptions(checked.cluster, workers, max_failures=MAX_FAILURES)
        summary = run_plan(announced_plan(checked), result, options)
        if summary.interrupted:
            raise KeyboardInterrupt(f"{result}: finished work is kept; call run again to resume")
        if not summary.written:
            problem = f"{result}: more than {MAX_FAILURES} problems failed"
            raise UserError(problem, *summary.failures)
    return open_tree(result).to_dataset()


def draw_study(
    study: str | Path,
    *,
    scale: str | None = None,
    settings: list[str] | None = None,
    out: str | Path = "results",
) -> Path:
    """Draw the figure of a finished run as PNG and PDF; return the path of the PNG file.

    study, scale, settings, out : as for ``run``. If a study has several figures, the path is that
    of the first. Raises UserError if the result is missing or the disk refuses the files.
    """
    return report.draw_figure(*_study(study, scale, settings, out))[0].png


def read_block_means(
    study: str | Path,
    *,
    scale: str | None = None,
    settings: list[str] | None = None,
    out: str | Path = "results",
    group: str = "",
) -> "xr.Dataset":
    """Return the block means of a finished run, for a reduction that the program does not make.

    A block is the mean over ``attrs["realizations_per_block"]`` lines. Blocks are independent and
    of equal size: the mean along the dimension ``block`` is the mean of the result. Fitted values
    are those of the curve of one block. NaN beyond the last block of a point.

    study, scale, settings, out : as for ``run``. group : name of a comparison.

    Raises UserError if the result or a block is missing.
    """
    from ..run import block_dataset

    checked, result = _study(study, scale, settings, out)
    if not isinstance(checked, Study):
        raise UserError(f"{checked.name}: its measure.py computes it, without blocks")
    return block_dataset(checked, result, group)


def _study(
    study: str | Path, scale: str | None, settings: list[str] | None, out: str | Path
) -> tuple[AnyStudy, Path]:
    """Return the checked study and the path of its result."""
    checked = read_study(str(study), scale, settings)
    return checked, result_file(Path(out), checked)
