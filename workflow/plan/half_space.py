"""Settings for a half-space: steps per spacing, errors and memory, by measured laws.

The functions take a problem or a stack of problems, like the laws of the foundation
(error_laws.py, cost.py). A map has (N m)^2 samples, and eight per shortest wave at m = 4.

Errors: 15 problems at H = 0.7, N = 16, sigma_0/(E* grad z) 0.01 ... 0.2, x 0.3 ... 30, four maps
each with m = 2, 4, 8 against m = 16. The error of mu_1 was 1 to 2.4 % at m = 4 and at most 0.5 % at
m = 8, for any load and x. With many samples per contact patch the error of the jump is as small;
with n samples per patch it is up to 2/n.

Scatter: standard error times the root of the number of maps; 264 problems, sigma_0/(E* grad z)
0.002 ... 0.6, x 0.1 ... 30, H 0 ... 1, side of one or two longest waves, N 8 ... 64. Two in three
are within a factor of 1.6. No law describes the scatter of b.
"""

from functools import partial

import numpy as np

from ..simulate import Problem
from ..study import HALF_SPACE
from .error_laws import LAWS, Laws
from .problems import Numbers, line_slope, nominal_pressure, speed_ratio

LEAST_OF_MAPS, MOST_STEPS = 4, 16
MOST_SAMPLES = 4096**2  # of a map; a worker then needs 4 GiB and more
# Memory measured on maps of 512^2 and 1024^2 samples, without branches and with 13.
MAP_BYTES, BRANCH_BYTES = 260.0, 25.0  # per sample; the second for each branch
# Terms of ln(scatter): constant, and coefficients of ln(contact area), ln(free area), ln(longest
# waves per side), ln(elements per longest wave), H and ln(x).
SCATTER = {
    "mu_1": (-1.09, -0.40, 0.37, -1.12, -0.87, 0.87, -0.14),
    "jump": (-0.28, -0.40, 0.43, -1.20, -1.00, 0.63, -0.02),
}
LEAST_FREE = 0.1  # smallest free area at which the scatter was measured


def steps_for(problem: Problem, wanted: float) -> Numbers:
    """Return the smallest m of 4, 8, 16 whose errors of mu_1 and jump are at most ``wanted``.

    If no map with at most MOST_SAMPLES samples reaches it, return the largest m that fits.
    """
    steps = np.full(np.shape(problem.load), LEAST_OF_MAPS)
    for _ in range(2):
        finer = 2 * steps
        errors = [expected_error(name, problem, steps) for name in ("mu_1", "jump")]
        coarse = np.maximum(*errors) > wanted
        steps = np.where(coarse & may_be_so_fine(problem, finer), finer, steps)
    return steps


def may_be_so_fine(problem: Problem, steps: Numbers) -> Numbers:
    """Return whether a map with these steps per spacing fits a worker, and m <= MOST_STEPS."""
    return ((problem.elements * steps) ** 2 <= MOST_SAMPLES) & (steps <= MOST_STEPS)


def map_error(name: str, steps: Numbers, samples: Numbers) -> Numbers:
    """Return the error of an estimate. samples : per connected contact patch."""
    whole = 0.38 / np.asarray(steps) ** 2.0
    if name == "mu_1":
        return whole
    patches = np.minimum(2.0 / np.maximum(samples, 1.0), 1.0)
    return np.hypot(whole if name == "jump" else 2.0 * whole, patches)


def expected_samples(problem: Problem, steps: Numbers) -> Numbers:
    """Return the expected samples per contact patch, within a factor of two at best."""
    load = nominal_pressure(problem) / line_slope(problem)
    patch = 1500.0 * load**0.9 / (1.0 + speed_ratio(problem) / 2.5)
    return np.maximum(patch, 3.0) * np.asarray(steps) ** 2.0 / 16.0


def expected_error(name: str, problem: Problem, steps: Numbers, refine: bool = True) -> Numbers:
    """Return the predicted error of an estimate.

    refine : ignored, as contacts of maps are not located between the samples.
    """
    return map_error(name, steps, expected_samples(problem, steps))


def expected_area(problem: Problem) -> Numbers:
    """Return the expected share of real contact; nine in ten measurements are 0.7 to 1.2 times it.

    For light loads and slow sliding, which does not stiffen the elastomer, it is that of Persson's
    theory, 2.26 sigma_0/(E* grad z).
    """
    load = nominal_pressure(problem) / line_slope(problem)
    stiffer = np.hypot(1.0, speed_ratio(problem) / (0.83 + 0.77 * problem.hurst))
    return np.tanh(2.26 * load / stiffer)


def expected_scatter(name: str, problem: Problem) -> Numbers:
    """Return the scatter of an estimate from map to map."""
    constant, touching, free, longest, shortest, rough, fast = SCATTER[name]
    waves, area = max(problem.surface.rolloff, 1.0), expected_area(problem)
    contacts = area**touching * np.maximum(1.0 - area, LEAST_FREE) ** free
    spectrum = waves**longest * (problem.elements / waves) ** shortest
    size = np.exp(constant + rough * problem.hurst)
    return size * contacts * spectrum * speed_ratio(problem) ** fast


LAWS_OF_MAPS = {
    name: Laws(partial(expected_error, name), partial(expected_scatter, name)) for name in SCATTER
}


def laws_of(problem: Problem) -> dict[str, Laws]:
    """Return the laws of the estimates of a problem, on either body."""
    return LAWS_OF_MAPS if problem.surface.body == HALF_SPACE else LAWS
