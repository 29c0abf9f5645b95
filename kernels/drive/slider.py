"""A slider that is pulled through a programme of its drive: how it begins, and what is kept."""

import math
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import numpy as np

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
from .slider_record import (
    BEGAN,
    LATEST,
    LEAST,
    MOST,
    SINCE,
    SLIDES,
    SLOW,
    Moment,
    SliderRecord,
    keep,
)
from .spring import Course, Drive, SliderState
from .step import TOLERANCE, Going, Pulled

PULLED_TRACES = (*TRACES, "trace_drive_force")
SLIPS = ("drive_swing", "slip_period", "peak_velocity")  # of the second half of the last leg
SLIP_EVENTS = ("slip_event_time", "slip_event_kind")  # tau; BEGINS, ENDS or REVERSES
MOST_EVENTS = 1000  # kept
KEPT = ("trace", "stick_slip", "slip_events")
FIRST_OF_LEG = 0.25  # of the step before: where the velocity of the drive jumps
FREE = 1e3  # times the shortest step in which forces are not lost in rounding: of a free slider


class Start(NamedTuple):
    """A slider before its first step."""

    rig: Any  # that attempt and accept know (rig.py)
    steps_per_spacing: int
    slope: np.ndarray  # of the surface, in h/dx
    forces: tuple[float, float, float, float, float, float]  # of a Moment, from mu to samples


def courses(programme: Programme, place: float) -> Iterator[Course]:
    """Yield how the drive moves in each leg; place : of it at the start, in dx."""
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
        yield Course(now + times, place + moved, speeds)
        now, place = now + float(times[-1]), place + float(moved[-1])


def first_motion(programme: Programme, m: int, first: Moment) -> SliderState:
    """Return the motion before the first step: steady sliding, or none; m : steps per spacing."""
    speed = speed_at_start(programme)
    if first.speed:
        dt = 1.0 / (m * abs(speed))
    elif speed:
        dt = FIRST_OF_LEG / (m * abs(speed))
    else:
        dt = FIRST_HOLD_STEP * leg_duration(programme[0])
    return SliderState(0.0, 0.0, dt, first.speed, 0.0, -dt, -dt, first.friction)


def kept_times(scene: SceneCase, steps_per_spacing: int) -> np.ndarray:
    """Return when the moments of a slider are kept, in tau.

    A line that the drive moved itself would end the steps that are kept then. Raises ValueError for
    a scene without meaning, and for what is not kept of a slider.
    """
    steps = scene_steps(scene, steps_per_spacing)
    check_scene(scene, steps, False)
    if set(scene.asked) - set(KEPT):
        raise ValueError(f"asked = {sorted(scene.asked)}: of a slider on a spring there is {KEPT}")
    return np.append(0.0, np.cumsum(steps.dt))[scene.kept]


def steady_speed(scene: SceneCase) -> float:
    """Return the speed of the steady sliding that a scene begins with; 0 where there is none."""
    return speed_at_start(scene.programme) if scene.start == "steady" else 0.0


def pull_through(
    follow: Callable[[Pulled, Course, Going], Going],
    start: Start,
    drive: Drive,
    scene: SceneCase,
    times: np.ndarray,
) -> tuple[dict[str, np.ndarray], int]:
    """Return (traces at some times, tries of steps) of a slider that is pulled; times in tau.

    follow : as follow_leg. What is kept at the end of a leg is of its last step, and not between it
    and the leg after.
    """
    speed, friction = steady_speed(scene), start.forces[Moment._fields.index("friction")]
    force = friction if speed else 0.0  # the spring is slack where nothing slides
    moment = Moment(*start.forces, 0.0, 0.0, speed, force)
    legs = list(courses(scene.programme, force / drive.stiffness))
    since = 0.5 * float(legs[-1].time[0] + legs[-1].time[-1])
    tally = np.zeros(SLIDES + 1)
    tally[[SINCE, LEAST, MOST, SLOW]] = since, math.inf, -math.inf, math.inf
    tally[[BEGAN, LATEST]] = math.nan
    kept = np.empty((len(PULLED_TRACES), times.size))
    m, drive = start.steps_per_spacing, Drive(*map(float, drive))
    ringing = math.pi * math.sqrt(drive.mass / drive.stiffness)
    fastest = max(abs(float(v)) for v in legs[-1].speed)
    sticks = max(ringing, 1.0 / (m * fastest) if fastest else 0.0)
    events = np.full((2, MOST_EVENTS if "slip_events" in scene.asked else 0), math.nan)
    record = SliderRecord(times, kept, np.zeros(2, np.int64), tally, sticks, events)
    scale = scene.load * math.sqrt(float(np.mean(start.slope**2)))
    limits = FREE * min_step(scene.spectrum), TOLERANCE * scale, hold_step_ratio(m)
    search = np.zeros(2), np.zeros(1, np.int64)
    pulled = Pulled(start.rig, m, drive, *limits, record, *search)
    motion = first_motion(scene.programme, m, moment)
    keep(record, moment, moment, 0.0)
    driven = motion.speed
    for course in legs:
        jumps, driven = float(course.speed[0]) != driven, float(course.speed[-1])
        pace = FIRST_OF_LEG * motion.dt if jumps else motion.dt
        motion, last, _ = follow(pulled, course, Going(motion, moment, pace))
        moment = last._replace(time=float(course.time[-1]), place=motion.place)
        keep(record, last, moment, driven)
    return finished(record, moment), int(pulled.tries[0])


def finished(record: SliderRecord, last: Moment) -> dict[str, np.ndarray]:
    """Return the traces, SLIPS and SLIP_EVENTS; what lies behind the last moment is as then.

    The swing is that of the drive's force over the normal force, in h/dx, the period in tau. An end
    of a slip is known later than what has happened meanwhile: events are sorted by their times.
    """
    times, kept, many, (_, least, most, fastest, slips, began, latest, *_), _, events = record
    kept[:, many[0] :] = np.array(last)[:, None]
    kept[Moment._fields.index("time")] = times
    swing = (most - least) / last.normal
    period = (latest - began) / (slips - 1.0) if slips > 1.0 else math.nan
    told = map(np.array, (swing, period, fastest))
    in_order = events[:, np.argsort(events[0], kind="stable")]
    names = (*PULLED_TRACES, *SLIPS, *SLIP_EVENTS)
    return dict(zip(names, (*kept, *told, *in_order), strict=True))
