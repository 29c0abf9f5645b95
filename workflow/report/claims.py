"""The claims of the paper, each judged by code from the numbers in the result files.

A claim lives with the study it judges: ``studies/NAME/claims.py`` holds CLAIMS, functions of the
opened datasets ("fig7", and "fig7/paper_step" for its comparison) that return a Claim and raise
NotGiven where the study, a variable or a usable point is missing. Here they are found, and a
deviation, its error and a tolerance become plain words.
Source: Li et al. (2014), doi:10.1038/srep05795.
"""

import contextlib
import math
from collections.abc import Callable, Mapping
from typing import NamedTuple

import numpy as np
import xarray as xr

from ..study import known_studies, load_script
from .unresolved import Resolved

Results = Mapping[str, xr.Dataset]  # "fig7", and "fig7/paper_step" for its comparison

CLOSE = 0.01  # relative deviation that still counts as equal
TOLERANCE = 0.25  # relative deviation up to which a claim holds approximately
FACTOR = 2.0  # typical ratio up to which a power law over decades holds
HOLDS, NOT_FOUND = "holds", "not found"
ONLY_COARSE = "only with one implicit Euler step per Δx"  # whether the paper did so is not known


class Claim(NamedTuple):
    """One statement of the paper beside what our results say; all plain text."""

    text: str
    paper: str
    found: str
    error: str
    verdict: str


Judge = Callable[[Results], Claim]


class NotGiven(Exception):
    """Results do not hold what a claim needs to be judged."""


def needed(there: object) -> None:
    """Raise NotGiven where something that a claim needs is not there."""
    if not there:
        raise NotGiven


def given(results: Results, key: str, *names: str) -> xr.Dataset:
    """Return a dataset of the results; raise NotGiven where it or one of these variables is not."""
    needed(key in results)
    dataset = results[key]
    needed(all(name in dataset for name in names))
    return dataset


def percent(share: float, digits: int = 0) -> str:
    """Return a share as a percentage."""
    return f"{100.0 * share:.{digits}f} %"


def judge(deviation: float, error: float = 0.0, tolerance: float = TOLERANCE) -> str:
    """Return the verdict on a relative deviation with a relative standard error.

    Two standard errors are left to chance; they must not exceed the tolerance themselves.
    """
    if not (math.isfinite(deviation) and math.isfinite(error)) or 2.0 * error > tolerance:
        return "cannot be told: the error is too large"
    if deviation <= max(CLOSE, 2.0 * error):
        return HOLDS
    if deviation <= tolerance:
        return f"{HOLDS} within {math.ceil(100.0 * deviation - 1e-9)} %"
    return NOT_FOUND


def reworded(verdict: str, words: str) -> str:
    """Return ``words`` for a verdict that a claim holds approximately, any other unchanged."""
    return words if verdict.startswith(f"{HOLDS} within") else verdict


def judge_factor(ratio: np.ndarray) -> str:
    """Return the verdict on ratios found / law, all positive: how far they scatter about 1."""
    factor = typical_factor(ratio)
    if factor <= 1.0 + CLOSE:
        return HOLDS
    return f"{HOLDS} within a factor {factor:.2g}" if factor <= FACTOR else NOT_FOUND


def typical_factor(ratio: np.ndarray) -> float:
    """Return exp of the rms logarithm: the factor by which ratios typically differ from 1."""
    return float(np.exp(np.sqrt(np.mean(np.log(ratio) ** 2))))


def spread(values: np.ndarray) -> str:
    """Return "median (16th ... 84th percentile)"."""
    low, middle, high = np.percentile(values, [16, 50, 84])
    return f"{middle:.2f} ({low:.2f} … {high:.2f} for two thirds of the points)"


def mean_error(error: xr.DataArray) -> float:
    """Return the standard error of a mean over points, from the errors of the points.

    Points of one (H, dx) share their random lines: their errors are added up, as if fully
    correlated (an upper bound). Other lines are independent: in quadrature.
    """
    known = error.where(np.isfinite(error))
    shared = [dim for dim in error.dims if dim not in ("hurst", "spacing")]
    weight = known.count(shared) / known.count()
    return float(np.sqrt(((known.mean(shared) * weight) ** 2).sum()))


def per_point(dataset: xr.Dataset) -> str:
    """Return the median relative standard error of a fitted rate, in words."""
    relative = dataset.relaxation_rate_error / dataset.relaxation_rate
    return f"{percent(float(relative.median()), 1)} of b a point"


def known_claims() -> list[Judge]:
    """Return the claims of all studies, in the order of their folders' names."""
    folders = sorted(path.parent for path in known_studies().values())
    scripts = [folder / "claims.py" for folder in folders]
    return [claim for s in scripts if s.is_file() for claim in load_script(s).CLAIMS]


def evaluate(claims: list[Judge], results: Results) -> list[Claim]:
    """Return what the claims say that these results can judge, unresolved points left out."""
    found = []
    for judged in claims:
        seen = Resolved(results)
        with contextlib.suppress(NotGiven):
            claim = judged(seen)
            if count := sum(seen.left_out.values()):
                words = f"{claim.found}; {count} points left out, whose contacts are unresolved"
                claim = claim._replace(found=words)
            found.append(claim)
    return found
