"""Work and precision: what each discretisation and each realization costs and is worth."""

from collections.abc import Callable
from functools import partial

import numpy as np
import pandas as pd
import xarray as xr

from workflow.result import Groups
from workflow.study import integer, positive

from . import ladders, rivals
from .marches import MARCHES
from .points import COMPARED, POINTS
from .recommendation import recommend, table_lines

SETTINGS = {
    "points": partial(integer, least=1, most=len(POINTS)),
    "elements": partial(integer, least=64, most=100_000),
    "lines": partial(integer, least=4, most=100_000),
    "finest": partial(integer, least=8, most=256),
    "realizations": partial(integer, least=20, most=100_000),
    "march_lines": partial(integer, least=2, most=1000),
    "march_updates": positive,
}

# Core-seconds, measured at the default scale.
SECONDS_PER_POINT = 5.0
SECONDS_PER_REALIZATION = 1.5e-3
SECONDS_PER_UPDATE = 8e-8
SECONDS_COMPILING = 15.0


def parts(settings: dict) -> dict[str, float]:
    """Return the parts of the study and the core-seconds each is predicted to take."""
    size = settings["elements"] / 1000.0
    fine = (settings["finest"] / 64.0) ** 2
    climbs = SECONDS_PER_POINT * settings["points"] * size * max(0.1, fine)
    draws = SECONDS_PER_REALIZATION * settings["realizations"] * settings["points"] * size
    compared = min(settings["points"], COMPARED)
    marches = SECONDS_PER_UPDATE * settings["march_updates"] * settings["march_lines"] * compared
    return {
        "compiling": SECONDS_COMPILING,
        "discretisations": climbs * max(1.0, settings["lines"] / 128.0),
        "realizations": draws,
        "alternatives": len(MARCHES) * marches,
    }


def outline(settings: dict) -> tuple[list[str], float]:
    """Return what would be measured, and the predicted core-seconds."""
    chosen = POINTS[: settings["points"]]
    lines = [
        f"points      {len(chosen)} (H, Fbar, x): {', '.join(p.name for p in chosen[:3])}, ...",
        f"lines       {settings['elements']} elements, {settings['lines']} lines at m <= 8",
        f"m           1 ... {settings['finest']} and finer where tau asks for it, both schemes",
        f"realizations {settings['realizations']} for the sampling error",
        f"alternatives {', '.join(MARCHES)} at {min(len(chosen), COMPARED)} points",
    ]
    lines += [f"  {name:16s}{seconds:6.0f} s" for name, seconds in parts(settings).items()]
    return lines, sum(parts(settings).values())


def measure(settings: dict, seed: int, advance: Callable[[float], None]) -> dict[str, xr.Dataset]:
    """Return the datasets of the study: see ladders.py, rivals.py and recommendation.py."""
    chosen = POINTS[: settings["points"]]
    cost = parts(settings)
    ladders.warm_up()
    advance(cost["compiling"])
    each = cost["discretisations"] / len(chosen)
    root = ladders.discretisations(chosen, settings, seed, partial(advance, each))
    each = cost["realizations"] / len(chosen)
    sampling = ladders.sampling(chosen, settings, seed, partial(advance, each))
    compared = chosen[:COMPARED]
    each = cost["alternatives"] / len(compared)
    found = rivals.alternatives(compared, settings, seed, partial(advance, each))
    return {
        "": root,
        "sampling": sampling,
        "alternatives": found,
        "recommendation": recommend(root),
    }


def summary(groups: Groups) -> list[str]:
    """Return the table "for this accuracy take ... ; it costs ..." by regime of x."""
    return table_lines(groups["recommendation"])


def table(groups: Groups) -> pd.DataFrame:
    """Return what to take for which accuracy, one row per point, quantity and wanted error."""
    frame = groups["recommendation"].drop_dims("regime").to_dataframe().reset_index()
    return frame[np.isfinite(frame.seconds)]
