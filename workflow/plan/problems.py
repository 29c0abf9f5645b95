"""Exact similarity: many points of the grid are one dimensionless problem, computed once.

mu/grad z, d/h and t/tau depend on H, N = L/dx, Fbar = F_N/(4 G L h), vbar = v1 tau/dx and
r = v2/v1 alone; h and F_N enter only as F_N/h.
"""

import math
from functools import lru_cache

import numpy as np

from kernels import amplitudes, rms_slope
from kernels.realization import LOADS, SPEEDS
from kernels.rheology.kelvin import SHORTEST
from workflow.errors import UserError
from workflow.simulate.tasks import Problem
from workflow.study.grid import AXES
from workflow.study.numerics import Numerics
from workflow.study.study import Scene, Study

MANTISSA_BITS = 40  # values closer than 1e-12 are one: rounding of the input must not split them


def canonical(values: np.ndarray) -> np.ndarray:
    """Round to 40 bits of mantissa; commutes with scaling by powers of two."""
    mantissa, exponent = np.frexp(values)
    return np.ldexp(np.round(np.ldexp(mantissa, MANTISSA_BITS)), exponent - MANTISSA_BITS)


def distinct_problems(study: Study) -> tuple[list[Problem], np.ndarray]:
    """Return the distinct problems and, per grid point, the index of its problem.

    The index array has the shape of the grid (study.AXES). Raises UserError for loads and speeds
    that the kernels refuse (kernels/realization.py).
    """
    axes = [np.array(study.grid[axis]) for axis in AXES]
    hurst, force, spacing, roughness, velocity, step = np.meshgrid(*axes, indexing="ij")
    elements = np.round(study.length / spacing).astype(int)
    with np.errstate(over="ignore", under="ignore", divide="ignore", invalid="ignore"):
        load = force / (4.0 * study.shear_modulus * study.length * roughness)
        speed = velocity * study.relaxation_time / (study.length / elements)
    _check("normal_force", "F_N/(4 G L h)", load, LOADS)
    _check("velocity", "v1 tau/dx", speed, SPEEDS)
    load, speed, ratio = canonical(load), canonical(speed), canonical(1.0 + step)
    columns = [a.ravel().tolist() for a in (hurst, elements, load, speed, ratio)]
    found: dict[Problem, int] = {}
    index = [found.setdefault(Problem(*row), len(found)) for row in zip(*columns, strict=True)]
    return list(found), np.array(index).reshape(study.shape)


def viscous_pressure(problem: Problem) -> float:
    """Return vbar grad z, the viscous pressure on a mean slope in units of G h."""
    return problem.speed * _slope(problem.hurst, problem.elements)


@lru_cache
def _slope(hurst: float, elements: int) -> float:
    return rms_slope(amplitudes(hurst, elements), elements)


def _check(axis: str, name: str, values: np.ndarray, limits: tuple[float, float]) -> None:
    """Raise UserError where a dimensionless number leaves its limits; NaN does."""
    low, high = values.min(), values.max()
    if not (limits[0] <= low and high <= limits[1]):
        raise UserError(
            f"grid.{axis}: {name} runs from {low:.3g} to {high:.3g}, but must lie between "
            f"{limits[0]:g} and {limits[1]:g}"
        )


MAX_SAMPLES_PER_LINE = 6_000_000  # keeps a worker below 1 GiB
MIN_STEPS = 8


def speed_ratio(speed: float) -> float:
    """Return x = v1 tau q_max = pi vbar (the abscissa of figure 7)."""
    return math.pi * speed


def expected_rate(problem: Problem) -> float:
    """Return the rate b to plan for: x^(1 - H) above x = 1 (eq. 13), creep with tau below."""
    return max(1.0, speed_ratio(problem.speed) ** (1.0 - problem.hurst))


def least_steps(problem: Problem, scene: Scene) -> int:
    """Return the least m for what is asked, a power of two: a relaxation needs two steps per tau
    and per relaxation time at the slower speed.
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
    """Raise UserError where a line does not fit into a worker, or rounding would show."""
    if problem.elements * steps > MAX_SAMPLES_PER_LINE:
        raise UserError(
            f"numerics.steps_per_spacing = {numerics.steps_per_spacing or 'auto'}: "
            f"{problem.elements} elements at v tau/dx = {problem.speed:.3g} need {steps} steps per "
            f"spacing, more than {MAX_SAMPLES_PER_LINE} samples per line; set a smaller number, "
            "a higher velocity or a larger spacing"
        )
    _check_speeds(problem, steps)


def _check_speeds(problem: Problem, steps: int) -> None:
    """Raise UserError for speeds that the kernels refuse (kernels/realization.py)."""
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
