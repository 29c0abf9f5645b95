"""What every reduced law of friction has: a state, a step, its range and its error, as JSON.

A law is a few numbers and a state, from which a model of a machine gets mu(t) of any v(t) without
the elastomer behind it. Its state begins with the velocity; between two steps the velocity is
linear in time, and a step of no duration is a jump of it.
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

from ..given_motion import LawError, finely, given_motion
from ..study import shift_of
from .transients import PIECE, motions_of

FORMAT = 1  # of the JSON
WORDS = ("motions", "held_out", "window", "source", "shift")  # of a Validity; the rest are numbers
ADDED = ("temperature", "shift")  # of a Validity, which older files do not have
BEYOND = 1.0 + 1e-9  # times the fastest speed: rounding


class BeyondLawWarning(UserWarning):
    """A law is asked outside the range in which it was fitted."""


@dataclass(frozen=True)
class Validity:
    """In which range a law was fitted, and how closely it follows; mu has no unit.

    slowest, fastest : speeds between which it was fitted, m/s; mu is in proportion to v below and
    that of the fastest above. longest_rest : s. normal_force : N, of the motions. rms, largest :
    of mu of the law less that of the model, on the motions that it was fitted to. held_rms,
    held_largest : the same on motions that it was not fitted to, the worst of them: its stated
    error. usual : rms of mu itself. model_error : rms standard error of mu in the model. left :
    share of the variance of mu that is left when mu is a function of the velocity alone. motions :
    what it was fitted to, with the rms error on each. held_out, window : what was held out and how
    much was fitted, in words. source : of the result.
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


class Compared(NamedTuple):
    """A motion of the model beside the law."""

    name: str
    time: np.ndarray  # s
    velocity: np.ndarray  # m/s
    mu: np.ndarray  # of the model
    law: np.ndarray  # mu of the law
    rms: float  # of the difference
    largest: float


@dataclass(frozen=True)
class FittedLaw(ABC):
    """What was fitted to motions: numbers with a range and an error, told and written as JSON."""

    kind: ClassVar[str]
    validity: Validity = field(default_factory=Validity, kw_only=True)

    def with_validity(self, validity: Validity) -> Self:
        """Return the law with other range and errors."""
        return replace(self, validity=validity)

    def to_json(self) -> str:
        """Return the law as JSON, from which ``read`` gets it back to the bit."""
        numbers = {
            each.name: np.asarray(getattr(self, each.name)).tolist()
            for each in fields(self)
            if each.name != "validity"
        }
        told = {name: _plain(value) for name, value in asdict(self.validity).items()}
        whole = {"format": FORMAT, "kind": self.kind, **numbers, "validity": told}
        return json.dumps(whole, indent=1, allow_nan=False)

    def told(self) -> list[str]:
        """Return the numbers, the range and the error of the law, in lines for people."""
        known = self.validity
        numbers = [each.name for each in fields(self) if each.name != "validity"]
        share = 100.0 / known.usual if known.usual else float("nan")
        at = "" if math.isnan(known.temperature) else f", {known.temperature:.4g} °C"
        return [
            f"kind: {self.kind}; "
            + "; ".join(f"{name} {_short(getattr(self, name))}" for name in numbers),
            f"range: speeds of {known.slowest:.3g} ... {known.fastest:.3g} m/s, rest of "
            f"{known.longest_rest:.3g} s at most, normal force {self._loads()} N{at}",
            f"outside: {self.outside()}",
            f"error on the worst of the motions held out: {known.held_rms:.3g} rms "
            f"({share * known.held_rms:.3g} % of the rms of mu), {known.held_largest:.3g} "
            f"at most; held out: {known.held_out}",
            f"error on what was fitted, {known.window}: {known.rms:.3g} rms "
            f"({share * known.rms:.3g} %), {known.largest:.3g} at most; the model's own standard "
            f"error {known.model_error:.3g}",
        ]

    def outside(self) -> str:
        """Return what the law does outside its range."""
        return "its formula goes on; nothing is clamped"

    def _loads(self) -> str:
        """Return the normal force of the motions in words, without its unit."""
        return f"{self.validity.normal_force:.4g}"


@dataclass(frozen=True)
class Law(FittedLaw):
    """A reduced law: ``init``, ``step`` and ``steady`` make it, the rest follows from them."""

    times: ClassVar[Mapping[str, int]]  # numbers that go as a time (1), or as one over it (-1)

    def init(self, velocity: float) -> np.ndarray:
        """Return the state of steady sliding at a velocity, m/s; its first number is that.

        Raises UserError for a velocity that is no finite number.
        """
        return self._init(finite_number("velocity", velocity, "m/s"))

    @abstractmethod
    def _init(self, velocity: float) -> np.ndarray:
        """Return what ``init`` does, of a number that is checked."""

    def step(self, state: np.ndarray, v: float, dt: float) -> tuple[np.ndarray, float]:
        """Return the state after dt (s), in which the velocity became v (m/s) linearly, and mu.

        dt = 0 is a jump of the velocity. Of a constant velocity every division of a time into
        steps gives the same state. The state that is given stays as it is. Raises UserError for a
        negative dt, for what is no finite number, and for a state that is none of this law.
        """
        v, dt = finite_number("v", v, "m/s"), finite_number("dt", dt, "s")
        if dt < 0.0:
            raise LawError(f"dt = {dt!r}: must not be negative")
        if np.shape(state) != (self.numbers,) or not np.isfinite(state).all():
            raise LawError(
                f"state = {state!r:.60}: must be {self.numbers} finite numbers, as init returns"
            )
        return self._step(state, v, dt)

    @property
    def numbers(self) -> int:
        """Return how many numbers a state has: the velocity and one more, of most laws."""
        return 2

    @abstractmethod
    def _step(self, state: np.ndarray, v: float, dt: float) -> tuple[np.ndarray, float]:
        """Return what ``step`` does, of numbers that are checked."""

    @abstractmethod
    def steady(self, v: ArrayLike) -> np.ndarray:
        """Return steady friction mu(v); v in m/s, any shape and sign."""

    def scaled(self, factor: float) -> dict[str, Any]:
        """Return the numbers that change where all times are ``factor`` times as long."""
        own = {name: getattr(self, name) for name in self.times}
        return {k: own[k] * factor if self.times[k] > 0 else own[k] / factor for k in own}

    def shifted(self, factor: float) -> Self:
        """Return the law where all times of the material are ``factor`` times as long.

        As a temperature multiplies them by the law of Williams, Landel and Ferry: exact for the
        model, in which mu depends on v times a relaxation time. Raises UserError for factors that
        are not positive.
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
        """Return the law at another temperature, degrees Celsius, by the shift of its material.

        Raises UserError where no shift is known, or none at that temperature.
        """
        own, wanted = self.validity, finite_number("temperature", temperature, "°C")
        if not own.shift:
            raise LawError(
                f"temperature = {temperature!r}: the law knows no wlf, arrhenius or shifts of its "
                "material; fit it to results that have them, or use shifted(a)"
            )
        shift = json.loads(own.shift)
        law = self.shifted(shift_of(shift, wanted) / shift_of(shift, own.temperature))
        return law.with_validity(replace(law.validity, temperature=wanted))

    def run(self, time: ArrayLike, velocity: ArrayLike) -> np.ndarray:
        """Return mu at times (s) for velocities (m/s) that are linear in between; shape (n,).

        Two samples of one time are a step. Sliding is steady before. Changes of the velocity are
        taken in small parts, so that v(t) counts and not its samples. Warns beyond the fastest
        speed. Raises UserError for times that decrease and for what is not finite.
        """
        t, v, last = finely(*given_motion(time, velocity), self.validity.slowest, PIECE)
        if v.size and np.max(np.abs(v)) > self.validity.fastest * BEYOND:
            said = (
                f"{np.max(np.abs(v)):g} m/s is above {self.validity.fastest:g} m/s, up to which the"
            )
            said += " law was fitted; the speed is clamped there"
            warnings.warn(said, BeyondLawWarning, stacklevel=2)
        return followed(self, t, v)[last]

    def compare(self, results: Any, point: dict[str, Any] | None = None) -> list[Compared]:
        """Return every motion of one or several results of the model, and the law beside it.

        results : as ``fit`` takes them, or transients. Raises UserError as ``fit`` does.
        """
        found = []
        for motion in motions_of(results, point):
            law = self.run(motion.time, motion.velocity)
            for name, at in motion.parts():
                off = law[at] - motion.mu[at]
                kept = motion.time[at], motion.velocity[at], motion.mu[at], law[at]
                errors = float(np.sqrt(np.mean(off**2))), float(np.max(np.abs(off)))
                found.append(Compared(f"{motion.name}, {name}", *kept, *errors))
        return found


def followed(law: Law, t: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Return mu of one step from each row of a motion to the next, as they are given."""
    mu = np.zeros(t.size)
    if not v.size:
        return mu
    state = law.init(v[0])
    for k, dt in enumerate(np.diff(t, prepend=t[:1])):
        state, mu[k] = law.step(state, v[k], dt)
    return mu


def _short(value: Any) -> str:
    return np.array2string(np.asarray(value), precision=4, separator=", ").replace("\n", "")


def _plain(value: Any) -> Any:
    """Return a value as JSON knows it: what is not finite as a word."""
    return str(value) if isinstance(value, float) and not np.isfinite(value) else value


def finite_number(name: str, value: Any, unit: str) -> float:
    """Return a number. Raises UserError for what is no finite one."""
    try:
        found = float(value)
    except (TypeError, ValueError):
        found = math.nan
    if not math.isfinite(found):
        raise LawError(f"{name} = {value!r:.60}: must be a finite number, in {unit}")
    return found


def mean_speed(before: float, after: float) -> float:
    """Return the mean of |v| while v changes linearly from one velocity to another."""
    if before * after >= 0.0:
        return 0.5 * (abs(before) + abs(after))
    return 0.5 * (before * before + after * after) / abs(after - before)
