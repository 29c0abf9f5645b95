"""A slider that is pulled through a programme of its drive: it finds its own way.

Steps of sliding end at samples (step.py). Between samples the slider sticks: its steps are those
of a hold, by a factor longer each time, and how far it creeps in one is what balances the forces.
At a fraction of a sample the surface is shifted by Fourier (motion/fourier.py).
"""

import math
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import numpy as np

from ..motion.legs import (
    FIRST_OF_HOLD,
    Hold,
    Programme,
    Sampled,
    Slide,
    leg_duration,
    speed_at_start,
)
from ..motion.path import NEAR, WHOLE, growth
from ..rheology.spectrum import Spectrum, shortest_step
from ..scene.records import TRACES
from ..scene.scene_case import SceneCase, check_scene, scene_steps
from .rig import attempt
from .search import SLOPE, narrow_enough, new_search, next_guess
from .spring import Course, Drive, Pull, SliderState, course_at, pull_of
from .step import REST, SLOWER, TOLERANCE, Limits, Moment, SliderRecord, keep, taken, time_of

PULLED_TRACES = (*TRACES, "trace_drive_force")
SLIPS = ("drive_swing", "slip_period", "peak_velocity")  # of the second half of the last leg
KEPT = ("trace", "stick_slip")
LEAST_PLACE = 1e-12  # in samples: less is rounding
FIRST = 0.1  # of a search, in samples
FIRST_OF_LEG = 0.25  # of the step before: where the velocity of the drive jumps
SOON = 2.0  # times the step before a sample may be off, at the speed of that, to be tried
FREE = 1e3  # times the shortest step in which forces are not lost in rounding: of a free slider


class Pulled(NamedTuple):
    """A surface and elastomer as the march of a slider needs them."""

    rig: Any  # that attempt and accept know (rig.py)
    pose: Callable[[float, float], Any]  # of a step from one place to another, in samples
    slide: Callable[..., Any] | None  # slide_by_samples, where there is such a thing
    steps_per_spacing: int
    scale: float  # load times rms slope, in the units of the drive
    start: Moment


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


class Slider:
    """A slider on its way."""

    def __init__(
        self,
        pulled: Pulled,
        drive: Drive,
        spectrum: Spectrum,
        times: np.ndarray,
        since: float,
        first: SliderState,
    ) -> None:
        """Take a slider before its first step.

        times : at which its moments are kept, in tau. since : time from which slips are counted.
        """
        self.pulled, self.drive, self.motion, self.moment = pulled, drive, first, pulled.start
        self.shortest = FREE * shortest_step(spectrum)
        self.left = TOLERANCE * pulled.scale
        self.rise = self.fall = 0.0  # of the force left over: with time, and with the place
        tally = np.array([since, math.inf, -math.inf, 0.0, 0.0, math.nan, math.nan, 0.0])
        self.record = SliderRecord(times, np.empty((len(PULLED_TRACES), times.size)), tally)
        self.pace, self.driven = first.dt, first.speed  # of steps, and of the drive
        self.tries = 0
        self.number = keep(self.record, 0, self.moment, self.moment, 0.0)

    def follow(self, course: Course) -> None:
        """Follow the drive through a leg; the last step ends with it.

        What is kept at the end of the leg is of that step, and not between it and the leg after.
        """
        end, begin = float(course.time[-1]), float(course.speed[0])
        self.pace = self.motion.dt if begin == self.driven else FIRST_OF_LEG * self.motion.dt
        self.driven, self.course = float(course.speed[-1]), course
        while self._left(end):
            self._step(course, end)
        at_end = self.moment._replace(time=end, place=self.motion.place)
        self.number = keep(self.record, self.number, self.moment, at_end, self.driven)
        self.moment = at_end

    def _left(self, end: float) -> bool:
        """Return whether there is anything left of a leg."""
        return end - self.motion.time > REST * self.motion.dt

    def finished(self) -> dict[str, np.ndarray]:
        """Return the traces, and SLIPS; what lies behind the last moment is as it was then.

        The swing is that of the drive's force over the normal force, in h/dx, the period in tau.
        """
        times, kept, (_, least, most, fastest, slips, first, last, _) = self.record
        kept[:, self.number :] = np.array(self.moment)[:, None]
        kept[Moment._fields.index("time")] = times
        swing = (most - least) / self.moment.normal
        period = (last - first) / (slips - 1.0) if slips > 1.0 else math.nan
        told = map(np.array, (swing, period, fastest))
        return dict(zip((*PULLED_TRACES, *SLIPS), (*kept, *told), strict=True))

    def _sample(self) -> float:
        """Return the place in samples, whole but for rounding."""
        place = self.motion.place * self.pulled.steps_per_spacing
        whole = round(place)
        return float(whole) if abs(place - whole) <= WHOLE * max(1.0, abs(whole)) else place

    def _step(self, course: Course, end: float) -> None:
        """Take one step to the next sample, or less far; or many, as long as whole ones go."""
        motion, m = self.motion, self.pulled.steps_per_spacing
        place, left = self._sample(), end - self.motion.time
        low, high = math.ceil(place - NEAR) - 1.0, math.floor(place + NEAR) + 1.0
        ahead = high if motion.speed > 0.0 else low
        if abs(ahead - place) <= SOON * m * abs(motion.speed) * self.pace:
            if self.pulled.slide and place == round(place):
                gone = self._slide(int(place), course, end)
            else:
                gone = self._to(ahead, place, course, min(SLOWER * self.pace, left))
            if gone:
                return
        self._creep((low, high), place, course, min(growth(m) * self.pace, left))

    def _slide(self, sample: int, course: Course, end: float) -> bool:
        """Slide on by whole samples as long as it goes; return whether by any."""
        assert self.pulled.slide is not None
        begin = self.motion.time
        limits = Limits(self.shortest, end, self.left)
        record = self.record, self.number
        now = self.drive, course, self.motion, self.moment
        found = self.pulled.slide(sample, *now, limits, self.pace, self.rise, *record)
        self.motion, self.moment, self.rise, self.number, tries = found
        self.tries += tries
        gone = self.motion.time > begin
        self.pace = self.motion.dt if gone else self.pace
        return gone

    def _to(self, ahead: float, place: float, course: Course, longest: float) -> bool:
        """Step to a sample if it takes no longer than that; return whether."""
        if longest <= self.shortest:
            return False
        moved = (ahead - place) / self.pulled.steps_per_spacing
        pose = self.pulled.pose(place, ahead)
        limits = Limits(self.shortest, longest, self.left)
        dt, pull, friction, self.rise, tries = plainly(time_of)(
            self.pulled.rig,
            pose,
            self.drive,
            course,
            self.motion,
            moved,
            limits,
            0.9 * longest,
            self.rise,
        )
        self.tries += tries
        if math.isnan(dt):
            return False
        self._take(moved, dt, pull, friction)
        return True

    def _creep(self, edges: tuple[float, float], place: float, course: Course, dt: float) -> None:
        """Find how far the slider goes in a time dt, between two samples; or when it is there."""
        motion, m = self.motion, self.pulled.steps_per_spacing
        low, high = edges[0] - place, edges[1] - place
        notes = new_search(self.fall, FIRST)
        x = min(max(m * motion.speed * dt, low), high)
        while True:
            friction, lag = attempt(self.pulled.rig, self.pulled.pose(place, place + x), dt)
            pull = pull_of(self.drive, course, motion, x / m, dt, lag, friction)
            self.tries += 1
            ahead = next_guess(notes, x, -pull.excess)
            if (x >= high and pull.excess > 0.0) or (x <= low and pull.excess < 0.0):
                if not self._to(place + x, place, course, dt):
                    self._take(x / m, dt, pull, friction)
                return
            if abs(pull.excess) <= self.left or narrow_enough(notes, LEAST_PLACE):
                self.fall = float(notes[SLOPE])
                self._take(x / m, dt, pull, friction)
                return
            x = min(max(ahead, low), high)

    def _take(self, moved: float, dt: float, pull: Pull, friction: float) -> None:
        """Take the step that was tried last."""
        self.motion, now = plainly(taken)(self.pulled.rig, self.motion, moved, dt, pull, friction)
        driven = course_at(self.course, now.time)[1]
        self.number = keep(self.record, self.number, self.moment, now, driven)
        self.moment, self.pace = now, dt


def plainly(function: Callable) -> Callable:
    """Return a kernel as plain Python: it reaches rigs that are not compiled as well."""
    return getattr(function, "py_func", function)


def first_motion(programme: Programme, pulled: Pulled, steady: bool) -> SliderState:
    """Return the motion before the first step: steady sliding, or none."""
    speed, m = speed_at_start(programme), pulled.steps_per_spacing
    first, friction = programme[0], pulled.start.friction
    if steady:
        dt = 1.0 / (m * abs(speed))
        return SliderState(0.0, 0.0, dt, speed, 0.0, -dt, -dt, friction)
    dt = FIRST_OF_LEG / (m * abs(speed)) if speed else FIRST_OF_HOLD * leg_duration(first)
    return SliderState(0.0, 0.0, dt, 0.0, 0.0, -dt, -dt, friction)


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


def first_moment(
    mu: float, d: float, normal: float, friction: float, touching: float, speed: float
) -> Moment:
    """Return the Moment before the first step: the spring is slack where nothing slides."""
    force = friction if speed else 0.0
    return Moment(mu, d, normal, friction, touching, 0.0, 0.0, speed, force)


def pull_through(
    pulled: Pulled, drive: Drive, scene: SceneCase, times: np.ndarray
) -> tuple[dict[str, np.ndarray], int]:
    """Return (traces at some times, tries of steps) of a slider that is pulled; times in tau."""
    first = first_motion(scene.programme, pulled, steady_speed(scene) != 0.0)
    legs = list(courses(scene.programme, pulled.start.force / drive.stiffness))
    since = 0.5 * float(legs[-1].time[0] + legs[-1].time[-1])
    slider = Slider(pulled, drive, scene.spectrum, times, since, first)
    for course in legs:
        slider.follow(course)
    return slider.finished(), slider.tries
