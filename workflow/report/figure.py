"""Draw the figures of a study: a script is handed the opened result and draws.

It is the figure.py of the study's folder, or one that was asked for; without either, every grid
has a usual figure.
"""

import contextlib
import io
import logging
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple, cast

import matplotlib as mpl
from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from ..errors import UserError
from ..result import BROKEN, Groups, broken, open_result
from ..study import AnyStudy, load_script
from ..system import write_durably
from . import usual_figure
from .panels import STYLE, HoverPoint, remembered

# It takes the dates of some fonts for wrong, which a reader of a figure need not know.
logging.getLogger("fontTools").setLevel(logging.ERROR)

Drawn = Figure | dict[str, Figure]  # several: "" is the first, the others go by their names


class Picture(NamedTuple):
    """A figure that was drawn: its files, and its points with what is to be said of them."""

    png: Path
    pdf: Path
    points: list[HoverPoint]


def draw_figure(study: AnyStudy, result: Path, script: Path | None = None) -> list[Path]:
    """Draw the study's figures beside its result, as PNG and PDF; return the files.

    script : draws instead of the study's own. Raises UserError where there is no result, a study
    that is no grid has no figure script, the script cannot use the result, or the disk refuses
    the files.
    """
    with contextlib.ExitStack() as stack:
        drawn = draw_groups(study, open_result(study, result, stack), result, script)
        return [file for picture in drawn for file in (picture.png, picture.pdf)]


def draw_groups(
    study: AnyStudy, groups: Groups, result: Path, script: Path | None = None
) -> list[Picture]:
    """Draw the study's figures from its opened result; as ``draw_figure``."""
    draw = _script(study, script)
    try:
        return draw_pictures(lambda: draw(groups), result)
    except BROKEN as error:
        raise broken(study, result, error) from error


def write_figure(draw: Callable[[], Drawn], path: Path) -> list[Path]:
    """Draw in the style of the project, and write PNG and PDF beside ``path``; return the files.

    Of several figures "" goes to the name of ``path``, and NAME to that with -NAME behind it.
    """
    return [file for picture in draw_pictures(draw, path) for file in (picture.png, picture.pdf)]


def draw_pictures(draw: Callable[[], Drawn], path: Path) -> list[Picture]:
    """Draw and write as ``write_figure``; return the pictures."""
    pictures, files = [], {}
    with mpl.rc_context(cast(Any, STYLE)):
        try:
            drawn = draw()
            figures = drawn if isinstance(drawn, dict) else {"": drawn}
            for name, figure in figures.items():
                stem = f"{path.stem}-{name}" if name else path.stem
                png, pdf = (path.with_name(f"{stem}.{kind}") for kind in ("png", "pdf"))
                files[png], files[pdf] = _rendered(figure, "png"), _rendered(figure, "pdf")
                pictures.append(Picture(png, pdf, remembered(figure)))
        finally:
            plt.close("all")
    for file, content in files.items():
        write_durably(file, content)
    return pictures


def caption(study: AnyStudy) -> str:
    """Return what CAPTION of the script that draws a study says of its figures, "" without one."""
    script = study.folder / "figure.py"
    return getattr(load_script(script) if script.is_file() else usual_figure, "CAPTION", "")


def _rendered(figure: Figure, kind: str) -> bytes:
    # No creation date: the same result gives the same file.
    stamp = {"CreationDate": None} if kind == "pdf" else {}
    content = io.BytesIO()
    figure.savefig(content, format=kind, metadata=stamp)
    figure.set_layout_engine("none")  # laid out once: alike in both, and quicker
    return content.getvalue()


def _script(study: AnyStudy, asked: Path | None) -> Callable[[Groups], Drawn]:
    """Return the function that draws. Raises UserError where there is none."""
    script = asked or study.folder / "figure.py"
    if not script.is_file():
        if asked is None and study.kind == "grid":
            return usual_figure.draw
        raise UserError(f"{script}: not found; the study has no figure script")
    draw = getattr(load_script(script), "draw", None)
    if draw is None:
        raise UserError(f"{script}: has no function draw(groups)")
    return draw
