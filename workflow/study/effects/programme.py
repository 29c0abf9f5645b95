"""A scene: how the line is pressed on and driven, segment by segment, in SI units."""

import math
from itertools import pairwise
from typing import Any, NamedTuple

FORCE, INDENTATION = "force", "indentation"  # controls
STEADY, RELAXED, FRESH = "steady", "relaxed", "fresh"  # starts
PROGRAMME_AXES = ("hold", "velocity_amplitude", "frequency")  # axes whose values a segment gives


class Velocity(NamedTuple):
    """A velocity, positive in the direction of sliding, as such or as a share of another."""

    value: float  # m/s, or a ratio
    relative: bool = False  # to the velocity of the grid

    def at(self, reference: float) -> float:
        """Return the velocity (m/s) where that of the grid is ``reference``."""
        return self.value * reference if self.relative else self.value


class SlideSegment(NamedTuple):
    """Slide at constant velocity, over a distance or for a duration."""

    velocity: Velocity
    distance: float | None = None  # m
    duration: float | None = None  # s; one of the two is given

    def seconds(self, reference: float) -> float:
        """Return the duration (s) where the velocity of the grid is ``reference``."""
        if self.distance is None:
            return self.duration or 0.0
        return self.distance / abs(self.velocity.at(reference))


class HoldSegment(NamedTuple):
    """Stay where it is; several durations make one programme each."""

    durations: tuple[float, ...]  # s
    several: bool = False  # given as a list: a dimension of the result


class RampSegment(NamedTuple):
    """Change the velocity linearly in time."""

    first: Velocity
    last: Velocity
    duration: float  # s


class Oscillate(NamedTuple):
    """Superpose amplitude sin(2 pi frequency t) on a path of constant velocity."""

    velocity: Velocity  # mean
    amplitude: float  # m
    frequency: float  # Hz
    cycles: int
    velocity_amplitude: float | None = None  # m/s, where it was given in place of the other
    several: tuple[tuple[str, tuple[float, ...]], ...] = ()  # dimensions of the result

    def with_derived_amplitude(self) -> "Oscillate":
        """Return it with the amplitude that follows from that of the velocity, where it does."""
        if self.velocity_amplitude is None:
            return self
        omega = 2.0 * math.pi * self.frequency
        return self._replace(amplitude=self.velocity_amplitude / omega)


class FromFile(NamedTuple):
    """Follow a sampled velocity, linear between the samples; times start at zero."""

    times: tuple[float, ...]  # s, ascending
    velocities: tuple[float, ...]  # m/s
    description: str = ""  # what it was read as


Segment = SlideSegment | HoldSegment | RampSegment | Oscillate | FromFile
Programme = tuple[Segment, ...]
History = tuple[tuple[float, ...], tuple[float, ...]]  # times (s), values


def velocities_of(segment: Segment) -> tuple[Velocity, ...]:
    """Return the velocities at the beginning and at the end of a segment; none of a hold."""
    match segment:
        case SlideSegment() | Oscillate():
            return (segment.velocity, segment.velocity)
        case RampSegment():
            return (segment.first, segment.last)
        case FromFile():
            return tuple(Velocity(v) for v in (segment.velocities[0], segment.velocities[-1]))
    return ()


class Spring(NamedTuple):
    """What a slider is pulled through."""

    stiffness: float  # N/m
    mass: float = 0.0  # kg, of the slider
    damping: float = 0.0  # N s/m, beside the spring


class Scene(NamedTuple):
    """What is simulated."""

    quantities: tuple[str, ...] = ("steady", "jump", "relaxation")
    indentation_rate: bool = True
    control: str = FORCE
    start: str = STEADY  # of a programme
    repeat: int = 1  # times that the whole list is followed
    programme: Programme = ()  # empty: steady at v1, a jump to v2, relaxation
    indentation_history: History | None = None  # d(t) (s, m), constant beyond its ends
    drive: Spring | None = None  # through which the programme pulls; None: it moves the line
    indentation_description: str = ""  # what it was read from

    @property
    def segments(self) -> Programme:
        """Return the programme with its repetitions."""
        return self.programme * self.repeat

    @property
    def sampled(self) -> tuple[str, ...]:
        """Return what the sampled velocities of the programme were read as, each once."""
        found = [segment.description for segment in self.programme if isinstance(segment, FromFile)]
        return tuple(dict.fromkeys(found))

    @property
    def velocity_steps(self) -> list[int]:
        """Return the segments i where a slide changes over to another velocity of the same sign."""
        return [
            i
            for i, (before, after) in enumerate(pairwise(self.segments))
            if isinstance(before, SlideSegment)
            and isinstance(after, SlideSegment)
            and before.velocity != after.velocity
            and (before.velocity.value > 0.0) == (after.velocity.value > 0.0)
        ]

    @property
    def heals(self) -> bool:
        """Return whether a segment holds between a slide and another slide."""
        kinds = [type(segment) for segment in self.segments]
        healing = [SlideSegment, HoldSegment, SlideSegment]
        return any(kinds[i : i + 3] == healing for i in range(len(kinds)))

    @property
    def starts_after_sliding(self) -> bool:
        """Return whether it begins at rest after steady sliding at the velocity of the grid."""
        first = self.programme[:1]
        return self.start == STEADY and any(isinstance(one, HoldSegment) for one in first)

    @property
    def uses_velocity(self) -> bool:
        """Return whether the velocity of the grid is used at all."""
        relative = any(v.relative for one in self.programme for v in velocities_of(one))
        return not self.programme or relative or self.starts_after_sliding

    @property
    def uses_indentation(self) -> bool:
        """Return whether the grid prescribes the indentation."""
        return self.control == INDENTATION and self.indentation_history is None

    @property
    def listed(self) -> dict[str, tuple[float, ...]]:
        """Return the dimensions of the result whose values its programme gives as lists."""
        found: dict[str, tuple[float, ...]] = {}
        for segment in self.programme:
            if isinstance(segment, HoldSegment) and segment.several:
                found["hold"] = segment.durations
            elif isinstance(segment, Oscillate):
                found |= segment.several
        return found

    def with_axis_value(self, axis: str, value: float) -> "Scene":
        """Return the scene with one value of what its programme gives as a list."""

        def own(segment: Segment) -> Segment:
            if isinstance(segment, Oscillate) and axis in dict(segment.several):
                changed: dict[str, Any] = {axis: value}
                return segment._replace(**changed).with_derived_amplitude()
            held = axis == "hold" and isinstance(segment, HoldSegment) and segment.several
            return HoldSegment((value,)) if held else segment

        return self._replace(programme=tuple(map(own, self.programme)))

    @property
    def typical_speed(self) -> float:
        """Return the first speed (m/s) that is not zero, of a programme without the grid's.

        Of an oscillation about rest it is the amplitude. NaN where there is none.
        """
        for segment in self.programme:
            speeds = [velocity.value for velocity in velocities_of(segment)]
            if isinstance(segment, Oscillate):
                speeds.append(2.0 * math.pi * segment.frequency * segment.amplitude)
            elif isinstance(segment, FromFile):
                speeds = list(segment.velocities)
            if any(speeds):
                return next(abs(speed) for speed in speeds if speed)
        return math.nan

    def start_velocity(self, reference: float) -> float:
        """Return the velocity (m/s) at which it begins where that of the grid is ``reference``."""
        found = [velocity for one in self.programme[:1] for velocity in velocities_of(one)]
        return found[0].at(reference) if found else reference
