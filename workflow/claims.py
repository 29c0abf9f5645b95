"""The claims of the paper, each judged by code from the numbers in the result files.

Each claim is a function of the opened datasets ("fig7", and "fig7/paper_step" for its comparison)
that returns a Claim, or None where the study, a variable or a usable point is missing.
Source: Li et al. (2014), doi:10.1038/srep05795.
"""

from collections.abc import Callable

from workflow.claims_fit import example_rate, exponential
from workflow.claims_jump import interpolation, plateau, slow_jump, slow_steady
from workflow.claims_rate import (
    exponent,
    exponent_paper_step,
    force_independence,
    relaxation_time,
    slow_rate,
)
from workflow.verdicts import Claim, Results

CLAIMS: tuple[Callable[[Results], Claim | None], ...] = (
    slow_jump,
    slow_steady,
    plateau,
    interpolation,
    exponential,
    example_rate,
    slow_rate,
    exponent,
    exponent_paper_step,
    relaxation_time,
    force_independence,
)


def evaluate(results: Results) -> list[Claim]:
    """Return the claims that these results can judge, in the order of the paper."""
    return [claim for judged in CLAIMS if (claim := judged(results)) is not None]
