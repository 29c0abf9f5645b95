"""Range, errors and text of a law that was fitted to motions, and its JSON."""

import json
import math
from abc import ABC
from dataclasses import asdict, dataclass, field, fields, replace
from typing import Any, ClassVar, Self

import numpy as np

FORMAT = 1  # version of the JSON format
MIN_ERROR = 1e-6  # relative to the rms of mu; smaller errors are rounding


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
        validity = {  # JSON represents NaN and infinity as strings
            name: str(value) if isinstance(value, float) and not np.isfinite(value) else value
            for name, value in asdict(self.validity).items()
        }
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


def _array_text(value: Any) -> str:
    """Return a number, or an array in brackets, with four digits each."""
    if np.ndim(value) == 0:
        return f"{value:.4g}"
    return f"[{', '.join(map(_array_text, value))}]"
