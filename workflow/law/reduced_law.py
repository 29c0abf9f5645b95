"""Base classes of the reduced laws: state and step, validity range, errors and JSON.

A law consists of a few numbers and a state vector. In a machine model it predicts mu(t) for any
v(t) without simulating the elastomer. The first element of the state is the velocity. Within a step
the velocity is linear in time, and a step of zero duration is a jump of the velocity.
"""

import json
import math
import warnings
from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, fields, replace
from typing import Any, ClassVar, NamedTuple, Self

import numpy as np
from numpy.typing import ArrayLike

from ..given_motion import (
    LawError,
    distances_between_turns,
    divided,
    given_motion,
    smallest_speed,
)
from ..study import shift_of
from .transients import MAX_VELOCITY_CHANGE, motions_of

FORMAT = 1  # version of the JSON format
TEXT_FIELDS = (  # of Validity, as text
    "motions",
    "held_out",
    "window",
    "source",
    "shift",
    "body",
    "memories",
)
OPTIONAL_FIELDS = (  # of Validity, missing in older files
    "temperature",
    "shift",
    "body",
    "memories",
    "shortest_stroke",
)
MIN_ERROR = 1e-6  # relative to the rms of mu; smaller errors are rounding
RANGE_MARGIN = 1.0 + 1e-9  # factor on the ends of ranges, for rounding


class BeyondLawWarning(UserWarning):
    """A law is evaluated outside the range of its fit."""


@dataclass(frozen=True)
class Validity:
    """Range in which a law was fitted, and its errors; mu has no unit.

    slowest, fastest : fitted range of speeds, m/s. longest_rest : s. normal_force : N. rms,
    largest : error of mu on the fitted motions. held_rms, held_largest : largest errors on held-out
    motions, which are the stated error of the law. usual : rms of mu. model_error : rms of the
    standard error of mu in the model. left : share of the mean square of mu that a function of the
    velocity alone does not explain. motions : names of the fitted segments, with the rms error on
    each. held_out, window : descriptions of the held-out and of the fitted motions. source : name
    of the result. temperature : degrees Celsius. shift : time-temperature shift of the material, as
    JSON. body : elastic body of the motions, and error of the model, in words. memories : evidence
    for the names of the memories, in words. shortest_stroke : shortest distance between two turns
    of the motions, m; infinite if none turns twice, NaN if unknown.
    """

    slowest: float = float("nan")
    fastest: float = float("inf")
    longest_rest: float = 0.0
    normal_force: float = float("nan")
    rms: float = float("nan")
    largest: float = float("nan")
    held_rms: float = float("nan")
    held_largest: float = float("nan")
    usual: float = float("nan")
    model_error: float = float("nan")
    left: float = float("nan")
    motions: tuple[tuple[str, float], ...] = ()
    held_out: str = ""
    window: str = ""
    source: str = ""
    temperature: float = float("nan")
    shift: str = ""
    body: str = ""
    memories: str = ""
    shortest_stroke: float = float("nan")


class Compared(NamedTuple):
    """Friction of the model and of a law on one segment of a motion."""

    name: str
    time: np.ndarray  # s
    velocity: np.ndarray  # m/s
    mu: np.ndarray  # of the model
    law: np.ndarray  # mu of the law
    rms: float  # of law - mu
    largest: float  # of |law - mu|


@dataclass(frozen=True)
class FittedLaw(ABC):
    """Law fitted to motions, with its range and errors; converts to text and to JSON."""

    kind: ClassVar[str]
    validity: Validity = field(default_factory=Validity, kw_only=True)

    def with_validity(self, validity: Validity) -> Self:
        """Return the law with another range and other errors."""
        return replace(self, validity=validity)

    def to_json(self) -> str:
        """Return the law as JSON, from which ``read`` restores it exactly."""
        numbers = {name: np.asarray(getattr(self, name)).tolist() for name in self._number_names()}
        validity = {name: _json_value(value) for name, value in asdict(self.validity).items()}
        names = {"names": self.names} if hasattr(self, "names") else {}
        content = {"format": FORMAT, "kind": self.kind, **names, **numbers, "validity": validity}
        return json.dumps(content, indent=1, allow_nan=False)

    def memories(self) -> list[str]:
        """Return the names of the memories with their lengths and times, if they have names."""
        return []

    def told(self) -> list[str]:
        """Return the numbers, range and errors of the law as lines of text."""
        validity = self.validity
        numbers = [f"{name} {_array_text(getattr(self, name))}" for name in self._number_names()]
        memories = "; ".join(filter(None, [*self.memories(), validity.memories]))
        return [
            f"kind: {self.kind}; {'; '.join(numbers)}",
            *([f"memories: {memories}"] if memories else []),
            self.range_text(),
            f"outside: {self.outside()}",
            f"{self.error_text()}; held out: {validity.held_out}",
            f"error on the fitted motions, {validity.window}: {self._rms(validity.rms)}, "
            f"{validity.largest:.2g} at most; standard error of the model: "
            f"{self._rms(validity.model_error)}",
            *filter(None, [validity.body]),
        ]

    def range_text(self) -> str:
        """Return the range of the fit as text."""
        validity = self.validity
        temperature = validity.temperature
        at = "" if math.isnan(temperature) else f", {temperature:.4g} °C"
        return (
            f"range: speeds of {validity.slowest:.3g} ... {validity.fastest:.3g} m/s, rest of "
            f"{validity.longest_rest:.3g} s at most, normal force {self._load_text()} N{at}, "
            f"{self._stroke_text()}"
        )

    def error_text(self) -> str:
        """Return the stated error, which is that on held-out motions, as text."""
        validity = self.validity
        return (
            f"error on the worst of the motions held out: {self._rms(validity.held_rms)}, "
            f"{validity.held_largest:.2g} at most"
        )

    def _rms(self, error: float) -> str:
        """Return an rms error of mu to two digits, with its share of the rms of mu."""
        usual = self.validity.usual
        if not math.isfinite(error):
            return "unknown"
        if not usual > 0.0:
            return f"{error:.2g} rms"
        if error < MIN_ERROR * usual:
            return f"below {MIN_ERROR * usual:.1g} rms"
        return f"{error:.2g} rms ({100.0 * error / usual:.2g} % of the rms of mu)"

    def outside(self) -> str:
        """Return a text on the behaviour of the law outside its range."""
        return self._above()

    def _above(self) -> str:
        """Return a text on the behaviour of the law above its fastest speed."""
        return "its formula is extrapolated; nothing is clamped"

    def _number_names(self) -> list[str]:
        return [field.name for field in fields(self) if field.name not in ("names", "validity")]

    def _stroke_text(self) -> str:
        """Return the shortest distance between turns as text."""
        shortest = self.validity.shortest_stroke
        if math.isnan(shortest):
            return "an unknown distance between two turns"
        if shortest == math.inf:
            return "one turn at most"
        return f"{shortest:.3g} m or more between turns"

    def _load_text(self) -> str:
        """Return the normal force of the fitted motions as text, without its unit."""
        return f"{self.validity.normal_force:.4g}"


@dataclass(frozen=True)
class Law(FittedLaw):
    """A reduced law of one load, defined by ``init``, ``step`` and ``steady``."""

    times: ClassVar[Mapping[str, int]]  # fields that scale as a time (1) or as its inverse (-1)

    def init(self, velocity: float) -> np.ndarray:
        """Return the state of steady sliding at a velocity (m/s).

        The state begins with the velocity. Raises UserError for a velocity that is not finite.
        """
        return self._init(finite_number("velocity", velocity, "m/s"))

    @abstractmethod
    def _init(self, velocity: float) -> np.ndarray:
        """Return the state of steady sliding at a validated velocity."""

    def step(self, state: np.ndarray, v: float, dt: float) -> tuple[np.ndarray, float]:
        """Return the state and mu after dt (s), during which the velocity changes linearly to v.

        v : m/s. dt = 0 is a jump of the velocity. Changes of the velocity are divided into small
        steps, so that the result does not depend on the sampling of v(t). The given state is not
        modified. Raises UserError for a negative dt, for values that are not finite, and for a
        state of the wrong length.
        """
        v, dt = finite_number("v", v, "m/s"), finite_number("dt", dt, "s")
        if dt < 0.0:
            raise LawError(f"dt = {dt!r}: must not be negative")
        if np.shape(state) != (self.numbers,) or not np.isfinite(state).all():
            raise LawError(
                f"state = {state!r:.60}: must be {self.numbers} finite numbers, as init returns"
            )
        if dt == 0.0:
            return self._step(state, v, dt)
        mu, since = 0.0, 0.0
        least = self._smallest_speed(max(abs(state[0]), abs(v)))
        for fraction, velocity in divided(float(state[0]), v, least, MAX_VELOCITY_CHANGE):
            state, mu = self._step(state, velocity, (fraction - since) * dt)
            since = fraction
        return state, mu

    def _smallest_speed(self, fastest: float) -> float:
        """Return the speed (m/s) below which a small change is one relative to this speed."""
        return smallest_speed(self.validity.slowest, fastest)

    @property
    def numbers(self) -> int:
        """Return the length of a state vector, by default 2: the velocity and one state."""
        return 2

    @abstractmethod
    def _step(self, state: np.ndarray, v: float, dt: float) -> tuple[np.ndarray, float]:
        """Return the state and mu after a step, for validated arguments."""

    @abstractmethod
    def steady(self, v: ArrayLike) -> np.ndarray:
        """Return steady friction mu(v); v in m/s, any shape and sign."""

    def scaled(self, factor: float) -> dict[str, Any]:
        """Return the fields that depend on time, with all times multiplied by a factor."""
        numbers = {name: getattr(self, name) for name in self.times}
        return {
            name: number * factor if self.times[name] > 0 else number / factor
            for name, number in numbers.items()
        }

    def shifted(self, factor: float) -> Self:
        """Return the law with all times of the material multiplied by a factor.

        A change of temperature does this, for example by the law of Williams, Landel and Ferry. The
        shift is exact for the model, in which mu depends on v times a relaxation time. Raises
        UserError for a factor that is not positive.
        """
        if not finite_number("factor", factor, "1") > 0.0:
            raise LawError(f"factor = {factor!r}: must be greater than zero")
        validity = replace(
            self.validity,
            slowest=self.validity.slowest / factor,
            fastest=self.validity.fastest / factor,
            longest_rest=self.validity.longest_rest * factor,
        )
        return replace(self, validity=validity, **self.scaled(factor))

    def at(self, *, temperature: float) -> Self:
        """Return the law at another temperature (degrees Celsius), by the shift of its material.

        Raises UserError if the law has no shift, or the shift is undefined at that temperature.
        """
        temperature = finite_number("temperature", temperature, "°C")
        if not self.validity.shift:
            raise LawError(
                f"temperature = {temperature!r}: the law has no wlf, arrhenius or shifts of its "
                "material; fit it to results that have them, or use shifted(a)"
            )
        shift = json.loads(self.validity.shift)
        factor = shift_of(shift, temperature) / shift_of(shift, self.validity.temperature)
        law = self.shifted(factor)
        return law.with_validity(replace(law.validity, temperature=temperature))

    def run(self, time: ArrayLike, velocity: ArrayLike) -> np.ndarray:
        """Return mu at times (s), for velocities (m/s) that are linear in between; shape (n,).

        Two samples at the same time are a jump. Sliding is steady before the first sample. Warns
        above the fastest speed, and of turns that follow each other within less than the shortest
        stroke. Raises UserError for times that decrease and for values that are not finite.
        """
        motion = given_motion(time, velocity)
        shortest = np.min(distances_between_turns(*motion), initial=np.inf)
        if shortest * RANGE_MARGIN < self.validity.shortest_stroke:
            message = (
                f"{shortest:.3g} m between two turns is less than in the fitted motions "
                f"({self._stroke_text()}); the error of the law is unknown"
            )
            warnings.warn(message, BeyondLawWarning, stacklevel=2)
        fastest = np.max(np.abs(motion[1]), initial=0.0)
        if fastest > self.validity.fastest * RANGE_MARGIN:
            message = (
                f"{fastest:g} m/s is above the fastest fitted speed, "
                f"{self.validity.fastest:g} m/s; {self._above()}"
            )
            warnings.warn(message, BeyondLawWarning, stacklevel=2)
        return friction_along(self, *motion)

    def compare(self, results: Any, point: dict[str, Any] | None = None) -> list[Compared]:
        """Return the friction of the model and of the law for every segment of the results.

        results : as for ``fit``, or transients. Raises UserError as ``fit`` does.
        """
        comparisons = []
        for motion in motions_of(results, point):
            mu = self.run(motion.time, motion.velocity)
            for segment, rows in motion.parts():
                difference = mu[rows] - motion.mu[rows]
                comparisons.append(
                    Compared(
                        name=f"{motion.name}, {segment}",
                        time=motion.time[rows],
                        velocity=motion.velocity[rows],
                        mu=motion.mu[rows],
                        law=mu[rows],
                        rms=float(np.sqrt(np.mean(difference**2))),
                        largest=float(np.max(np.abs(difference))),
                    )
                )
        return comparisons


def friction_along(law: Law, t: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Return mu at the rows of a motion, with one step of the law from row to row."""
    mu = np.zeros(t.size)
    if not v.size:
        return mu
    state = law.init(v[0])
    for k, dt in enumerate(np.diff(t, prepend=t[:1])):
        state, mu[k] = law.step(state, v[k], dt)
    return mu


def _array_text(value: Any) -> str:
    return np.array2string(np.asarray(value), precision=4, separator=", ").replace("\n", "")


def _json_value(value: Any) -> Any:
    """Return a value for JSON, which represents NaN and infinity as strings."""
    return str(value) if isinstance(value, float) and not np.isfinite(value) else value


def finite_number(name: str, value: Any, unit: str) -> float:
    """Return a value as float. Raises UserError if it is not a finite number."""
    try:
        number = float(value)
    except (TypeError, ValueError):
        number = math.nan
    if not math.isfinite(number):
        raise LawError(f"{name} = {value!r:.60}: must be a finite number, in {unit}")
    return number


def mean_speed(before: float, after: float) -> float:
    """Return the mean of |v| while v changes linearly from one velocity to another."""
    if before * after >= 0.0:
        return 0.5 * (abs(before) + abs(after))
    return 0.5 * (before * before + after * after) / abs(after - before)
