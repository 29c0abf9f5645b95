"""Real contact area beside published values, and over the number of samples."""

from typing import Any

import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from elastomer_friction.workflow.report import COLOURS, write_below
from elastomer_friction.workflow.result import Groups

from .measure import mean_and_error

CAPTION = (
    "The real contact area of an elastic half-space is shown over the nominal pressure (a), and "
    "over values that another group published (b): the corrected area of the program on its finest "
    "maps, and the share of samples in contact on maps of four samples in the shortest wave. Panel "
    "(c) has both areas at one pressure over the number of samples, for the same surfaces, over "
    "their corrected area on the finest maps; bars are standard errors over the maps."
)
FORMS = {"area": ("o", COLOURS[0], "corrected"), "count": ("s", COLOURS[1], "counted")}
COUNTED_SAMPLES = 4  # in the shortest wave
SHOWN_PRESSURE = 0.01  # over E*


def draw(groups: Groups) -> Figure:
    """Return the figure of a result of this study."""
    data = groups[""]
    finest = data.isel(samples=-1)
    figure, axes = plt.subplots(1, 3, figsize=(7.2, 2.9))
    _draw(axes[0], finest.area, "area", "corrected")
    axes[0].plot(data.pressure, data.published, "k+", label="published", ms=7, zorder=3)
    axes[0].set(yscale="log", ylabel="area $A/A_0$", title="(a) area over pressure")
    _draw(
        axes[1], finest.area / data.published, "area", f"corrected, {int(finest.samples)} samples"
    )
    counted = data["count"].sel(samples=COUNTED_SAMPLES) / data.published
    _draw(axes[1], counted, "count", f"counted, {COUNTED_SAMPLES} samples")
    axes[1].axhline(1.0, color="k", lw=0.6)
    axes[1].set(ylabel="area over published area", title="(b) beside published values")
    at_one = data.sel(pressure=SHOWN_PRESSURE)
    for name, (_, _, label) in FORMS.items():
        _draw(axes[2], at_one[name] / at_one.area.isel(samples=-1), name, label)
    axes[2].axhline(1.0, color="k", lw=0.6)
    axes[2].set(ylabel="area over finest corrected area", title="(c) over samples")
    for ax in axes[:2]:
        ax.set(xscale="log", xlabel="pressure $\\sigma_0/E^*$")
    axes[2].set(xscale="log", xlabel="samples in the shortest wave")
    axes[2].set_xticks(data.samples.values, [str(samples) for samples in data.samples.values])
    axes[2].minorticks_off()
    for ax in axes:
        ax.legend(loc="best")
    write_below(
        figure,
        f"H = 0.8, q from 10⁴ to 10⁶ 1/m, rms slope 0.28; {data.sizes['map']} maps. "
        f"Panel (c): σ₀/E* = {SHOWN_PRESSURE:g}.",
    )
    return figure


def _draw(ax: Axes, values: xr.DataArray, name: str, label: str) -> None:
    """Draw the mean of an area over its axis, with its standard error."""
    marker, colour, _ = FORMS[name]
    mean, error = mean_and_error(values)
    axis = mean.dims[0]
    form: dict[str, Any] = {"marker": marker, "color": colour, "ms": 4, "lw": 0.8, "capsize": 2}
    ax.errorbar(mean[axis], mean, error, label=label, **form)
