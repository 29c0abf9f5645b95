"""Exact similarity: grid points with equal dimensionless numbers are one problem, computed once.

mu/grad z, d/h and t/tau depend only on H, N = L/dx, Fbar = F_N/(4 G L h), vbar = v1 tau/dx and
r = v2/v1; h and F_N enter only as F_N/h. A scene adds the spectrum of the material in units of G
and tau, the modes of the lines and its programme. Each value of an axis that changes the material,
the lines or the scene (study/axes.py) has its own spectrum, modes or programme.
"""

import math
from functools import cache
from typing import Any

import numpy as np

from ...kernels import NO_EFFECTS, Effects, Spectrum, amplitudes, rms_slope
from ...kernels.half_space.surface import ring_amplitudes, rms_slope_of
from ...kernels.model.limits import LOAD_LIMITS, SPEED_LIMITS
from ...kernels.velocity_step.prepared import MIN_RATIO_STEP
from ..ground import UserError
from ..kinetic_law import relaxation_rate
from ..simulate import Problem
from ..study import FOUNDATION, HALF_SPACE, Material, Parts, Study, axes_of, check_load
from .motion import Scale, canonical, line_modes, rounded, with_scene
from .scaled_effects import check_shear_range, scaled_effects

LEAST_CHANGE = 1e-13  # |dv/v1| vbar; below it rounding is over 1e-3 of the jump
TYPICAL_HURST = 0.8  # assumed for measured lines, only in predictions
Numbers = Any  # a number, or an array with one entry per problem of a stack
Points = dict[str, np.ndarray]  # axis -> values at all points of the grid


def distinct_problems(study: Study, label: str = "") -> tuple[list[Problem], np.ndarray]:
    """Return the distinct problems of a variant and, per grid point, the index of its problem.

    The index array has the shape of the grid (study.axes). Raises UserError for loads and speeds
    that the kernels refuse (kernels/velocity_step/cases.py).
    """
    numbers = axes_of(study.grid, "grid")
    axes = [np.array(study.grid[axis]) for axis in numbers]
    points = dict(zip(numbers, np.meshgrid(*axes, indexing="ij"), strict=True))
    length = study.surface.profile.length if study.surface.profile else study.surface.length
    points["elements"] = np.round(length / points["spacing"]).astype(int)
    points["dx"] = length / points["elements"]
    all_parts = study.parts(label, axes_of(study.grid, *Parts._fields))
    settings: dict[Problem, int] = {}
    pulled = study.surface.length / (study.force_share(label) * study.surfaces[label].copies)
    which = np.stack([_settings(parts, points, settings, pulled) for parts in all_parts], axis=-1)
    hursts = np.where(np.isnan(points["hurst"]), TYPICAL_HURST, points["hurst"])
    columns = (
        hursts[..., None],
        points["elements"][..., None],
        *_numbers(study, label, all_parts, points),
    )
    rows = [np.broadcast_to(problem, which.shape).ravel().tolist() for problem in (*columns, which)]
    indices: dict[tuple, int] = {}
    index = [indices.setdefault(row, len(indices)) for row in zip(*rows, strict=True)]
    bases, problems = list(settings), []
    for hurst, elements, load, speed, ratio, setting in indices:
        problem = bases[setting]._replace(hurst=hurst, elements=elements, load=load)
        if not problem.programme:  # a programme has its own speeds
            problem = problem._replace(speed=speed, ratio=ratio)
        check_shear_range(f"compare.{label}" if label else "scene", problem)
        problems.append(problem)
    return problems, np.array(index).reshape(study.shape)


def stack_problems(problems: list[Problem]) -> list[tuple[np.ndarray, Problem]]:
    """Return pairs (indices of problems, stack); a stack is a problem whose fields are arrays.

    The problems of a stack share all fields except the five numbers of the paper, of shape (P,),
    and the slopes of their lines, which are part of the surface.
    """
    rows: dict[tuple, list[int]] = {}
    for row, problem in enumerate(problems):
        rows.setdefault(problem[5:], []).append(row)
    stacks = []
    for others, chosen in rows.items():
        table = np.array([problems[row][:5] for row in chosen])
        hurst, elements, *numbers = np.ascontiguousarray(table.T)
        many = Problem(hurst, elements.astype(int), *numbers, *others)
        lines = {problems[row][:2]: problems[row] for row in chosen}
        slopes = {line: line_slope(problem) for line, problem in lines.items()}
        slope: Numbers = np.array([slopes[problems[row][:2]] for row in chosen])
        many = many._replace(surface=many.surface._replace(slope=slope))
        stacks.append((np.array(chosen), many))
    return stacks


def _settings(
    parts: Parts, points: Points, indices: dict[Problem, int], length: float
) -> np.ndarray:
    """Return the index of the setting of each point; new settings are added to ``indices``.

    A setting is a problem without its numbers, given by material, lines and scene.
    length : total length of the lines that one drive pulls, m.
    """
    names = ["elements"]
    if parts.scene.programme or any(parts.scene.effects):
        names += ["dx", "roughness"]
    if parts.scene.programme:
        names += ["velocity"]
        names += ["prescribed_indentation"] if "prescribed_indentation" in points else []
    if parts.scene.drive and parts.scene.drive.per_normal_force:
        names += ["normal_force"]
    rows = np.stack([points[name].ravel() for name in names], axis=1)
    different, inverse = np.unique(rows, axis=0, return_inverse=True)
    spectrum, tau, nan = _rounded_spectrum(parts.material), parts.material.tau, math.nan
    stiffness = parts.material.contact_modulus * length
    height = float(points["roughness"].flat[0])  # one value for a measured spectrum
    plain = {
        count: Problem(
            *(0.0, 0, 0.0, 0.0, 0.0, spectrum, line_modes(parts.surface, count, height)),
            effects=_effects(parts, count),
        )
        for count in {int(row[0]) for row in different}
    }
    index = []
    for row in different.tolist():
        at = dict(zip(names, row, strict=True)).get
        units = at("dx", nan), tau, at("roughness", nan)
        scale = Scale(*units, at("velocity", nan), stiffness, at("normal_force", nan))
        depth = at("prescribed_indentation", nan)
        problem = with_scene(plain[int(row[0])], parts.scene, scale, depth)
        effects = scaled_effects(parts.scene.effects, parts.material, scale, problem.effects)
        problem = problem._replace(effects=effects)
        index.append(indices.setdefault(problem, len(indices)))
    return np.array(index)[inverse].reshape(points["elements"].shape)


def _effects(parts: Parts, elements: int) -> Effects:
    """Return the effects on which the records of a problem depend."""
    material, surface = parts.material, parts.surface
    if surface.body == FOUNDATION:
        return NO_EFFECTS
    length = surface.profile.length if surface.profile else surface.length
    layer = material.layer(length / elements)
    return Effects(layer=layer and layer._replace(thickness=rounded(layer.thickness)))


def _numbers(study: Study, label: str, all_parts: list[Parts], points: Points) -> list[np.ndarray]:
    """Return load, speed and ratio at all points; last axis : all_parts."""
    modulus = np.array([parts.material.contact_modulus for parts in all_parts])
    tau = np.array([parts.material.tau for parts in all_parts])
    at = {axis: values[..., None] for axis, values in points.items()}
    with np.errstate(over="ignore", under="ignore", divide="ignore", invalid="ignore"):
        unit = modulus * study.surface.length * at["roughness"]
        load = study.force_share(label) * at["normal_force"] / unit
        load *= study.surfaces[label].copies
        speed = at["velocity"] * tau / at["dx"]
    if study.scene.control == "indentation":
        load = np.zeros_like(load)
    else:
        _check("normal_force", "F_N/(4 G L h)", load, LOAD_LIMITS)
        if study.surface.profile is not None:
            check_load(study.surface.profile, load)
    if study.scene.moves:
        _check("velocity", "v1 tau/dx", speed, SPEED_LIMITS)
    if study.scene.programme:  # a programme has its own speeds
        speed, step = np.zeros_like(speed), np.zeros_like(speed)
    else:
        step = np.broadcast_to(at["velocity_step"], speed.shape)
        _check_steps(step, speed)
    # Ratios are given by the user; rounding would change a small step.
    return [canonical(load), canonical(speed), 1.0 + step]


def _rounded_spectrum(material: Material) -> Spectrum:
    """Return the spectrum of a material, rounded like every part of a problem."""
    moduli, times, viscosity = material.spectrum()
    return Spectrum(tuple(map(rounded, moduli)), tuple(map(rounded, times)), rounded(viscosity))


def speed_ratio(problem: Problem) -> Numbers:
    """Return x = v1 tau q_max, the abscissa of figure 7; pi vbar without cutoff (q_max = pi/dx)."""
    if problem.surface.cutoff:
        return abs(problem.speed) * 2.0 * math.pi * problem.surface.cutoff / problem.elements
    return math.pi * abs(problem.speed)


def expected_rate(problem: Problem) -> Numbers:
    """Return the expected rate b (eq. 13): x^(1 - H) above x = 1, and 1 (creep with tau) below."""
    return relaxation_rate(speed_ratio(problem), problem.hurst, time_below_one=True)


def nominal_pressure(problem: Problem) -> float:
    """Return the nominal pressure, in E* h/dx; on a foundation F_N = sigma_0 lambda_r L."""
    longest = max(problem.surface.rolloff, 1.0)  # wave number of lambda_r, in 2 pi/L
    shared = 1.0 if problem.surface.body == HALF_SPACE else longest
    return problem.load * shared / problem.elements


def viscous_pressure(problem: Problem) -> Numbers:
    """Return vbar grad z, the viscous pressure at the rms slope, in units of G h."""
    return abs(problem.speed) * line_slope(problem)


def line_slope(problem: Problem, normalisation: str = "modal") -> Numbers:
    """Return the spectral rms slope of the lines of a problem, in h/dx."""
    rolloff, cutoff, _, slope, body, *_ = problem.surface
    if problem.surface.given or np.ndim(slope):  # arrays belong to a stack of problems
        return slope
    return _slope(body, problem.hurst, problem.elements, normalisation, rolloff, cutoff)


@cache
def _slope(
    body: str, hurst: float, elements: int, normalisation: str, rolloff: float, cutoff: int
) -> float:
    if body == HALF_SPACE:
        of_ring = ring_amplitudes(hurst, elements, rolloff, cutoff, normalisation)
        return rms_slope_of(of_ring, elements)
    return rms_slope(amplitudes(hurst, elements, normalisation, rolloff, cutoff), elements)


def _check_steps(step: np.ndarray, speed: np.ndarray) -> None:
    """Raise UserError for a velocity step whose ratio 1 + dv/v1 or jump is lost in rounding."""
    least = np.maximum(MIN_RATIO_STEP, LEAST_CHANGE / speed)
    lost = (step != 0.0) & (np.abs(step) < least)
    if lost.any():
        raise UserError(
            f"grid.velocity_step = {step[lost][0]:g}: at v1 tau/dx = {speed[lost][0]:.3g} must be "
            f"zero, or at least {least[lost][0]:.3g} up or down; a smaller one is lost in rounding"
        )


def _check(axis: str, name: str, values: np.ndarray, limits: tuple[float, float]) -> None:
    """Raise UserError for a dimensionless number beyond its limits, or NaN."""
    low, high = values.min(), values.max()
    if not (limits[0] <= low and high <= limits[1]):
        raise UserError(
            f"grid.{axis}: {name} runs from {low:.3g} to {high:.3g}, but must lie between "
            f"{limits[0]:g} and {limits[1]:g}"
        )
