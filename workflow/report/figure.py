"""Draw the figures of a study: a script is handed the opened result and draws.

It is the figure.py of the study's folder, or one that was asked for; without either, every grid
has a usual figure.
"""

import contextlib
import inspect
import io
from collections.abc import Callable
from pathlib import Path
from typing import Any, cast

import matplotlib as mpl
from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from workflow.errors import UserError
from workflow.report import usual_figure
from workflow.report.drawing import STYLE
from workflow.result import BROKEN, Groups, broken, open_result
from workflow.study import AnyStudy, load_script
from workflow.system import write_durably

Drawn = Figure | dict[str, Figure]  # several: "" is the first, the others go by their names


def draw_figure(study: AnyStudy, result: Path, script: Path | None = None) -> list[Path]:
    """Draw the study's figures beside its result, as PNG and PDF; return the files.

    script : draws instead of the study's own. Raises UserError where there is no result, a study
    that is no grid has no figure script, the script cannot use the result, or the disk refuses
    the files.
    """
    with contextlib.ExitStack() as stack:
        return draw_groups(study, open_result(study, result, stack), result, script)


def draw_groups(
    study: AnyStudy, groups: Groups, result: Path, script: Path | None = None
) -> list[Path]:
    """Draw the study's figures from its opened result; as ``draw_figure``."""
    draw = _script(study, script)
    try:
        return write_figure(lambda: draw(groups), result)
    except BROKEN as error:
        raise broken(study, result, error) from error


def write_figure(draw: Callable[[], Drawn], path: Path) -> list[Path]:
    """Draw in the style of the project, and write PNG and PDF beside ``path``; return the files.

    Of several figures "" goes to the name of ``path``, and NAME to that with -NAME behind it.
    """
    files: dict[Path, bytes] = {}
    with mpl.rc_context(cast(Any, STYLE)):
        try:
            drawn = draw()
            figures = drawn if isinstance(drawn, dict) else {"": drawn}
            for name, figure in figures.items():
                stem = path.with_name(f"{path.stem}-{name}.png" if name else f"{path.stem}.png")
                files |= _rendered(figure, stem)
        finally:
            plt.close("all")
    for file, content in files.items():
        write_durably(file, content)
    return list(files)


def _rendered(figure: Figure, path: Path) -> dict[Path, bytes]:
    files = {}
    for kind in ("png", "pdf"):
        # No creation date: the same result gives the same file.
        stamp = {"CreationDate": None} if kind == "pdf" else {}
        content = io.BytesIO()
        figure.savefig(content, format=kind, metadata=stamp)
        figure.set_layout_engine("none")  # laid out once: alike in both, and quicker
        files[path.with_suffix(f".{kind}")] = content.getvalue()
    return files


def _script(study: AnyStudy, asked: Path | None) -> Callable[[Groups], Drawn]:
    """Return the function that draws. Raises UserError where there is none, or one of old."""
    script = asked or study.folder / "figure.py"
    if not script.is_file():
        if asked is None and study.kind == "grid":
            return usual_figure.draw
        raise UserError(f"{script}: not found; the study has no figure script")
    draw = getattr(load_script(script), "draw", None)
    if draw is None:
        raise UserError(f"{script}: has no function draw(groups)")
    if [*inspect.signature(draw).parameters][:1] != ["groups"]:
        raise UserError(
            f"{script}: draw takes the path of a result; write draw(groups) instead, which is "
            'handed the opened datasets: groups[""] is the study, groups["NAME"] a comparison'
        )
    return draw
