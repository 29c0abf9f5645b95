"""Where a cluster saturates, and what the paper's studies take there."""

import json

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from elastomer_friction.workflow.report import COLOURS, write_below
from elastomer_friction.workflow.result import Groups
from elastomer_friction.workflow.system import duration

CAPTION = (
    "Panels (a) and (b) show which share of their time the workers of a simulated cluster are "
    "busy, for batches of several lengths and for studies of the paper. Panel (c) shows the "
    "memory that the driving process needs."
)
MARKERS = ("o-", "s-", "^-", "D-")


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    figure, axes = plt.subplots(1, 3, figsize=(9.6, 3.3))
    uniform, studies = groups[""], groups["studies"]
    settings = json.loads(uniform.attrs["study"])["measure"]
    _saturation(axes[0], uniform, settings["scheduler_seconds"])
    _studies(axes[1], studies, settings["scale"])
    _memory(axes[2], studies)
    write_below(
        figure,
        "Simulated: real plan, flow, store and journal on a virtual clock; a batch takes its "
        f"predicted time, costs the scheduler {1e3 * settings['scheduler_seconds']:.2g} ms "
        f"and the driver {1e3 * settings['driver_seconds']:.2g} ms, the CPU time of empty "
        "tasks on a real scheduler. Not simulated: traffic, failures, errors of the prediction. "
        "What to do beyond the dotted line: longer batches (--batch-seconds).",
    )
    return figure


def _saturation(ax: Axes, uniform: xr.Dataset, cost: float) -> None:
    there = uniform.uniform_workers
    workers = np.geomspace(there.min(), there.max(), 200)
    means = uniform.uniform_seconds.values
    for seconds, colour, marker in zip(means, COLOURS, MARKERS, strict=False):
        efficiency = uniform.efficiency.sel(uniform_seconds=seconds)
        ax.plot(there, efficiency, marker[0], color=colour, ms=3.5)
        ax.plot(workers, np.minimum(1.0, seconds / cost / workers), color=colour)
        ax.axvline(seconds / cost, color=colour, ls=":", lw=0.8)
        ax.plot([], [], marker, color=colour, ms=3.5, label=f"{seconds:g} s")
    ax.set(xscale="log", xlabel="workers", ylabel="busy share of workers", ylim=(0, 1.05))
    ax.set_xlim(workers[0] / 1.2, workers[-1] * 1.2)
    ax.legend(title="mean batch", loc="lower left")
    ax.set_title("(a) saturation: batch / scheduler time (lines)")


def _studies(ax: Axes, studies: xr.Dataset, scale: str) -> None:
    count = studies.sizes["study"]
    ticks = np.arange(studies.sizes["workers"])
    for number, name in enumerate(studies.study.values):
        chosen = studies.sel(study=name)
        x = ticks + (number - (count - 1) / 2) * 0.8 / count
        ax.bar(x, chosen.efficiency, 0.75 / count, color=COLOURS[number], label=name, alpha=0.8)
        for k, at_x in enumerate(x):
            share, wall, shards = chosen.isel(workers=k)[["efficiency", "wall", "shards"]].values()
            text = f"{float(share):.1%}   {duration(float(wall))}   {int(shards)} shards"
            ax.text(at_x, 0.06, text, rotation=90, ha="center", va="bottom", fontsize=6.5)
    longest = studies.planning.max("workers")
    planning = ", ".join(
        f"{name} {float(s):.1f} s" for name, s in zip(studies.study.values, longest, strict=True)
    )
    ax.set_xticks(ticks, [str(w) for w in studies.workers.values])
    ax.set(xlabel="workers", ylabel="busy share of workers", ylim=(0, 1.25))
    ax.legend(loc="upper right", ncols=2)
    ax.text(0.02, 0.87, f"CPU time to plan: {planning}", transform=ax.transAxes, fontsize=6.5)
    ax.set_title(f"(b) studies at {scale} scale, simulated")


def _memory(ax: Axes, studies: xr.Dataset) -> None:
    for name, colour, marker in zip(studies.study.values, COLOURS, MARKERS, strict=False):
        chosen = studies.sel(study=name)
        label = f"{name}, {int(chosen.points[0])} points"
        ax.plot(chosen.workers, chosen.driver_memory, marker, color=colour, ms=4, label=label)
    ax.set(xscale="log", xlabel="workers", ylabel="peak memory of the driver (MiB)")
    ax.set_ylim(0.0, 1.25 * ax.get_ylim()[1])
    ax.set_xticks(studies.workers.values, [str(w) for w in studies.workers.values])
    ax.minorticks_off()
    ax.legend(loc="lower right")
    ax.set_title("(c) driver memory")
