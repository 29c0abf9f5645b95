"""Figures of a study, drawn by a script from the opened result.

The default script is figure.py in the study's folder. Without a script, a study of a grid gets the
figure of ``usual_figure``.
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
from ..system import make_folder, write_durably
from . import usual_figure
from .panels import STYLE, HoverPoint, hover_points, plain_ticks

# Silenced because it warns about dates in some fonts, which do not matter here.
logging.getLogger("fontTools").setLevel(logging.ERROR)

Drawn = Figure | dict[str, Figure]  # several figures by name; the name of the first is ""


class Picture(NamedTuple):
    """A figure that was drawn: its files, caption and hover points."""

    png: Path
    pdf: Path
    points: list[HoverPoint]
    caption: str


def draw_figure(study: AnyStudy, result: Path, script: Path | None = None) -> list[Picture]:
    """Draw the study's figures as PNG and PDF in the folder of its result.

    script : replaces the study's figure.py. Raises UserError if the result or the script is
    missing, if the script cannot use the result, or if the disk refuses the files.
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

    The folder is created if missing.

    The file of figure NAME is the stem of ``path`` with the suffix -NAME, or the stem alone for "".
    The metadata of each file holds ``caption`` and the sentences set by ``write_below``.
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
                # Without a creation date, the same result gives the same file.
                files[pdf] = _rendered(figure, "pdf", {"Subject": words, "CreationDate": None})
                pictures.append(Picture(png, pdf, hover_points(figure), words))
        finally:
            plt.close("all")
    make_folder(path.parent)
    for file, content in files.items():
        write_durably(file, content)
    return pictures


def print_pictures(pictures: list[Picture]) -> None:
    """Print the paths of figures to stdout, and their captions to stderr."""
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
    """Return the module that draws. Raises UserError if it or its function draw is missing."""
    script = given or study.folder / "figure.py"
    if not script.is_file():
        if given is None and study.kind == "grid":
            return usual_figure
        raise UserError(f"{script}: not found; the study has no figure script")
    module = load_script(script)
    if getattr(module, "draw", None) is None:
        raise UserError(f"{script}: has no function draw(groups)")
    return module
