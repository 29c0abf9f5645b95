"""The programme of a scene: how the line is driven, segment by segment, in SI units."""

import math
from itertools import pairwise
from typing import Any, NamedTuple

LISTED = ("hold", "velocity_amplitude", "frequency")  # axes whose values a segment gives


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

    def of_its_velocity(self) -> "Oscillate":
        """Return it with the amplitude that follows from that of the velocity, where it does."""
        if self.velocity_amplitude is None:
            return self
        omega = 2.0 * math.pi * self.frequency
        return self._replace(amplitude=self.velocity_amplitude / omega)


class FromFile(NamedTuple):
    """Follow a sampled velocity, linear between the samples; times start at zero."""

    times: tuple[float, ...]  # s, ascending
    velocities: tuple[float, ...]  # m/s
    told: str = ""  # what it was read as


Segment = SlideSegment | HoldSegment | RampSegment | Oscillate | FromFile
Programme = tuple[Segment, ...]


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


def is_relative(programme: Programme) -> bool:
    """Return whether any segment takes its velocity from the grid."""
    return any(v.relative for segment in programme for v in velocities_of(segment))


def velocity_steps(programme: Programme) -> list[int]:
    """Return the segments i where a slide changes over to another velocity of the same sign."""
    return [
        i
        for i, (before, after) in enumerate(pairwise(programme))
        if isinstance(before, SlideSegment)
        and isinstance(after, SlideSegment)
        and before.velocity != after.velocity
        and math.copysign(1.0, before.velocity.value) == math.copysign(1.0, after.velocity.value)
    ]


def holds(programme: Programme) -> list[int]:
    """Return the segments i that hold between a slide and another slide."""
    return [
        i
        for i in range(1, len(programme) - 1)
        if isinstance(programme[i], HoldSegment)
        and isinstance(programme[i - 1], SlideSegment)
        and isinstance(programme[i + 1], SlideSegment)
    ]


def listed_values(programme: Programme) -> dict[str, tuple[float, ...]]:
    """Return the values of what was given as a list: axis of the result -> values."""
    found: dict[str, tuple[float, ...]] = {}
    for segment in programme:
        if isinstance(segment, HoldSegment) and segment.several:
            found["hold"] = segment.durations
        elif isinstance(segment, Oscillate):
            found |= segment.several
    return found


def with_one_of(programme: Programme, axis: str, value: float) -> Programme:
    """Return the programme with one value of what was given as a list."""

    def own(segment: Segment) -> Segment:
        if isinstance(segment, Oscillate) and axis in dict(segment.several):
            changed: dict[str, Any] = {axis: value}
            return segment._replace(**changed).of_its_velocity()
        held = axis == "hold" and isinstance(segment, HoldSegment) and segment.several
        return HoldSegment((value,)) if held else segment

    return tuple(map(own, programme))


def first_velocity(programme: Programme) -> Velocity | None:
    """Return the velocity at which a programme begins; None where it begins with a hold."""
    found = velocities_of(programme[0])
    return found[0] if found else None


def first_speed(programme: Programme) -> float:
    """Return the first speed (m/s) that is not zero; of an oscillation about rest its amplitude.

    NaN where there is none; velocities are not those of the grid.
    """
    for segment in programme:
        speeds = [velocity.value for velocity in velocities_of(segment)]
        if isinstance(segment, Oscillate):
            speeds.append(2.0 * math.pi * segment.frequency * segment.amplitude)
        elif isinstance(segment, FromFile):
            speeds = list(segment.velocities)
        if any(speeds):
            return next(abs(speed) for speed in speeds if speed)
    return math.nan
