"""A scene: load and motion of the line, segment by segment, in SI units."""

import math
from itertools import pairwise
from typing import Any, NamedTuple

from .scene_effects import SceneEffects

FORCE, INDENTATION = "force", "indentation"  # controls
STEADY, RELAXED, FRESH = "steady", "relaxed", "fresh"  # starts
PROGRAMME_AXES = (
    "hold",
    "velocity_amplitude",
    "frequency",
)  # axes given in a segment


class Velocity(NamedTuple):
    """A velocity, positive in the sliding direction, in m/s or relative to that of the grid."""

    value: float  # m/s, or a ratio
    relative: bool = False  # to the velocity of the grid

    def at(self, reference: float) -> float:
        """Return the velocity (m/s) for the velocity ``reference`` of the grid."""
        return self.value * reference if self.relative else self.value


class SlideSegment(NamedTuple):
    """A slide at constant velocity, over a distance or for a duration."""

    velocity: Velocity
    distance: float | None = None  # m
    duration: float | None = None  # s; either distance or duration is given

    def seconds(self, reference: float) -> float:
        """Return the duration (s) for the velocity ``reference`` of the grid."""
        if self.distance is None:
            return self.duration or 0.0
        return self.distance / abs(self.velocity.at(reference))


class HoldSegment(NamedTuple):
    """A hold of the line at rest; each duration gives a separate programme."""

    durations: tuple[float, ...]  # s
    several: bool = False  # whether durations are a dimension of the result


class RampSegment(NamedTuple):
    """A change of the velocity that is linear in time."""

    first: Velocity
    last: Velocity
    duration: float  # s


class Oscillate(NamedTuple):
    """An oscillation amplitude sin(2 pi frequency t) on a path of constant velocity."""

    velocity: Velocity  # mean
    amplitude: float  # m
    frequency: float  # Hz
    cycles: int
    velocity_amplitude: float | None = None  # m/s, if given in place of amplitude
    several: tuple[tuple[str, tuple[float, ...]], ...] = ()  # (axis, values) of the result

    def with_derived_amplitude(self) -> "Oscillate":
        """Return the segment with ``amplitude`` computed from ``velocity_amplitude``, if given."""
        if self.velocity_amplitude is None:
            return self
        omega = 2.0 * math.pi * self.frequency
        return self._replace(amplitude=self.velocity_amplitude / omega)


class FromFile(NamedTuple):
    """A motion of sampled velocity, linear between the samples; times start at zero."""

    times: tuple[float, ...]  # s, ascending
    velocities: tuple[float, ...]  # m/s
    description: str = ""  # of the file or arrays


Segment = SlideSegment | HoldSegment | RampSegment | Oscillate | FromFile
Programme = tuple[Segment, ...]
History = tuple[tuple[float, ...], tuple[float, ...]]  # times (s), values


def velocities_of(segment: Segment) -> tuple[Velocity, ...]:
    """Return the first and last velocity of a segment (oscillation: its mean); empty for a hold."""
    match segment:
        case SlideSegment() | Oscillate():
            return (segment.velocity, segment.velocity)
        case RampSegment():
            return (segment.first, segment.last)
        case FromFile():
            return tuple(Velocity(v) for v in (segment.velocities[0], segment.velocities[-1]))
    return ()


class Spring(NamedTuple):
    """Spring and damper between a drive and the slider, and the slider's mass."""

    stiffness: float  # N/m
    mass: float = 0.0  # kg, of the slider
    damping: float = 0.0  # N s/m, parallel to the spring
    per_normal_force: bool = False  # whether all three are per newton of the normal force


class Scene(NamedTuple):
    """Quantities, programme, load and drive of a simulation."""

    quantities: tuple[str, ...] = ("steady", "jump", "relaxation")
    indentation_rate: bool = True
    control: str = FORCE
    start: str = STEADY  # of a programme
    repeat: int = 1  # number of times that the programme is run
    programme: Programme = ()  # empty: steady at v1, a jump to v2, relaxation
    indentation_history: History | None = None  # d(t) (s, m), constant beyond its ends
    drive: Spring | None = None  # None: the programme moves the line itself
    indentation_description: str = ""  # of the file of the indentation
    effects: SceneEffects = SceneEffects()  # of one variant of the study

    @property
    def segments(self) -> Programme:
        """The programme with its repetitions."""
        return self.programme * self.repeat

    @property
    def rests(self) -> bool:
        """Return whether the line may be at rest: in a hold, or on a spring."""
        held = any(isinstance(segment, HoldSegment) for segment in self.programme)
        return self.drive is not None or held

    @property
    def sampled(self) -> tuple[str, ...]:
        """Distinct descriptions of the sampled velocities of the programme."""
        texts = [segment.description for segment in self.programme if isinstance(segment, FromFile)]
        return tuple(dict.fromkeys(texts))

    @property
    def velocity_steps(self) -> list[int]:
        """Indices of slides that are followed by a slide at another velocity of the same sign."""
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
        """Return whether a hold follows a slide and precedes another slide."""
        kinds = [type(segment) for segment in self.segments]
        healing = [SlideSegment, HoldSegment, SlideSegment]
        return any(kinds[i : i + 3] == healing for i in range(len(kinds)))

    @property
    def starts_after_sliding(self) -> bool:
        """Return whether the programme starts with a hold after steady sliding."""
        first = self.programme[0] if self.programme else None
        return self.start == STEADY and isinstance(first, HoldSegment)

    @property
    def uses_velocity(self) -> bool:
        """Return whether the velocity of the grid is used."""
        relative = any(v.relative for segment in self.programme for v in velocities_of(segment))
        return not self.programme or relative or self.starts_after_sliding

    @property
    def moves(self) -> bool:
        """Return whether the surface moves, or slid before the programme."""
        return self.uses_velocity or self.typical_speed > 0.0

    @property
    def uses_indentation(self) -> bool:
        """Return whether the grid prescribes the indentation."""
        return self.control == INDENTATION and self.indentation_history is None

    @property
    def listed(self) -> dict[str, tuple[float, ...]]:
        """Axis -> values, for the axes that the programme gives as lists."""
        axes: dict[str, tuple[float, ...]] = {}
        for segment in self.programme:
            if isinstance(segment, HoldSegment) and segment.several:
                axes["hold"] = segment.durations
            elif isinstance(segment, Oscillate):
                axes |= segment.several
        return axes

    def with_axis_value(self, axis: str, value: float) -> "Scene":
        """Return the scene with one value of an axis of its programme."""

        def with_value(segment: Segment) -> Segment:
            if isinstance(segment, Oscillate) and axis in dict(segment.several):
                changed: dict[str, Any] = {axis: value}
                return segment._replace(**changed).with_derived_amplitude()
            if isinstance(segment, HoldSegment) and segment.several and axis == "hold":
                return HoldSegment((value,))
            return segment

        return self._replace(programme=tuple(map(with_value, self.programme)))

    @property
    def typical_speed(self) -> float:
        """First nonzero speed (m/s) of a programme that does not use the grid's velocity.

        For an oscillation about rest it is the velocity amplitude. 0 if nothing moves.
        """
        for segment in self.programme:
            speeds = [velocity.value for velocity in velocities_of(segment)]
            if isinstance(segment, Oscillate):
                speeds.append(2.0 * math.pi * segment.frequency * segment.amplitude)
            elif isinstance(segment, FromFile):
                speeds = list(segment.velocities)
            if any(speeds):
                return next(abs(speed) for speed in speeds if speed)
        return 0.0

    def start_velocity(self, reference: float) -> float:
        """Return the first velocity (m/s), or that of the grid, ``reference``, before a hold."""
        velocities = velocities_of(self.programme[0]) if self.programme else ()
        return velocities[0].at(reference) if velocities else reference
