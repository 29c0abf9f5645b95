"""The commands plan, run, figure and prony as Python functions, and the means of blocks."""

import tomllib
from argparse import Namespace
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .. import report
from ..ground import UserError
from ..result import open_tree, result_file
from ..study import INCOMPRESSIBLE, AnyStudy, Measured, Study, read_study
from .command_line import MAX_FAILURES
from .commands import STUDY_ACTIONS
from .experiments import material_table
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


class FittedMaterial(dict[str, Any]):
    """Keys of the table [material], fitted to measured moduli; ``print`` shows the fit as TOML.

    residual : rms of the relative residual of G*. worst : its largest value.
    """

    def __init__(self, text: str, residual: float, worst: float) -> None:
        super().__init__(tomllib.loads(text)["material"])
        self.text, self.residual, self.worst = text, residual, worst

    def __str__(self) -> str:
        """Return the output of the command ``prony``."""
        return self.text


def fit_moduli(
    file: str | Path,
    *,
    columns: Sequence[int] | None = None,
    temperatures: Sequence[float] | None = None,
    reference: float | None = None,
    law: str | None = None,
    vertical: bool = False,
    start: float | None = None,
    frequency: str | None = None,
    modulus: str | None = None,
    poisson: float = INCOMPRESSIBLE,
    branches: int | None = None,
    figure: str | Path | None = None,
) -> FittedMaterial:
    """Fit a Prony series to measured moduli; return a material for ``scene.run``, a dictionary.

    Printed it is the output of the command ``prony``; its ``residual`` and ``worst`` are the rms
    and the largest residual of G*, relative.

    file, columns, temperatures, reference, law, vertical, frequency, modulus, poisson, branches,
    figure : as the options of the command. start : its option --from, in s.

    Raises UserError for invalid input, and for moduli that no Prony series describes.
    """
    given = {
        name: None if v is None else ",".join(map(str, v))
        for name, v in {"columns": columns, "temperatures": temperatures}.items()
    }
    table = material_table(
        Namespace(
            file=str(file),
            reference=reference,
            law=law,
            vertical=vertical,
            start=start,
            frequency=frequency,
            modulus=modulus,
            poisson=poisson,
            branches=branches,
            figure=figure,
            **given,
        )
    )
    text = "\n".join([*table.comments, "[material]", *table.keys, *table.listed()])
    return FittedMaterial(text, table.fit.rms, table.fit.worst)


def _study(
    study: str | Path, scale: str | None, settings: list[str] | None, out: str | Path
) -> tuple[AnyStudy, Path]:
    """Return the checked study and the path of its result."""
    checked = read_study(str(study), scale, settings)
    return checked, result_file(Path(out), checked)
