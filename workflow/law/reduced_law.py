"""Base class of the reduced laws of one load: state, step and motion.

A law consists of a few numbers and a state vector. In a machine model it predicts mu(t) for any
v(t) without simulating the elastomer. The first element of the state is the velocity. Within a step
the velocity is linear in time, and a step of zero duration is a jump of the velocity.
"""

import json
import math
import warnings
from abc import abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, ClassVar, NamedTuple, Self

import numpy as np
from numpy.typing import ArrayLike

from ..given_motion import LawError, distances_between_turns, divided, given_motion, smallest_speed
from ..study import shift_of
from .fitted_law import FittedLaw
from .transients import MAX_VELOCITY_CHANGE, motions_of

RANGE_MARGIN = 1.0 + 1e-9  # factor on the ends of ranges, for rounding


class BeyondLawWarning(UserWarning):
    """A law is evaluated outside the range of its fit."""


class Compared(NamedTuple):
    """Friction of the model and of a law on one segment of a motion."""

    name: str
    time: np.ndarray  # s
    velocity: np.ndarray  # m/s
    mu: np.ndarray  # of the model
    law: np.ndarray  # mu of the law
    rms: float  # of law - mu
    largest: float  # of |law - mu|

    def __repr__(self) -> str:
        """Return the name and the errors in one line, without the arrays."""
        return f"{self.name}: {self.rms:.2g} rms, {self.largest:.2g} at most"


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
