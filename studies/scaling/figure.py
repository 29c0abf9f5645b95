"""Where a cluster saturates, whether the simulation is right, and what the paper's studies take."""

import json
import textwrap
from pathlib import Path

import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from workflow.report.figure import COLOURS, FOOT_CHARACTERS_PER_INCH
from workflow.system.progress import duration

MARKERS = ("o", "s", "^", "D")


def draw(result: Path) -> Figure:
    """Return the figure of a result file of this study."""
    figure, axes = plt.subplots(2, 2, figsize=(7.2, 6.0), layout="constrained")
    groups = ("real", "studies", "memory")
    with xr.open_dataset(result) as uniform:
        _saturation(axes[0, 0], uniform)
        note = _note(uniform)
        parts = [xr.load_dataset(result, group=name) for name in groups]
    for ax, part, panel in zip(
        axes.ravel()[1:], parts, (_validation, _studies, _memory), strict=True
    ):
        panel(ax, part)
    _simulated_memory(axes[1, 1], parts[1])
    axes[1, 1].legend(loc="lower right")
    width = int(FOOT_CHARACTERS_PER_INCH * figure.get_figwidth())
    figure.supxlabel(textwrap.fill(note, width), fontsize=6, color="0.35")
    return figure


def _note(uniform: xr.Dataset) -> str:
    attrs = uniform.attrs
    settings = json.loads(attrs["study"])["measure"]
    return (
        "Simulated: real plan, flow, store and journal on a virtual clock; a batch takes its "
        f"predicted time, costs the scheduler {1e3 * attrs['scheduler_seconds_per_task']:.2g} ms "
        f"and the driver {1e3 * attrs['driver_seconds_per_task']:.2g} ms, the CPU time of empty "
        "tasks on a real scheduler. Not simulated: traffic, failures, errors of the prediction. "
        "What to do beyond the dotted line: longer batches (--batch-seconds). "
        f"Real worker processes idled {attrs['overhead']:.1%} of the time at batches of "
        f"{settings['overhead_seconds']:g} s ({settings['overhead_workers']} of them on loopback)."
    )


def _saturation(ax: Axes, uniform: xr.Dataset) -> None:
    cost = uniform.attrs["scheduler_seconds_per_task"]
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


def _validation(ax: Axes, real: xr.Dataset) -> None:
    asleep = real.where(real.seconds > 0.0, drop=True)
    for number, workers in enumerate(np.unique(asleep.workers)):
        chosen = asleep.where(asleep.workers == workers, drop=True).sortby("seconds")
        colour = COLOURS[3 + number]
        ax.plot(chosen.seconds, chosen.simulated_efficiency, "-", color=colour)
        label = f"{int(workers)} workers"
        ax.plot(chosen.seconds, chosen.efficiency, MARKERS[number], color=colour, ms=4, label=label)
    ax.set(
        xscale="log",
        xlabel="mean batch (s)",
        xlim=(0.1, 4.0),
        ylabel="busy share of workers",
        ylim=(0, 1.05),
    )
    ax.set_xlim(0.1, 4.0)
    ax.set_xticks([0.1, 0.2, 0.5, 1.0, 2.0], ["0.1", "0.2", "0.5", "1", "2"])
    ax.tick_params(which="minor", labelbottom=False)
    ax.set_title("(b) real, sleeping workers; simulated (lines)", loc="left")
    ax.legend(loc="lower right")


def _studies(ax: Axes, studies: xr.Dataset) -> None:
    count = studies.sizes["study"]
    places = np.arange(studies.sizes["workers"])
    for number, name in enumerate(studies.study.values):
        chosen = studies.sel(study=name)
        x = places + (number - (count - 1) / 2) * 0.8 / count
        ax.bar(x, chosen.efficiency, 0.75 / count, color=COLOURS[number], label=name, alpha=0.8)
        for k, place in enumerate(x):
            at = chosen.isel(workers=k)
            text = (
                f"{float(at.efficiency):.1%}   {duration(float(at.wall))}   {int(at.shards)} shards"
            )
            ax.text(place, 0.06, text, rotation=90, ha="center", va="bottom", fontsize=6.5)
    planning = ", ".join(
        f"{name} {float(studies.planning.sel(study=name).max()):.1f} s"
        for name in studies.study.values
    )
    ax.set_xticks(places, [str(w) for w in studies.workers.values])
    ax.set(xlabel="workers", ylabel="busy share of workers", ylim=(0, 1.25))
    ax.legend(loc="upper right", ncols=2)
    text = f"CPU time to plan: {planning}"
    ax.annotate(text, (0.02, 0.87), xycoords="axes fraction", fontsize=6.5)
    ax.set_title("(c) studies of the paper's scale, simulated", loc="left")


def _memory(ax: Axes, memory: xr.Dataset) -> None:
    label = "real driver and scheduler, 10 points"
    ax.plot(memory.realizations, memory.memory, "o-", color=COLOURS[0], ms=4, label=label)
    ax.set(xscale="log", xlabel="realizations", ylabel="peak memory of the driver (MiB)")
    ax.set_title("(d) driver memory", loc="left")


def _simulated_memory(ax: Axes, studies: xr.Dataset) -> None:
    for number, name in enumerate(studies.study.values):
        chosen = studies.sel(study=name)
        points = int(chosen.points[0])
        label = f"{name}, {points} points, simulated"
        ax.plot(
            chosen.realizations,
            chosen.driver_memory,
            MARKERS[1 + number],
            color=COLOURS[1 + number],
            ms=4,
            label=label,
        )
    ax.set_xlim(500.0, 1e8)
    ax.set_ylim(0.0, 1.25 * ax.get_ylim()[1])
