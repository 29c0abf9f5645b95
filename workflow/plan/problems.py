"""Exact similarity: many points of the grid are one dimensionless problem, computed once.

mu/grad z, d/h and t/tau depend on H, N = L/dx, Fbar = F_N/(4 G L h), vbar = v1 tau/dx and
r = v2/v1 alone; h and F_N enter only as F_N/h.
"""

import math
from functools import cache, lru_cache

import numpy as np

from kernels import amplitudes, rms_slope
from kernels.realization import LEAST_STEP, LOADS, SPEEDS
from workflow.errors import UserError
from workflow.kinetic_law import exponent
from workflow.simulate import Problem
from workflow.study import AXES, Study

MANTISSA_BITS = 40  # values closer than 1e-12 are one: rounding of the input must not split them
LEAST_CHANGE = 1e-13  # |dv/v1| vbar; below it rounding is over 1e-3 of the jump


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
    elements = np.round(study.surface.length / spacing).astype(int)
    with np.errstate(over="ignore", under="ignore", divide="ignore", invalid="ignore"):
        load = force / (4.0 * study.material.shear_modulus * study.surface.length * roughness)
        speed = velocity * study.material.tau / (study.surface.length / elements)
    _check("normal_force", "F_N/(4 G L h)", load, LOADS)
    _check("velocity", "v1 tau/dx", speed, SPEEDS)
    _check_steps(step, speed)
    load, speed = canonical(load), canonical(speed)
    ratio = 1.0 + step  # follows from no other value; rounding would make a small step another one
    columns = [a.ravel().tolist() for a in (hurst, elements, load, speed, ratio)]
    found: dict[Problem, int] = {}
    index = [found.setdefault(Problem(*row), len(found)) for row in zip(*columns, strict=True)]
    return list(found), np.array(index).reshape(study.shape)


def speed_ratio(problem: Problem) -> float:
    """Return x = v1 tau q_max = pi vbar (the abscissa of figure 7)."""
    return math.pi * problem.speed


def expected_rate(problem: Problem) -> float:
    """Return the rate b to plan for (eq. 13): x^(1 - H) above x = 1, creep with tau below."""
    return _rate(speed_ratio(problem), problem.hurst)


@lru_cache(maxsize=100_000)  # thousands of problems of a grid share x and H
def _rate(x: float, hurst: float) -> float:
    return x ** float(exponent(x, hurst, time_below_one=True))


def viscous_pressure(problem: Problem) -> float:
    """Return vbar grad z, the viscous pressure on a mean slope in units of G h."""
    return problem.speed * line_slope(problem)


def line_slope(problem: Problem, normalisation: str = "modal") -> float:
    """Return the spectral rms slope of the lines of a problem, in h/dx."""
    return _slope(problem.hurst, problem.elements, normalisation)


@cache
def _slope(hurst: float, elements: int, normalisation: str) -> float:
    return rms_slope(amplitudes(hurst, elements, normalisation), elements)


def _check_steps(step: np.ndarray, speed: np.ndarray) -> None:
    """Raise UserError for a velocity step that 1 + dv/v1 or the jump would lose in rounding."""
    least = np.maximum(LEAST_STEP, LEAST_CHANGE / speed)
    lost = (step != 0.0) & (np.abs(step) < least)
    if lost.any():
        raise UserError(
            f"grid.velocity_step = {step[lost][0]:g}: at v1 tau/dx = {speed[lost][0]:.3g} must be "
            f"zero, or at least {least[lost][0]:.3g} up or down; a smaller one is lost in rounding"
        )


def _check(axis: str, name: str, values: np.ndarray, limits: tuple[float, float]) -> None:
    """Raise UserError where a dimensionless number leaves its limits; NaN does."""
    low, high = values.min(), values.max()
    if not (limits[0] <= low and high <= limits[1]):
        raise UserError(
            f"grid.{axis}: {name} runs from {low:.3g} to {high:.3g}, but must lie between "
            f"{limits[0]:g} and {limits[1]:g}"
        )
