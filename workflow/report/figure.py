"""Draw the figure of a study: its folder's figure.py is handed the opened result and draws."""

import contextlib
import inspect
import io
import textwrap
from collections.abc import Callable
from pathlib import Path
from typing import Any, cast

import matplotlib as mpl
import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from workflow.errors import UserError
from workflow.report.resolution import HOLLOW, not_resolved
from workflow.result import BROKEN, Groups, broken, open_result
from workflow.study import AnyStudy, load_script
from workflow.system import write_durably

STYLE: dict[str, Any] = {
    "figure.dpi": 150,
    "savefig.dpi": 200,
    "font.size": 8.0,
    "axes.labelsize": 8.5,
    "axes.titlesize": 8.5,
    "axes.titlelocation": "left",
    "figure.labelsize": 6.0,  # notes below a figure
    "figure.constrained_layout.use": True,
    "legend.fontsize": 7.0,
    "legend.frameon": False,
    "lines.linewidth": 1.0,
    "lines.markersize": 3.0,
    "errorbar.capsize": 1.5,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "xtick.direction": "in",
    "ytick.direction": "in",
    "pdf.fonttype": 42,
}

FOOT_CHARACTERS_PER_INCH = 21

# Okabe and Ito: distinguishable with any colour vision.
COLOURS = ("#0072B2", "#E69F00", "#009E73", "#CC79A7", "#D55E00", "#56B4E9", "#000000")


def draw_figure(study: AnyStudy, result: Path) -> list[Path]:
    """Draw the study's figure beside its result, as PNG and PDF; return the files.

    Raises UserError where there is no result, the study has no figure script, the script cannot
    use the result, or the disk refuses the files.
    """
    with contextlib.ExitStack() as stack:
        return draw_groups(study, open_result(study, result, stack), result)


def draw_groups(study: AnyStudy, groups: Groups, result: Path) -> list[Path]:
    """Draw the study's figure from its opened result; as ``draw_figure``."""
    draw = _script(study)
    files = {}
    with mpl.rc_context(cast(Any, STYLE)):
        try:
            figure = draw(groups)
            for kind in ("png", "pdf"):
                # No creation date: the same result gives the same file.
                stamp = {"CreationDate": None} if kind == "pdf" else {}
                drawn = io.BytesIO()
                figure.savefig(drawn, format=kind, metadata=stamp)
                figure.set_layout_engine("none")  # laid out once: alike in both, and quicker
                files[result.with_suffix(f".{kind}")] = drawn.getvalue()
        except BROKEN as error:
            raise broken(study, result, error) from error
        finally:
            plt.close("all")
    for file, content in files.items():
        write_durably(file, content)
    return list(files)


def _script(study: AnyStudy) -> Callable[[Groups], Figure]:
    """Return the function that draws. Raises UserError where there is none, or one of old."""
    script = study.folder / "figure.py"
    if not script.is_file():
        raise UserError(f"{script}: not found; the study has no figure script")
    draw = load_script(script).draw
    if [*inspect.signature(draw).parameters][:1] != ["groups"]:
        raise UserError(
            f"{script}: draw takes the path of a result; write draw(groups) instead, which is "
            'handed the opened datasets: groups[""] is the study, groups["NAME"] a comparison'
        )
    return draw


def foot_line(figure: Figure, dataset: xr.Dataset, note: str = "") -> None:
    """Say under the figure how large the study was, and from which seed."""
    points = int(dataset.realizations.size)
    plural = "s" if points != 1 else ""
    text = (
        f"{points} grid point{plural}, {int(dataset.realizations.max())} realizations each, "
        f"seed {dataset.attrs['seed']}; bars: one jackknife standard error"
    )
    hollow = int(not_resolved(dataset).sum())
    write_below(figure, text, note, f"{HOLLOW} ({hollow} points)" if hollow else "")


def write_below(figure: Figure, *notes: str) -> None:
    """Write small lines under the figure, each note wrapped to its width."""
    width = int(FOOT_CHARACTERS_PER_INCH * figure.get_figwidth())
    lines = [line for note in notes for line in textwrap.wrap(note, width)]
    figure.supxlabel("\n".join(lines), color="0.35")


def error_bars(
    ax: Axes,
    points: xr.Dataset,
    name: str,
    over: str,
    log: bool = False,
    bias: xr.DataArray | float = 0.0,
    **style: Any,
) -> None:
    """Draw an estimate with its standard errors over another variable of a result.

    Points whose contacts are not resolved are hollow. ``log`` : bars as of ``log_bars``.
    ``bias`` : added to the standard errors. ``style`` : as for matplotlib's errorbar.
    """
    value, error = points[name].values, (points[f"{name}_error"] + bias).values
    bars = log_bars(value, error) if log else error
    drawn = ax.errorbar(points[over], value, bars, **style)
    hollow = not_resolved(points)
    if hollow.shape == value.shape and hollow.any():
        ring: dict[str, Any] = {"color": drawn.lines[2][0].get_color()[0], "mfc": "white"}
        ring |= {"ms": style["ms"]} if "ms" in style else {}
        ax.plot(points[over].values[hollow], value[hollow], "o", mew=0.6, zorder=2.5, **ring)


def log_bars(value: np.ndarray, error: np.ndarray) -> list[np.ndarray]:
    """Return lengths of error bars that are symmetric in the logarithm: none reaches zero.

    A bar is at most a factor of ten long each way.
    """
    ratio = np.minimum(error / value, np.log(10.0))
    return [value * -np.expm1(-ratio), value * np.expm1(ratio)]
