"""Draw the figures of a study: a script is handed the opened result and draws.

It is the figure.py of the study's folder, or one that was asked for; without either, every grid
has a usual figure.
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
from .panels import STYLE, HoverPoint, plain_ticks, remembered

# It takes the dates of some fonts for wrong, which a reader of a figure need not know.
logging.getLogger("fontTools").setLevel(logging.ERROR)

Drawn = Figure | dict[str, Figure]  # several: "" is the first, the others go by their names


class Picture(NamedTuple):
    """A figure that was drawn: its files, caption, and points with what is to be said of them."""

    png: Path
    pdf: Path
    points: list[HoverPoint]
    caption: str


def draw_figure(study: AnyStudy, result: Path, script: Path | None = None) -> list[Picture]:
    """Draw the study's figures beside its result, as PNG and PDF.

    script : draws instead of the study's own. Raises UserError where there is no result, a study
    that is no grid has no figure script, the script cannot use the result, or the disk refuses
    the files.
    """
    with contextlib.ExitStack() as stack:
        return draw_groups(study, open_result(study, result, stack), result, script)


def draw_groups(
    study: AnyStudy, groups: Groups, result: Path, script: Path | None = None
) -> list[Picture]:
    """Draw the study's figures from its opened result; as ``draw_figure``."""
    drawing = _script(study, script)
    try:
        return write_figure(lambda: drawing.draw(groups), result, getattr(drawing, "CAPTION", ""))
    except BROKEN as error:
        raise broken(study, result, error) from error


def write_figure(draw: Callable[[], Drawn], path: Path, caption: str = "") -> list[Picture]:
    """Draw in the style of the project, and write PNG and PDF beside ``path``.

    Of several figures "" goes to the name of ``path``, and NAME to that with -NAME behind it. The
    properties of a file hold its caption: ``caption``, and what the figure adds to it.
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
                pictures.append(Picture(png, pdf, remembered(figure), words))
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
    figure.set_layout_engine("none")  # laid out once: alike in both, and quicker
    return content.getvalue()


def _script(study: AnyStudy, asked: Path | None) -> Any:
    """Return the module that draws. Raises UserError where there is none."""
    script = asked or study.folder / "figure.py"
    if not script.is_file():
        if asked is None and study.kind == "grid":
            return usual_figure
        raise UserError(f"{script}: not found; the study has no figure script")
    found = load_script(script)
    if getattr(found, "draw", None) is None:
        raise UserError(f"{script}: has no function draw(groups)")
    return found
