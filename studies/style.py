"""What the figures of several studies share."""

from collections.abc import Iterator
from itertools import cycle
from typing import Any

import numpy as np
import xarray as xr

from workflow.report import COLOURS

CONVERGED, PAPER_STEP = "", "paper_step"  # groups of a result; the first is the study itself
VARIANTS = {
    CONVERGED: "converged",
    PAPER_STEP: "implicit Euler, one step per $\\Delta x$",
}
X_LABEL = "$x = v_1 \\tau q_\\mathrm{max}$"
DOTS: dict[str, Any] = {"fmt": "o", "ms": 2.4, "mew": 0.5, "lw": 0.5, "capsize": 0}


def by_hurst(dataset: xr.Dataset) -> Iterator[tuple[float, xr.Dataset, str]]:
    """Yield every Hurst exponent, its points along "point", and a colour."""
    for hurst, colour in zip(dataset.hurst.values, cycle(COLOURS), strict=False):
        points = dataset.sel(hurst=hurst)
        yield float(hurst), points.stack(point=points.mu_1.dims), colour


def normalised(points: xr.Dataset) -> xr.Dataset:
    """Add mu_bar, mu_1 over grad z, and jump_bar, the jump over grad z dv/v1 (eqs. 11, 12)."""
    slope, step = points.rms_slope, points.velocity_step
    return points.assign(
        mu_bar=points.mu_1 / slope,
        mu_bar_error=points.mu_1_error / slope,
        jump_bar=points.jump / slope / step,
        jump_bar_error=points.jump_error / slope / np.abs(step),
    )
