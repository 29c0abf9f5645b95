"""Figures of a study, drawn by a script from the opened result.

The script is the one given, or figure.py in the study's folder; the fallback for a grid is the
default figure.
"""

import contextlib
import io
import logging
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple, cast

import matplotlib as mpl
from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from ..ground import UserError
from ..result import BROKEN, Groups, broken, open_result
from ..study import AnyStudy, load_script
from ..system import write_durably
from . import usual_figure
from .panels import STYLE, HoverPoint, hover_points, plain_ticks

# It warns about dates in some fonts, which do not concern the reader of a figure.
logging.getLogger("fontTools").setLevel(logging.ERROR)

Drawn = Figure | dict[str, Figure]  # of several figures the first has the key ""


class Picture(NamedTuple):
    """A drawn figure: its files, caption and hover points."""

    png: Path
    pdf: Path
    points: list[HoverPoint]
    caption: str


def draw_figure(study: AnyStudy, result: Path, script: Path | None = None) -> list[Picture]:
    """Draw the study's figures as PNG and PDF in the folder of its result.

    script : used instead of the study's figure.py. Raises UserError if the result is missing, if
    a study that is not a grid has no script, if the script cannot use the result, or if the disk
    refuses the files.
    """
    with contextlib.ExitStack() as stack:
        return draw_groups(study, open_result(study, result, stack), result, script)


def draw_groups(
    study: AnyStudy, groups: Groups, result: Path, script: Path | None = None
) -> list[Picture]:
    """Draw the study's figures from its opened result; see ``draw_figure``."""
    drawing = _script(study, script)
    try:
        return write_figure(lambda: drawing.draw(groups), result, getattr(drawing, "CAPTION", ""))
    except BROKEN as error:
        raise broken(study, result, error) from error


def write_figure(draw: Callable[[], Drawn], path: Path, caption: str = "") -> list[Picture]:
    """Draw in the style of the project, and write PNG and PDF to the folder of ``path``.

    The figure with the key "" has the stem of ``path``; figure NAME has the suffix -NAME. The
    metadata of each file holds ``caption`` and the sentences that the figure adds.
    """
    pictures, files = [], {}
    with mpl.rc_context(cast(Any, STYLE)):
        try:
            drawn = draw()
            figures = drawn if isinstance(drawn, dict) else {"": drawn}
            for name, figure in figures.items():
                plain_ticks(figure)
                stem = f"{path.stem}-{name}" if name else path.stem
                png, pdf = (path.with_name(f"{stem}.{kind}") for kind in ("png", "pdf"))
                words = f"{caption} {figure.get_label()}".strip()
                files[png] = _rendered(figure, "png", {"Description": words})
                # No creation date: the same result gives the same file.
                files[pdf] = _rendered(figure, "pdf", {"Subject": words, "CreationDate": None})
                pictures.append(Picture(png, pdf, hover_points(figure), words))
        finally:
            plt.close("all")
    for file, content in files.items():
        write_durably(file, content)
    return pictures


def print_pictures(pictures: list[Picture]) -> None:
    """Print the files of figures, and their captions to standard error."""
    for picture in pictures:
        print(picture.png, picture.pdf, sep="\n")
        if picture.caption:
            print(f"caption: {picture.caption}", file=sys.stderr)


def _rendered(figure: Figure, kind: str, stamp: dict[str, str | None]) -> bytes:
    content = io.BytesIO()
    figure.savefig(content, format=kind, metadata=stamp)
    figure.set_layout_engine("none")  # the layout of the PNG serves the PDF too
    return content.getvalue()


def _script(study: AnyStudy, given: Path | None) -> Any:
    """Return the module that draws. Raises UserError if it is missing."""
    script = given or study.folder / "figure.py"
    if not script.is_file():
        if given is None and study.kind == "grid":
            return usual_figure
        raise UserError(f"{script}: not found; the study has no figure script")
    module = load_script(script)
    if getattr(module, "draw", None) is None:
        raise UserError(f"{script}: has no function draw(groups)")
    return module
