"""Dimensionless scenes of problems, and the quantities requested from the kernels.

Lengths along x are in dx, heights in h, times in tau, speeds in dx/tau.
"""

import hashlib
from typing import Any, NamedTuple

import numpy as np

from ... import kernels
from ...kernels import MAX_PROGRAMME_STEPS, Origin, Quantities, rms_slope
from ...kernels.drive import FORCE_TOLERANCE, Drive, drive_legs
from ...kernels.half_space.surface import rms_slope_of
from ...kernels.scene import SCENE_QUANTITIES
from ..ground import UserError
from ..simulate import LineShape, Problem, Recording, ScaledHistory, max_leg_counts, programme_steps
from ..study import (
    FOUNDATION,
    HALF_SPACE,
    FromFile,
    HoldSegment,
    Oscillate,
    RampSegment,
    Scene,
    Segment,
    SlideSegment,
    Spring,
    Study,
    Surface,
    Velocity,
    accuracy_estimates,
)
from .shortest_wave import ROUGHEST_WAVE, shortest_wave

MANTISSA_BITS = 40  # to 1e-12: values that differ by input rounding become equal
MAX_ROUNDING_SHARE = 0.02  # rounding error of a force over its tolerance; at 1 no step converges


def canonical(values: np.ndarray) -> np.ndarray:
    """Round to 40 bits of mantissa; commutes with scaling by powers of two."""
    mantissa, exponent = np.frexp(values)
    return np.ldexp(np.round(np.ldexp(mantissa, MANTISSA_BITS)), exponent - MANTISSA_BITS)


def rounded(value: float) -> float:
    """Return a single value, rounded by ``canonical``."""
    return float(canonical(np.array(value)))


class Scale(NamedTuple):
    """Units of a point of the grid in SI, and its velocity."""

    spacing: float  # dx, m
    tau: float  # s
    roughness: float  # h, m
    reference: float  # velocity, m/s
    stiffness: float  # E* L of the lines, N/m
    normal_force: float  # N


def with_scene(base: Problem, scene: Scene, scale: Scale, depth: float) -> Problem:
    """Return a problem with the programme, start, control and drive of a scene, if it has any.

    depth : prescribed indentation, m; NaN if the study has none.
    """
    if not scene.programme:
        return base
    indentation: float | ScaledHistory | None = None
    if scene.indentation_history is not None:
        times, depths = scene.indentation_history
        indentation = (
            tuple(rounded(time / scale.tau) for time in times),
            tuple(rounded(value / scale.roughness) for value in depths),
        )
    elif scene.control == "indentation":
        indentation = rounded(depth / scale.roughness)
    programme = tuple(_leg(segment, scale) for segment in scene.segments)
    speed, ratio = _speeds(scene, scale)
    return base._replace(
        speed=speed,
        ratio=ratio,
        programme=programme,
        start=scene.start,
        indentation=indentation,
        drive=_drive(scene.drive, scale),
    )


def _drive(spring: Spring | None, scale: Scale) -> Drive | None:
    """Return a drive in units of E* L h^2/dx (force), dx (length) and tau (time)."""
    if spring is None:
        return None
    unit = scale.stiffness * (scale.roughness / scale.spacing) ** 2  # of a spring, N/m
    stiffness, mass, damping, per_normal_force = spring
    if per_normal_force:
        unit /= scale.normal_force
    return Drive(
        rounded(stiffness / unit),
        rounded(mass / (unit * scale.tau**2)),
        rounded(damping / (unit * scale.tau)),
    )


def _speeds(scene: Scene, scale: Scale) -> tuple[float, float]:
    """Return the speed before the first velocity step, and the ratio of speeds of this step.

    Without a step the speed is the initial one of the programme or, if that is zero, the typical
    speed.
    """
    segments = scene.segments
    steps = scene.velocity_steps
    if steps:
        pair = [s for s in segments[steps[0] : steps[0] + 2] if isinstance(s, SlideSegment)]
        before, after = (slide.velocity.at(scale.reference) for slide in pair)
        return rounded(before * scale.tau / scale.spacing), after / before
    speed = scene.start_velocity(scale.reference) or scene.typical_speed
    return rounded(speed * scale.tau / scale.spacing), 1.0


def line_modes(surface: Surface, elements: int, roughness: float) -> LineShape:
    """Return the dimensionless description of lines with this number of elements.

    roughness : of lines of a measured spectrum, m.
    """
    profile, base, on_map = surface.profile, surface.spectrum, surface.body == HALF_SPACE
    shortest = shortest_wave(surface, elements) if on_map else ROUGHEST_WAVE
    slope_of = rms_slope_of if on_map else rms_slope
    if surface.power is not None:
        drawn = surface.drawn_amplitudes(elements) / roughness
        random = LineShape(*surface.modes(elements), body=surface.body, shortest=shortest)
        identity = hashlib.sha256(drawn.tobytes()).hexdigest()
        return random._replace(slope=slope_of(drawn, elements), spectrum=identity)
    if profile is None or base is None:
        return LineShape(*surface.modes(elements), body=surface.body, shortest=shortest)
    slope = slope_of(base / profile.roughness, elements)
    flat = on_map and profile.heights.shape[1] == 1
    periods = 0.0 if on_map else profile.length / surface.pressed_width
    waves = periods if periods > 1.0 else 0.0  # mirrored lines have a period of 2 L
    return LineShape(waves, 0, surface.identity, slope, surface.body, flat, shortest)


def _leg(segment: Segment, scale: Scale) -> kernels.Leg:
    dx, tau = scale.spacing, scale.tau

    def speed(velocity: Velocity) -> float:
        return rounded(velocity.at(scale.reference) * tau / dx)

    match segment:
        case SlideSegment():
            metres = abs(segment.velocity.at(scale.reference)) * segment.seconds(scale.reference)
            distance = metres if segment.distance is None else segment.distance
            return kernels.Slide(speed(segment.velocity), rounded(distance / dx))
        case HoldSegment():
            (duration,) = segment.durations
            return kernels.Hold(rounded(duration / tau))
        case RampSegment():
            ends = speed(segment.first), speed(segment.last)
            return kernels.Ramp(*ends, rounded(segment.duration / tau))
        case Oscillate():
            amplitude, frequency = rounded(segment.amplitude / dx), rounded(segment.frequency * tau)
            return kernels.Oscillation(
                speed(segment.velocity), amplitude, frequency, segment.cycles
            )
        case FromFile():
            times = tuple(rounded(time / tau) for time in segment.times)
            return kernels.Sampled(times, tuple(rounded(v * tau / dx) for v in segment.velocities))


def check_programme(problem: Problem, steps: Any, origin: Origin) -> None:
    """Raise UserError for more than MAX_PROGRAMME_STEPS steps, and for steps lost in rounding.

    A drive that never moves the line is an error too. steps : numbers of steps per spacing of the
    problems that share this programme.
    """
    programme = problem.programme
    if problem.drive:
        _check_pull(problem, problem.drive)
    for m in np.unique(steps) if programme else ():
        counts = max_leg_counts(problem, int(m), origin)
        if counts.sum() > MAX_PROGRAMME_STEPS:
            leg = int(np.argmax(counts))
            raise UserError(
                f"scene.programme: takes {counts.sum():.3g} steps, {counts[leg]:.3g} of them in "
                f"segment {leg} ({type(programme[leg]).__name__.lower()}), more than "
                f"{MAX_PROGRAMME_STEPS:g}: shorten it, or take a larger grid.spacing or fewer "
                "numerics.steps_per_spacing"
            )
        try:
            programme_steps(problem, int(m), origin)
        except ValueError as error:
            raise UserError(f"scene.programme: {error} (lengths in dx, times in tau)") from error


def _check_pull(problem: Problem, drive: Drive) -> None:
    """Raise UserError if the force of a drive is negligible, or its balance is lost in rounding.

    A line at rest has no static friction, and creeps under any resolved force. The rounding error
    of a force must lie well below the tolerance of the force balance.
    """
    legs = list(drive_legs(problem.programme, 0.0))
    stretch = max(np.abs(course.place).max() for course in legs)
    most = drive.stiffness * stretch
    most += drive.damping * max(np.abs(course.speed).max() for course in legs)
    share = most / (problem.load * problem.surface.slope)
    if problem.start != "steady" and np.min(share) <= FORCE_TOLERANCE:
        raise UserError(
            f"scene.drive.stiffness: the spring pulls with {np.min(share):.2g} of F_N times the "
            f"rms slope at most, and forces are balanced to {FORCE_TOLERANCE:g} of it: the line "
            "never moves; give a larger stiffness, or a longer travel of the drive"
        )
    if np.max(share) * np.finfo(float).eps > MAX_ROUNDING_SHARE * FORCE_TOLERANCE:
        raise UserError(
            f"scene.drive: spring and damper pull with up to {np.max(share):.2g} of F_N times the "
            f"rms slope, and forces are balanced to {FORCE_TOLERANCE:g} of it, which is lost in "
            "rounding; give a smaller stiffness or damping"
        )


def kernel_quantities(study: Study) -> Quantities:
    """Return the quantities requested from the kernels; a relaxation includes the jump."""
    requested = study.scene.quantities
    curve = any(name in requested for name in ("relaxation", "peak", "rate_state"))
    sheared = any(effects.shear for effects in study.effects.values())
    return Quantities(
        steady="steady" in requested,
        jump="jump" in requested or curve,
        relaxation=curve,
        indentation_rate=study.scene.indentation_rate,
        initial_rate="peak" in requested and not all(m.jumps for m in study.materials.values()),
        areas=sheared,
    )


FINER = 4  # blocks whose first line is also run with halved steps


def recording_of(study: Study, label: str) -> Recording:
    """Return the Recording of the marches of a variant.

    No law gives the discretisation error of measured lines and random lines like them. If "auto"
    chooses the steps, the error is measured by halving the steps on a few of these lines.
    """
    requested, numerics, surface = (
        study.scene.quantities,
        study.variants[label],
        study.surfaces[label],
    )
    random = surface.profile is None and surface.power is None
    lawless = not random and surface.body == FOUNDATION
    traced = any(name in requested for name in ("trace", "loop", "healing", "energy"))
    return Recording(
        samples=numerics.curve_samples,
        record=numerics.record,
        every=numerics.trace or 0,
        requested=tuple(
            value
            for value in SCENE_QUANTITIES
            if (traced if value == "trace" else value in requested)
        ),
        dense=tuple(name for name in ("loop", "healing") if name in requested),
        refined_blocks=FINER
        if lawless and numerics.refines and accuracy_estimates(requested)
        else 0,
        one_slider=study.scene.drive is not None and study.realizations == 1,
        tiles=round(surface.copies) * surface.tiles if study.realizations == 1 else 0,
    )
