"""Animate a scene: the rigid line creeping over the foundation, with its friction beneath."""

import tempfile
from pathlib import Path
from typing import Any, cast

import matplotlib as mpl
import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.animation import FFMpegWriter, FuncAnimation, PillowWriter
from matplotlib.axes import Axes

from ..errors import UserError
from ..system import write_durably
from .panels import COLOURS, STYLE

NEEDED = ("snapshot_height", "snapshot_displacement", "trace_mu", "trace_time")
WRITERS: dict[str, Any] = {".gif": PillowWriter, ".mp4": FFMpegWriter}
FRAMES_PER_SECOND = 20
FRAMES = 200  # most; of more snapshots every k-th is drawn
SHOWN = 400  # most elements in view, those around the deepest contact
RUBBER, RIGID, TOUCHING = "#9ecae1", "0.75", COLOURS[4]
MICRO = 1e6  # µm per m


def animate(scene: xr.Dataset, path: Path) -> Path:
    """Draw the snapshots of a scene as ``path``, a .gif or .mp4 file; return the path.

    scene : as ``scene.run`` returns it for one line, with the quantities "trace" and "snapshots".
    Raises UserError where they are missing, for another kind of file, where ffmpeg is needed and
    missing, and where the disk refuses the file.
    """
    lacking = [name for name in NEEDED if name not in scene]
    if lacking:
        raise UserError(
            f"{path}: the scene has no {', '.join(lacking)}; ask for the quantities "
            '"trace" and "snapshots"'
        )
    check_animation(path)
    writer = WRITERS[path.suffix](fps=FRAMES_PER_SECOND)
    with mpl.rc_context(cast(Any, STYLE)), tempfile.TemporaryDirectory() as folder:
        drawn = Path(folder) / path.name
        try:
            _animation(scene).save(drawn, writer=writer, dpi=100)
        finally:
            plt.close("all")
        write_durably(path, drawn.read_bytes())
    return path


def check_animation(path: Path) -> None:
    """Raise UserError where ``path`` is of a kind of file that cannot be drawn here."""
    if path.suffix not in WRITERS:
        raise UserError(f"{path}: must end in {' or '.join(WRITERS)}")
    if not WRITERS[path.suffix].isAvailable():
        raise UserError(f"{path}: an .mp4 file needs the program ffmpeg; install it or use .gif")


def _animation(scene: xr.Dataset) -> FuncAnimation:
    frames = np.arange(scene.sizes["event"])[:: -(-scene.sizes["event"] // FRAMES)]
    figure, (above, below) = plt.subplots(
        2, 1, figsize=(5.6, 4.2), gridspec_kw={"height_ratios": [2.0, 1.0]}
    )
    view = _view(scene)
    profile = _Profile(above, view)
    trace = _Trace(below, scene)

    def draw(frame: int) -> list[Any]:
        profile.draw(view.isel(event=frame))
        trace.draw(frame)
        return []

    return FuncAnimation(figure, draw, frames=list(frames), blit=False)


def _view(scene: xr.Dataset) -> xr.Dataset:
    """Return the part of the snapshots that is shown, in µm, around where they lie deepest."""
    deepest = int(scene.snapshot_height.min("event").argmin("x"))
    count = min(SHOWN, scene.sizes["x"])
    chosen = (np.arange(count) + deepest - count // 2) % scene.sizes["x"]
    step = float(scene.x[1] - scene.x[0])
    names = ["snapshot_height", "snapshot_displacement"]
    view = scene[names].isel(x=chosen) * MICRO
    return view.assign_coords(x=np.arange(count) * step * MICRO)


class _Profile:
    """The rigid line above, the surface of the foundation below."""

    def __init__(self, ax: Axes, view: xr.Dataset) -> None:
        self.ax, self.x = ax, view.x.values
        low = float(view.snapshot_displacement.min())
        depth = max(-low, 1e-12)
        self.floor, self.top = low - depth, 1.5 * depth
        ax.set(
            xlim=(self.x[0], self.x[-1]),
            ylim=(self.floor, self.top),
            xlabel="along the foundation, µm",
            ylabel="height, µm",
        )
        ax.text(0.01, 0.96, "rigid body", transform=ax.transAxes, va="top")
        ax.text(0.01, 0.04, "elastomer", transform=ax.transAxes)

    def draw(self, now: xr.Dataset) -> None:
        """Draw one snapshot in place of the one before."""
        for drawn in [*self.ax.collections, *self.ax.lines]:
            drawn.remove()
        rigid, soft = now.snapshot_height.values, now.snapshot_displacement.values
        # A free element lies below the line by more than rounding.
        near = rigid <= soft + 1e-9 * (self.top - self.floor)
        self.ax.fill_between(self.x, rigid, self.top, color=RIGID, lw=0)
        self.ax.fill_between(self.x, soft, self.floor, color=RUBBER, lw=0)
        contact = np.where(near, soft, np.nan)
        self.ax.plot(self.x, contact, color=TOUCHING, lw=2.0, marker=".", ms=2.0)
        self.ax.plot(self.x, rigid, color="0.25", lw=0.8)


class _Trace:
    """The coefficient of friction over time, and where the animation is."""

    def __init__(self, ax: Axes, scene: xr.Dataset) -> None:
        self.time, self.mu = scene.trace_time.values, scene.trace_mu.values
        ax.plot(self.time, self.mu, color="0.8")
        (self.line,) = ax.plot([], [], color=COLOURS[0])
        (self.dot,) = ax.plot([], [], "o", color=COLOURS[4], ms=4.0)
        ax.set(xlabel="time, s", ylabel="coefficient of friction")

    def draw(self, frame: int) -> None:
        """Show the friction up to a frame."""
        self.line.set_data(self.time[: frame + 1], self.mu[: frame + 1])
        self.dot.set_data(self.time[frame : frame + 1], self.mu[frame : frame + 1])
