"""Where a cluster saturates, and what the paper's studies take there."""

import json
import textwrap
from typing import Any

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from workflow.report import COLOURS, FOOT_CHARACTERS_PER_INCH
from workflow.result import Groups
from workflow.system import duration

MARKERS = ("o", "s", "^", "D")


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(1, 3, figsize=(9.6, 3.3), layout="constrained")
    uniform, studies = groups[""], groups["studies"]
    _saturation(axes[0], uniform)
    _studies(axes[1], studies)
    _memory(axes[2], studies)
    width = int(FOOT_CHARACTERS_PER_INCH * figure.get_figwidth())
    figure.supxlabel(textwrap.fill(_note(uniform), width), fontsize=6, color="0.35")
    return figure


def _settings(data: xr.Dataset) -> dict:
    return json.loads(data.attrs["study"])["measure"]


def _note(uniform: xr.Dataset) -> str:
    settings = _settings(uniform)
    return (
        "Simulated: real plan, flow, store and journal on a virtual clock; a batch takes its "
        f"predicted time, costs the scheduler {1e3 * settings['scheduler_seconds']:.2g} ms "
        f"and the driver {1e3 * settings['driver_seconds']:.2g} ms, the CPU time of empty "
        "tasks on a real scheduler. Not simulated: traffic, failures, errors of the prediction. "
        "What to do beyond the dotted line: longer batches (--batch-seconds)."
    )


def _saturation(ax: Axes, uniform: xr.Dataset) -> None:
    cost = _settings(uniform)["scheduler_seconds"]
    workers = np.geomspace(uniform.workers.min(), uniform.workers.max(), 200)
    for number, seconds in enumerate(uniform.seconds.values):
        colour = COLOURS[number]
        efficiency = uniform.efficiency.sel(seconds=seconds)
        ax.plot(uniform.workers, efficiency, MARKERS[number], color=colour, ms=3.5)
        ax.plot(workers, np.minimum(1.0, seconds / cost / workers), color=colour)
        ax.axvline(seconds / cost, color=colour, ls=":", lw=0.8)
        ax.plot([], [], MARKERS[number] + "-", color=colour, ms=3.5, label=f"{seconds:g} s")
    ax.set(xscale="log", xlabel="workers", ylabel="busy share of workers", ylim=(0, 1.05))
    ax.set_xlim(workers[0] / 1.2, workers[-1] * 1.2)
    ax.legend(title="mean batch", loc="lower left")
    ax.set_title("(a) saturation: batch / scheduler time (lines)", loc="left")


def _studies(ax: Axes, studies: xr.Dataset) -> None:
    count = studies.sizes["study"]
    ticks = np.arange(studies.sizes["workers"])
    for number, name in enumerate(studies.study.values):
        chosen = studies.sel(study=name)
        x = ticks + (number - (count - 1) / 2) * 0.8 / count
        ax.bar(x, chosen.efficiency, 0.75 / count, color=COLOURS[number], label=name, alpha=0.8)
        for k, at_x in enumerate(x):
            at = chosen.isel(workers=k)
            text = (
                f"{float(at.efficiency):.1%}   {duration(float(at.wall))}   {int(at.shards)} shards"
            )
            ax.text(at_x, 0.06, text, rotation=90, ha="center", va="bottom", fontsize=6.5)
    planning = ", ".join(
        f"{name} {float(studies.planning.sel(study=name).max()):.1f} s"
        for name in studies.study.values
    )
    ax.set_xticks(ticks, [str(w) for w in studies.workers.values])
    ax.set(xlabel="workers", ylabel="busy share of workers", ylim=(0, 1.25))
    ax.legend(loc="upper right", ncols=2)
    text = f"CPU time to plan: {planning}"
    ax.annotate(text, (0.02, 0.87), xycoords="axes fraction", fontsize=6.5)
    ax.set_title("(b) studies of the paper's scale, simulated", loc="left")


def _memory(ax: Axes, studies: xr.Dataset) -> None:
    for number, name in enumerate(studies.study.values):
        chosen = studies.sel(study=name)
        label = f"{name}, {int(chosen.points[0])} points"
        style: dict[str, Any] = {"color": COLOURS[number], "ms": 4, "label": label}
        ax.plot(chosen.workers, chosen.driver_memory, MARKERS[number] + "-", **style)
    ax.set(xscale="log", xlabel="workers", ylabel="peak memory of the driver (MiB)")
    ax.set_ylim(0.0, 1.25 * ax.get_ylim()[1])
    ax.legend(loc="lower right")
    ax.set_title("(c) driver memory", loc="left")
