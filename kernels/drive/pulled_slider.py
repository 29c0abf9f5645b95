"""A slider whose drive follows a programme: initial state, legs of the drive, and results."""

import math
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from ..body.step import Forces
from ..motion.legs import (
    FIRST_HOLD_STEP,
    Hold,
    Programme,
    Sampled,
    Slide,
    leg_duration,
    speed_at_start,
)
from ..motion.path import hold_step_ratio
from ..rheology.spectrum import min_step
from ..scene.records import TRACES
from ..scene.scene_case import SceneCase, check_scene, scene_steps
from .slider_record import SLIDER_TALLY, Moment, SliderRecord, record_between
from .slider_step import (
    FORCE_TOLERANCE,
    SEARCH_MEMORY,
    PulledSlider,
    SliderProgress,
    follow_leg,
)
from .spring import Drive, DriveEnergies, DriveLeg, SliderState, StepEnd, drive_at
from .sticking import StickingSlider

PULLED_TRACES = (*TRACES, "trace_drive_force")
DRIVE_ENERGIES = DriveEnergies._fields
SLIPS = ("drive_swing", "slip_period", "peak_velocity")  # in the second half of the last leg
SLIP_EVENTS = ("slip_event_time", "slip_event_kind")  # time in tau; kind, as SLIP_BEGINS
MAX_SLIP_EVENTS = 1000  # recorded events, at most
SLIDER_ROOM = 40  # recorded steps, at most, per step of the programme
SLIDER_QUANTITIES = ("trace", "stick_slip", "slip_events", "energy")
FIRST_STEP_SHARE = 0.25  # first step after a velocity jump of the drive, over the step before
MIN_FREE_STEPS = 1e3  # min_step_time, over the min_step of the material


def drive_legs(programme: Programme, place: float) -> Iterator[DriveLeg]:
    """Yield the motion of the drive in each leg; place : initial position of the drive, in dx."""
    now = 0.0
    for leg in programme:
        if isinstance(leg, Slide):
            duration = leg.distance / abs(leg.speed)
            times, speeds = np.array([0.0, duration]), np.full(2, leg.speed)
        elif isinstance(leg, Hold):
            times, speeds = np.array([0.0, leg.duration]), np.zeros(2)
        else:
            assert isinstance(leg, Sampled)
            times, speeds = np.array(leg.times), np.array(leg.speeds)
        if times[-1] == 0.0:
            continue
        moved = np.cumsum(np.append(0.0, np.diff(times) * 0.5 * (speeds[1:] + speeds[:-1])))
        yield DriveLeg(now + times, place + moved, speeds)
        now, place = now + float(times[-1]), place + float(moved[-1])


def initial_motion(
    programme: Programme, m: int, first: Moment, end: StepEnd, energies: DriveEnergies
) -> SliderState:
    """Return the motion before the first step: steady sliding or rest; m : steps per spacing."""
    speed = speed_at_start(programme)
    if first.speed:
        dt = 1.0 / (m * abs(speed))
    elif speed:
        dt = FIRST_STEP_SHARE / (m * abs(speed))
    else:
        dt = FIRST_HOLD_STEP * leg_duration(programme[0])
    return SliderState(0.0, 0.0, dt, first.speed, 0.0, -dt, -dt, first.friction, end, energies)


def at_start_of_leg(
    drive: Drive, leg: DriveLeg, time: float, place: float, speed: float, friction: float
) -> StepEnd:
    """Return the StepEnd before the first step of a leg, where the speed of the drive may jump.

    Without a mass, the slider then takes the speed at which the damper carries the friction.
    """
    drive_place, drive_speed = drive_at(leg, time)
    stretch, relative_speed = drive_place - place, drive_speed - speed
    if not drive.mass and drive.damping:
        relative_speed = (friction - drive.stiffness * stretch) / drive.damping
    pull = drive.stiffness * stretch + drive.damping * relative_speed
    inertia = pull - friction if drive.mass else 0.0
    return StepEnd(drive_place, stretch, pull, friction, inertia, relative_speed, speed)


def recorded_times(scene: SceneCase, steps_per_spacing: int) -> np.ndarray:
    """Return the times at which moments of a slider are recorded, in tau.

    They are the times of the recorded steps of the same scene without a spring, or infinite after
    the start if steps of the slider are recorded. Raises ValueError for an invalid scene, and for
    quantities that a slider does not have.
    """
    steps = scene_steps(scene, steps_per_spacing)
    check_scene(scene, steps, False)
    if set(scene.requested) - set(SLIDER_QUANTITIES):
        raise ValueError(
            f"requested = {sorted(scene.requested)}: with a drive use some of {SLIDER_QUANTITIES}"
        )
    if scene.slider_steps:
        return np.append(0.0, np.full(slider_room(steps.dt.size, scene.slider_steps), math.inf))
    return np.append(0.0, np.cumsum(steps.dt))[scene.recorded]


def slider_room(programme_steps: int, every: int) -> int:
    """Return the maximum number of recorded steps if every n-th step of a slider is recorded."""
    return SLIDER_ROOM * programme_steps // every


def initial_speed(scene: SceneCase) -> float:
    """Return the speed of steady sliding at the start of a scene, or 0 for any other start."""
    return speed_at_start(scene.programme) if scene.start == "steady" else 0.0


def pull_through(
    body: Any,
    state: Any,
    surface: Any,
    acting: Forces,
    width: float,
    drive: Drive,
    scene: SceneCase,
    times: np.ndarray,
    follow: Callable[[PulledSlider, DriveLeg, SliderProgress], SliderProgress] = follow_leg,
) -> tuple[dict[str, np.ndarray], Any, int]:
    """Pull a slider through a scene; return (recorded values, state, number of attempted steps).

    body, state : of the elements (body/step.py). surface : Line or Surface. acting, width : Forces
    and patch width before the first step. times : at which to record, in tau. follow : follow_leg,
    or its kernel. A value at the end of a leg is that of the last step of the leg; it is not
    interpolated to the next leg.
    """
    speed, mu, (normal, friction, touching) = initial_speed(scene), acting.mu, acting[1:]
    force = friction if speed else 0.0  # the spring is slack if the slider starts at rest
    m, drive = surface.steps_per_spacing, Drive(*map(float, drive))
    legs = list(drive_legs(scene.programme, force / drive.stiffness))
    end = at_start_of_leg(drive, legs[0], 0.0, 0.0, speed, friction)
    stored = 0.5 * drive.stiffness * end.stretch**2, 0.5 * drive.mass * speed**2
    energies = DriveEnergies(0.0, 0.0, *stored, 0.0, 0.0)
    at_start = normal, friction, touching, width, 0.0, 0.0, speed, force
    moment = Moment(mu, state.d, *at_start, *energies)
    record = _slider_record(scene, m, drive, legs[-1], times)
    scale = scene.load * math.sqrt(float(np.mean(surface.slope**2)))
    min_step_time = MIN_FREE_STEPS * min_step(scene.spectrum)
    limits = min_step_time, FORCE_TOLERANCE * scale, hold_step_ratio(m)
    memory = np.zeros(1, SEARCH_MEMORY)
    slider = PulledSlider if scene.effects.shear is None else StickingSlider
    pulled = slider(body, m, drive, *limits, record, memory)
    motion = initial_motion(scene.programme, m, moment, end, energies)
    record_between(record, moment, moment, 0.0)
    drive_speed = motion.speed
    for leg in legs:
        jumps, drive_speed = float(leg.speed[0]) != drive_speed, float(leg.speed[-1])
        pace = FIRST_STEP_SHARE * motion.dt if jumps else motion.dt
        reached = motion.time, motion.place, motion.end.speed, motion.end.friction
        motion = motion._replace(end=at_start_of_leg(drive, leg, *reached))
        state, motion, last, _ = follow(pulled, leg, SliderProgress(state, motion, moment, pace))
        moment = last._replace(time=float(leg.time[-1]), place=motion.place)
        record_between(record, last, moment, drive_speed)
    return recorded_values(record, moment), state, int(memory[0]["tries"])


def _slider_record(
    scene: SceneCase, m: int, drive: Drive, last_leg: DriveLeg, times: np.ndarray
) -> SliderRecord:
    """Return an empty record; slips are counted in the second half of the last leg."""
    tally = np.zeros(1, SLIDER_TALLY)
    tally["window_start"] = 0.5 * float(last_leg.time[0] + last_leg.time[-1])
    tally["min_force"], tally["max_force"] = math.inf, -math.inf
    tally["slow_since"] = math.inf
    tally["first_slip"] = tally["last_slip"] = math.nan
    half_swing = math.pi * math.sqrt(drive.mass / drive.stiffness)
    fastest = max(abs(float(v)) for v in last_leg.speed)
    min_stick_time = max(half_swing, 1.0 / (m * fastest) if fastest else 0.0)
    room = MAX_SLIP_EVENTS if "slip_events" in scene.requested else 0
    moments, events = np.empty((len(Moment._fields), times.size)), np.full((2, room), math.nan)
    return SliderRecord(times, scene.slider_steps, moments, tally, min_stick_time, events)


def recorded_values(record: SliderRecord, last: Moment) -> dict[str, np.ndarray]:
    """Return traces, DRIVE_ENERGIES, SLIPS and SLIP_EVENTS.

    Traces are constant after the last moment, or NaN if steps of the slider are recorded. Raises
    ValueError for more of these than there is room for.

    "drive_swing" : range of the drive's force over the normal force, in h/dx. "slip_period" : in
    tau. Events are sorted by time because the end of a slip is recognised late, after others.
    "is_unsteady" : whether the slider ended a slip or turned against its drive.
    """
    moments, events, tally = record.moments, record.events, record.tally[0]
    known = int(tally["moments"])
    if record.every:
        if known == record.times.size:
            raise ValueError(
                f"trace = {record.every}: the slider takes {tally['steps']} steps, but only "
                f"{known} samples can be stored; give a larger number of steps per sample"
            )
        record.times[known:] = math.nan
    moments[:, known:] = math.nan if record.every else np.array(last)[:, None]
    moments[Moment._fields.index("time")] = record.times
    swing = (tally["max_force"] - tally["min_force"]) / last.normal
    if not math.isfinite(swing):  # no step ended in the second half of the last leg
        swing = math.nan
    slips = int(tally["slips"])
    period = (tally["last_slip"] - tally["first_slip"]) / (slips - 1.0) if slips > 1 else math.nan
    numbers = map(np.array, (swing, period, tally["max_speed"]))
    in_order = events[:, np.argsort(events[0], kind="stable")]
    names = (*PULLED_TRACES, *DRIVE_ENERGIES, *SLIPS, *SLIP_EVENTS)
    values = dict(zip(names, (*moments, *numbers, *in_order), strict=True))
    return values | {"is_unsteady": np.array(tally["is_unsteady"])}
