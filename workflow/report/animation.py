"""Animations of a scene: the line on the foundation or the pressure map, and the friction."""

import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any, cast

import matplotlib as mpl
import numpy as np
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.animation import FFMpegWriter, PillowWriter
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from ..ground import UserError
from ..system import write_durably
from .panels import COLOURS, STYLE

LINE_FRAMES, MAP_FRAMES = ("snapshot_height", "snapshot_displacement"), ("snapshot_pressure",)
TRACE_VARIABLES = ("trace_mu", "trace_time")
WRITERS: dict[str, Any] = {".gif": PillowWriter, ".mp4": FFMpegWriter}
FRAMES_PER_SECOND = 20
DOTS_PER_INCH = 100
MAX_FRAMES = 200  # of more snapshots, only every k-th is drawn
MAX_ELEMENTS = 400  # number of elements in view, centred on the deepest contact
RUBBER_COLOUR, RIGID_COLOUR, CONTACT_COLOUR = "#9ecae1", "0.75", COLOURS[4]
MICROMETRES = 1e6  # µm per m
Drawing = Callable[[int], Any]  # draws the frame of this number


def animate(scene: xr.Dataset, path: Path) -> Path:
    """Draw the snapshots of a scene as ``path``, a .gif or .mp4 file; return the path.

    scene : as ``scene.run`` returns it for one line, with the quantities "trace" and "snapshots".
    Raises UserError if they are missing, for other file types, if ffmpeg is needed but missing,
    and if the disk refuses the file.
    """
    shown = MAP_FRAMES if MAP_FRAMES[0] in scene else LINE_FRAMES
    missing = [name for name in (*shown, *TRACE_VARIABLES) if name not in scene]
    if missing:
        raise UserError(
            f"{path}: the scene has no {', '.join(missing)}; request the quantities "
            '"trace" and "snapshots"'
        )
    check_animation(path)
    writer = WRITERS[path.suffix](fps=FRAMES_PER_SECOND)
    with mpl.rc_context(cast(Any, STYLE)), tempfile.TemporaryDirectory() as folder:
        drawn = Path(folder) / path.name
        try:
            prepare = _pressure_map if shown == MAP_FRAMES else _line_contact
            figure, draw_frame = _prepared(scene, prepare)
            draw_frame(0)
            _freeze_axes(figure)
            with writer.saving(figure, str(drawn), dpi=DOTS_PER_INCH):
                for frame in range(0, scene.sizes["event"], -(-scene.sizes["event"] // MAX_FRAMES)):
                    draw_frame(frame)
                    writer.grab_frame()
        finally:
            plt.close("all")
        write_durably(path, drawn.read_bytes())
    return path


def check_animation(path: Path) -> None:
    """Raise UserError if an animation cannot be written with the file type of ``path``."""
    if path.suffix not in WRITERS:
        raise UserError(f"{path}: must end in {' or '.join(WRITERS)}")
    if not WRITERS[path.suffix].isAvailable():
        raise UserError(f"{path}: an .mp4 file needs the program ffmpeg; install it or use .gif")


def _prepared(scene: xr.Dataset, prepare_contact: Callable[..., Drawing]) -> tuple[Figure, Drawing]:
    """Return a figure with the contact above the friction, and a function that draws a frame."""
    figure, (above, below) = plt.subplots(
        2, 1, figsize=(5.6, 4.2), dpi=DOTS_PER_INCH, gridspec_kw={"height_ratios": [2.0, 1.0]}
    )
    contact = prepare_contact(above, scene)
    time, mu = scene.trace_time.values, scene.trace_mu.values
    below.plot(time, mu, color="0.8")
    (line,) = below.plot([], [], color=COLOURS[0])
    (dot,) = below.plot([], [], "o", color=COLOURS[4], ms=4.0)
    below.set(xlabel="time, s", ylabel="coefficient of friction")

    def draw(frame: int) -> None:
        contact(frame)
        line.set_data(time[: frame + 1], mu[: frame + 1])
        dot.set_data(time[frame : frame + 1], mu[frame : frame + 1])

    return figure, draw


def _freeze_axes(figure: Figure) -> None:
    """Replace the axes and labels of a figure by an image that lies above the frames.

    Drawing axes and labels takes most of the time of a frame.
    """
    figure.canvas.draw()
    figure.set_layout_engine("none")
    hidden: list[Artist] = [figure.patch]
    for ax in figure.axes:
        hidden += [ax.patch, *ax.collections, *ax.lines, *ax.images]
    for artist in hidden:
        artist.set_visible(False)
    figure.canvas.draw()
    axes = np.array(cast(FigureCanvasAgg, figure.canvas).buffer_rgba())
    for artist in hidden:
        artist.set_visible(True)
    for ax in figure.axes:
        ax.set_axis_off()
        for text in [*ax.texts]:
            text.remove()
    figure.figimage(axes, origin="upper", zorder=10.0)


def _pressure_map(ax: Axes, scene: xr.Dataset) -> Drawing:
    """Prepare the pressure map of a half-space; return a function that draws a frame."""
    pressure = scene.snapshot_pressure / 1e6
    highest = float(pressure.quantile(0.999)) or 1.0
    sides = [MICROMETRES * float(scene[axis][-1] + scene[axis][1]) for axis in ("x", "y")]
    extent = (0.0, sides[0], 0.0, sides[1])
    image = ax.imshow(
        pressure[0], origin="lower", extent=extent, cmap="magma_r", vmin=0.0, vmax=highest
    )
    ax.set(xlabel="along the half-space, µm", ylabel="across, µm")
    ax.figure.colorbar(image, ax=ax, label="pressure, MPa")
    return lambda frame: image.set_data(pressure[frame])


def _line_contact(ax: Axes, scene: xr.Dataset) -> Drawing:
    """Prepare the rigid line and the foundation; return a function that draws a frame."""
    view = _view(scene)
    x, low = view.x.values, float(view.snapshot_displacement.min())
    depth = max(-low, 1e-12)
    floor, top = low - depth, 1.5 * depth
    ax.set(xlim=(x[0], x[-1]), ylim=(floor, top), ylabel="height, µm")
    ax.set_xlabel("along the foundation, µm")
    ax.text(0.01, 0.96, "rigid body", transform=ax.transAxes, va="top")
    ax.text(0.01, 0.04, "elastomer", transform=ax.transAxes)

    def draw(frame: int) -> None:
        for drawn in [*ax.collections, *ax.lines]:
            drawn.remove()
        now = view.isel(event=frame)
        rigid, soft = now.snapshot_height.values, now.snapshot_displacement.values
        # Free elements lie below the line by more than rounding errors.
        contact = np.where(rigid <= soft + 1e-9 * (top - floor), soft, np.nan)
        ax.fill_between(x, rigid, top, color=RIGID_COLOUR, lw=0)
        ax.fill_between(x, soft, floor, color=RUBBER_COLOUR, lw=0)
        ax.plot(x, contact, color=CONTACT_COLOUR, lw=2.0, marker=".", ms=2.0)
        ax.plot(x, rigid, color="0.25", lw=0.8)

    return draw


def _view(scene: xr.Dataset) -> xr.Dataset:
    """Return the part of the snapshots in view, in µm, centred on the deepest point."""
    deepest = int(scene.snapshot_height.min("event").argmin("x"))
    count = min(MAX_ELEMENTS, scene.sizes["x"])
    chosen = (np.arange(count) + deepest - count // 2) % scene.sizes["x"]
    step = float(scene.x[1] - scene.x[0])
    names = ["snapshot_height", "snapshot_displacement"]
    view = scene[names].isel(x=chosen) * MICROMETRES
    return view.assign_coords(x=np.arange(count) * step * MICROMETRES)
