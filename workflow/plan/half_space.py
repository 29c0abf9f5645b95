"""What a half-space asks for: steps per spacing, errors, scatter and cost, by measured laws.

They take a problem, or many of them together, as the laws of the foundation do (error_laws.py,
cost/work.py). A map has (N m)^2 samples, eight in its shortest wave where m = 4.
"""

from collections.abc import Mapping

import numpy as np

from ...kernels import Quantities
from ..simulate import Problem
from ..study import HALF_SPACE
from .error_laws import LAWS, Laws, known
from .problems import Numbers, speed_ratio

LEAST_STEPS, MOST_STEPS = 4, 16
MOST_SAMPLES = 4096**2  # of a map; a worker then needs 4 GiB and more
# Measured at 512 and 1024 samples a side, without branches and with 13.
MAP_BYTES, BRANCH_BYTES = 260.0, 25.0  # of a worker, for each sample
PASS = 4.0e-8  # s, of a pass of conjugate gradients, for each sample
COLD, WARM = 60.0, 4.0  # passes of the first contact at 128 samples a side, and of a step
MEMORY = 5.0  # times v tau, that are slid until sliding is steady


def steps_for(problem: Problem, wanted: float) -> Numbers:
    """Return the least m whose errors of mu_1 and jump are below the wanted one, as far as it fits.

    A power of two times four, MOST_STEPS and MOST_SAMPLES at most.
    """
    steps = np.full(np.shape(problem.load), LEAST_STEPS)
    for _ in range(2):
        finer = 2 * steps
        coarse = np.maximum(_mu_1_error(problem, steps), _jump_error(problem, steps)) > wanted
        fits = (problem.elements * finer) ** 2 <= MOST_SAMPLES
        steps = np.where(coarse & fits & (finer <= MOST_STEPS), finer, steps)
    return steps


def _mu_1_error(problem: Problem, steps: Numbers, refine: bool = True) -> Numbers:
    """Return the error of mu_1 (and mu_2), of second order."""
    return 0.12 * (1.0 + 0.6 / speed_ratio(problem)) / np.asarray(steps) ** 2.0


def _jump_error(problem: Problem, steps: Numbers, refine: bool = True) -> Numbers:
    """Return the error of the jump, of second order."""
    return 2.0 * _mu_1_error(problem, steps)


def _relaxation_rate_error(problem: Problem, steps: Numbers, refine: bool = True) -> Numbers:
    """Return the error of b."""
    return 2.0 * _mu_1_error(problem, steps)


def passes_of(problem: Problem, steps: Numbers, march_steps: Numbers, asked: Quantities) -> Numbers:
    """Return passes of conjugate gradients for steady sliding, and for the march."""
    samples = problem.elements * steps
    slid = MEMORY * np.abs(problem.speed) * steps
    states = 1.0 + (asked.steady or asked.relaxation) * np.abs(problem.ratio)
    return COLD * samples / 128.0 + WARM * slid * states, WARM * march_steps


def _mu_1_scatter(problem: Problem) -> Numbers:
    """Return the scatter of mu_1 (and mu_2) of one map."""
    return 0.5 / np.sqrt(problem.elements) + 0.0 * problem.load


def _jump_scatter(problem: Problem) -> Numbers:
    """Return the scatter of the jump of one map."""
    return 2.0 * _mu_1_scatter(problem)


def _relaxation_rate_scatter(problem: Problem) -> Numbers:
    """Return the scatter of b of one map."""
    return 4.0 * _mu_1_scatter(problem)


OF_MAPS = {
    "mu_1": Laws(_mu_1_error, _mu_1_scatter),
    "jump": Laws(_jump_error, _jump_scatter),
    "relaxation_rate": Laws(_relaxation_rate_error, _relaxation_rate_scatter),
}


def laws_of(problem: Problem) -> Mapping[str, Laws]:
    """Return the laws of the estimates of one problem; none where they are not known."""
    if problem.surface.body == HALF_SPACE:
        return {} if problem.programme else OF_MAPS
    return LAWS if known(problem) else {}
