"""Steps per spacing and horizon of each problem."""

import math
from functools import lru_cache

from kernels.realization import SPEEDS
from kernels.rheology.kelvin import SHORTEST
from workflow.errors import UserError
from workflow.kinetic_law import exponent
from workflow.plan.problems import speed_ratio
from workflow.simulate import Problem
from workflow.study import Numerics, Scene

MAX_SAMPLES_PER_LINE = 6_000_000  # keeps a worker below 1 GiB
MIN_STEPS = 8


def expected_rate(problem: Problem) -> float:
    """Return the rate b to plan for (eq. 13): x^(1 - H) above x = 1, creep with tau below."""
    return _rate(speed_ratio(problem), problem.hurst)


@lru_cache(maxsize=100_000)  # thousands of problems of a grid share x and H
def _rate(x: float, hurst: float) -> float:
    return x ** float(exponent(x, hurst, time_below_one=True))


def least_steps(problem: Problem, scene: Scene) -> int:
    """Return the least m for what is asked, a power of two.

    A relaxation needs two steps per tau and per relaxation time at the slower speed.
    """
    if "relaxation" not in scene.quantities:
        return 1
    slowest = problem.speed * min(1.0, problem.ratio)
    need = 2.0 * expected_rate(problem) / max(slowest, SPEEDS[0])
    return 2 ** max(0, math.ceil(math.log2(need) - 1e-9))


def steps_per_spacing(problem: Problem, scene: Scene, numerics: Numerics) -> int:
    """Return m: the given number, or for "auto" a power of two resolving what is asked.

    Contacts need 8 samples per spacing when only steady states and jumps are asked for, and 4
    beside a relaxation; b is then within about 2 % of its limit (5 % at H = 0). First order schemes
    take 8 times as many.
    """
    steps = numerics.steps_per_spacing
    if steps is None:
        marched = "relaxation" in scene.quantities
        steps = max(4 if marched else 8, least_steps(problem, scene))
        if numerics.scheme == "implicit-euler":
            steps *= 8
    check_resolution(problem, steps, numerics)
    return steps


def check_resolution(problem: Problem, steps: int, numerics: Numerics) -> None:
    """Raise UserError where a line does not fit into a worker, or rounding would show.

    The kernels refuse the same speeds (kernels/realization.py).
    """
    if problem.elements * steps > MAX_SAMPLES_PER_LINE:
        raise UserError(
            f"numerics.steps_per_spacing = {numerics.steps_per_spacing or 'auto'}: "
            f"{problem.elements} elements at v tau/dx = {problem.speed:.3g} need {steps} steps per "
            f"spacing, more than {MAX_SAMPLES_PER_LINE} samples per line; set a smaller number, "
            "a higher velocity or a larger spacing"
        )
    speeds = (problem.speed, problem.speed * problem.ratio)
    if min(speeds) < SPEEDS[0] or steps * max(speeds) * SHORTEST > 1.0:
        raise UserError(
            f"grid.velocity: v tau/dx runs from {min(speeds):.3g} to {max(speeds):.3g}, but must "
            f"lie between {SPEEDS[0]:g} and {1.0 / SHORTEST / steps:.3g}, where rounding shows"
        )


def horizon_steps(problem: Problem, numerics: Numerics, steps: int) -> int:
    """Return the number of steps to march: ``horizon`` expected relaxation times, at least 8."""
    time = numerics.horizon / expected_rate(problem)
    return max(MIN_STEPS, math.ceil(time * steps * problem.speed * problem.ratio))
