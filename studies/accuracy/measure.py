"""Work and precision: cost and error of discretisations, realizations and alternatives."""

from collections.abc import Callable
from functools import partial

import numpy as np
import pandas as pd
import xarray as xr

from elastomer_friction.workflow.result import Groups
from elastomer_friction.workflow.study import Key, integer, positive

from . import alternatives, discretisation
from .alternatives import MARCHES
from .points import COMPARED, POINTS
from .recommendation import recommend, table_lines

SETTINGS = {  # documented in docs/reference/measures.md
    "points": Key(partial(integer, least=1, most=len(POINTS))),
    "elements": Key(partial(integer, least=64, most=100_000)),
    "lines": Key(partial(integer, least=4, most=100_000)),
    "finest": Key(partial(integer, least=8, most=256)),
    "realizations": Key(partial(integer, least=20, most=100_000)),
    "march_lines": Key(partial(integer, least=2, most=1000)),
    "march_updates": Key(positive),
}

# Core-seconds on a typical machine, measured at the default scale.
SECONDS_PER_POINT = 4.1
SECONDS_PER_REALIZATION = 1.7e-3
SECONDS_PER_UPDATE = 9.3e-8
SECONDS_COMPILING = 5.0  # to load machine code; the first run on a machine takes one minute more


def parts(settings: dict) -> dict[str, float]:
    """Return the parts of the study with their predicted core-seconds."""
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
    """Return a description of the measurement, and the predicted core-seconds."""
    chosen = POINTS[: settings["points"]]
    lines = [
        f"points      {len(chosen)} (H, Fbar, x): {', '.join(p.name for p in chosen[:3])}, ...",
        f"lines       {settings['elements']} elements, {settings['lines']} lines at m <= 8",
        f"m           1 ... {settings['finest']} and finer if tau requires it, both schemes",
        f"realizations {settings['realizations']} for the sampling error",
        f"alternatives {', '.join(MARCHES)} at {min(len(chosen), COMPARED)} points",
    ]
    cost = parts(settings)
    seconds = sum(cost.values())
    lines += [f"  {name:16s}{part / seconds:6.0%} of the time" for name, part in cost.items()]
    return lines, seconds


def measure(settings: dict, seed: int, advance: Callable[[float], None]) -> dict[str, xr.Dataset]:
    """Return the datasets of the study by group; progress is reported to ``advance``."""
    chosen = POINTS[: settings["points"]]
    cost = parts(settings)
    discretisation.warm_up(discretisation.SCHEMES)
    advance(cost["compiling"])
    share = cost["discretisations"] / len(chosen)
    root, as_sampled = discretisation.discretisations(
        chosen, settings, seed, partial(advance, share)
    )
    share = cost["realizations"] / len(chosen)
    sampling = discretisation.sampling(chosen, settings, seed, partial(advance, share))
    compared = chosen[:COMPARED]
    share = cost["alternatives"] / len(compared)
    by_method = alternatives.alternatives(compared, settings, seed, partial(advance, share))
    return {
        "": root,
        "as_sampled": as_sampled,
        "sampling": sampling,
        "alternatives": by_method,
        "recommendation": recommend(root),
    }


def summary(groups: Groups) -> list[str]:
    """Return the lines of the table of recommended settings and their cost, by regime of x."""
    return table_lines(groups["recommendation"])


def table(groups: Groups) -> pd.DataFrame:
    """Return the recommended settings, a row per point, quantity and target error."""
    frame = groups["recommendation"].drop_dims("regime").to_dataframe().reset_index()
    return frame[np.isfinite(frame.seconds)]
