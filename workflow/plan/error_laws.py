"""Laws of error and scatter, by which a wanted accuracy is turned into steps and realizations.

All are relative. Measured with the scheme ``exponential`` on 139 random problems, H 0 ... 1,
Fbar 1e-3 ... 2, x 0.03 ... 100, N 300 ... 3000, r = 1.2: errors against Richardson extrapolation
over m, scatter over 12 to 128 lines (docs/accuracy.md). Errors are upper bounds that 9 in 10
problems keep, most by a factor of 4; the scatter is right within 1.5 for two in three problems.
"""

import math
from collections.abc import Callable
from typing import NamedTuple

from workflow.plan.problems import speed_ratio, viscous_pressure
from workflow.plan.resolution import expected_rate
from workflow.simulate import Problem


class Error(NamedTuple):
    """A discretisation error over m: floor + first / m + second / m^2."""

    floor: float
    first: float
    second: float

    def at(self, steps: int) -> float:
        """Return the error with ``steps`` per spacing."""
        return self.floor + self.first / steps + self.second / steps**2


def mu_1_error(problem: Problem) -> Error:
    """Return the error of mu_1 (and mu_2): second order."""
    _, elements, load, speed, _ = problem
    contacts = load**-0.32 * (1.0 + viscous_pressure(problem) / load) ** 0.41
    line = (elements / 88.0) ** (-1.22 * problem.hurst)
    return Error(0.0, 0.0, 0.060 * contacts * (1.0 + 1.0 / speed) ** 0.92 * line)


def jump_error(problem: Problem) -> Error:
    """Return the error of the jump: second order."""
    _, elements, load, speed, _ = problem
    contacts = load**-0.26 * (1.0 + viscous_pressure(problem) / load) ** 0.61
    line = (elements / 94.0) ** (-1.36 * problem.hurst)
    return Error(0.0, 0.0, 0.158 * contacts * (1.0 + 1.0 / speed) ** 0.68 * line)


def relaxation_rate_error(problem: Problem) -> Error:
    """Return the error of b: first order in the share of a relaxation time that a step takes."""
    share = expected_rate(problem) / (problem.speed * min(1.0, problem.ratio))  # at m = 1
    if speed_ratio(problem) < 1.0:
        return Error(0.003, 0.1 * share, 0.0)
    return Error(0.0, 0.3 * share, jump_error(problem).second)


def mu_1_scatter(problem: Problem) -> float:
    """Return the standard deviation of mu_1 (and mu_2) between lines."""
    hurst, elements, load, _, _ = problem
    contacts = (
        load**-0.09 * (1.0 + load) ** -1.41 * (1.0 + viscous_pressure(problem) / load) ** 0.08
    )
    return 1.04 * contacts * math.exp(-1.54 * hurst) * elements ** (0.30 * hurst - 0.34)


def jump_scatter(problem: Problem) -> float:
    """Return the standard deviation of the jump between lines; heavy tails at light loads."""
    hurst, elements, load, _, _ = problem
    if speed_ratio(problem) < 1.0:
        return mu_1_scatter(problem)
    contacts = (1.0 + load) ** -1.1 * (1.0 + viscous_pressure(problem) / load) ** 0.30
    return 2.6 * contacts * math.exp(-3.35 * hurst) * elements ** (0.633 * hurst - 0.545)


def relaxation_rate_scatter(problem: Problem) -> float:
    """Return the error of b from a mean curve, times the root of the number of lines."""
    hurst, elements, load, _, _ = problem
    x = speed_ratio(problem)
    if x < 1.0:  # creep: b is next to 1, but for heavy loads, where hardly anything relaxes
        return 0.6 if load > 0.1 and x > 0.2 else min(0.1, 0.5 * x)
    contacts = load**0.43 * (1.0 + load) ** -1.32 * (1.0 + viscous_pressure(problem) / load) ** 0.53
    return 0.114 * contacts * math.exp(0.77 * hurst) * elements ** (0.34 * hurst - 0.05)


class Laws(NamedTuple):
    """The laws of one estimate."""

    error: Callable[[Problem], Error]
    scatter: Callable[[Problem], float]


LAWS = {
    "mu_1": Laws(mu_1_error, mu_1_scatter),
    "jump": Laws(jump_error, jump_scatter),
    "relaxation_rate": Laws(relaxation_rate_error, relaxation_rate_scatter),
}
