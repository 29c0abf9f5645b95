"""Claims of the paper, judged from the numbers in the result files.

The claims of a study are in ``studies/NAME/claims.py``: CLAIMS lists functions of the opened
datasets ("fig7", and "fig7/paper_step" for a comparison). Each returns a Claim, or raises NotGiven
if the study, a variable or a usable point is missing. This module collects the claims and derives
verdicts from a deviation, its error and a tolerance.
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

Results = Mapping[str, xr.Dataset]  # by name: "fig7", or "fig7/paper_step" for a comparison

EQUAL_DEVIATION = 0.01  # relative deviation that still counts as equal
TOLERANCE = 0.25  # relative deviation up to which a claim holds approximately
FACTOR = 2.0  # largest typical factor between result and law for which a power law holds
HOLDS, NOT_FOUND = "holds", "not found"
ONLY_COARSE = "only with one implicit Euler step per Δx"  # the paper does not state its step


class Claim(NamedTuple):
    """A statement of the paper and the corresponding result, in plain text."""

    text: str
    paper: str
    found: str
    error: str
    verdict: str


Judge = Callable[[Results], Claim]


class NotGiven(Exception):
    """Raised if results lack data needed to judge a claim."""


def needed(condition: object) -> None:
    """Raise NotGiven unless ``condition`` is true."""
    if not condition:
        raise NotGiven


def given(results: Results, key: str, *names: str) -> xr.Dataset:
    """Return a dataset of the results; raise NotGiven if it or a variable is missing."""
    needed(key in results)
    dataset = results[key]
    needed(all(name in dataset for name in names))
    return dataset


def percent(share: float, digits: int = 0) -> str:
    """Return a share as a percentage."""
    return f"{100.0 * share:.{digits}f} %"


def judge(deviation: float, error: float = 0.0, tolerance: float = TOLERANCE) -> str:
    """Return the verdict on a relative deviation, given its relative standard error.

    Up to two standard errors count as chance. If these exceed the tolerance, there is no verdict.
    """
    if not (math.isfinite(deviation) and math.isfinite(error)) or 2.0 * error > tolerance:
        return "cannot be judged: the error is too large"
    if deviation <= max(EQUAL_DEVIATION, 2.0 * error):
        return HOLDS
    if deviation <= tolerance:
        return f"{HOLDS} within {math.ceil(100.0 * deviation - 1e-9)} %"
    return NOT_FOUND


def reworded(verdict: str, words: str) -> str:
    """Return ``words`` instead of an approximate verdict; return other verdicts unchanged."""
    return words if verdict.startswith(f"{HOLDS} within") else verdict


def judge_factor(ratio: np.ndarray) -> str:
    """Return the verdict on a law. ratio : positive ratios of result to law."""
    factor = typical_factor(ratio)
    if factor <= 1.0 + EQUAL_DEVIATION:
        return HOLDS
    return f"{HOLDS} within a factor {factor:.2g}" if factor <= FACTOR else NOT_FOUND


def typical_factor(ratio: np.ndarray) -> float:
    """Return the typical factor between ratios and 1, as exp of the rms logarithm."""
    return float(np.exp(np.sqrt(np.mean(np.log(ratio) ** 2))))


def spread(values: np.ndarray) -> str:
    """Return the median and the 16th and 84th percentiles as text."""
    low, middle, high = np.percentile(values, [16, 50, 84])
    return f"{middle:.2f} ({low:.2f} … {high:.2f} for two thirds of the points)"


def mean_error(error: xr.DataArray) -> float:
    """Return an upper bound on the standard error of a mean over points, from their errors.

    Points with the same (H, dx) share their random lines, so that their errors are added as if
    fully correlated. Errors of independent lines are added in quadrature.
    """
    finite = error.where(np.isfinite(error))
    shared = [dim for dim in error.dims if dim not in ("hurst", "spacing")]
    weight = finite.count(shared) / finite.count()
    return float(np.sqrt(((finite.mean(shared) * weight) ** 2).sum()))


def per_point(dataset: xr.Dataset) -> str:
    """Return the median relative standard error of the relaxation rate, as text."""
    relative = dataset.relaxation_rate_error / dataset.relaxation_rate
    return f"{percent(float(relative.median()), 1)} of b a point"


def known_claims() -> list[Judge]:
    """Return the claims of all studies, sorted by the paths of the studies."""
    folders = sorted(path.parent for path in known_studies().values())
    scripts = [folder / "claims.py" for folder in folders]
    return [claim for s in scripts if s.is_file() for claim in load_script(s).CLAIMS]


def evaluate(claims: list[Judge], results: Results) -> list[Claim]:
    """Return the claims that can be judged from these results without unresolved points."""
    evaluated = []
    for judged in claims:
        resolved = Resolved(results)
        with contextlib.suppress(NotGiven):
            claim = judged(resolved)
            if count := sum(resolved.left_out.values()):
                words = f"{claim.found}; {count} points with unresolved contacts left out"
                claim = claim._replace(found=words)
            evaluated.append(claim)
    return evaluated
