"""Rate-and-state and LuGre laws for comparison, and the reader of all laws.

Rate-and-state friction is the regularised form of J. R. Rice, N. Lapusta and K. Ranjith, J. Mech.
Phys. Solids 49, 1865 (2001), with phi = ln(v* theta/D_c) for the states theta of
workflow/reduce/rate_state.py:

    mu = a asinh(v/(2 v*) exp((mu* + b phi)/a))

The LuGre law is that of C. Canudas de Wit, H. Olsson, K. J. Astrom and P. Lischinsky, IEEE Trans.
Autom. Control 40, 419 (1995), per normal force, for the deflection s = sigma_0 z of the bristle:

    mu = s + sigma_1 dz/dt + sigma_2 v,   dz/dt = v - |v| s/g(v),
    g(v) = mu_c + (mu_s - mu_c) exp(-(v/v_s)^2)
"""

import json
import math
from collections.abc import Mapping
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from ..given_motion import LawError, finite_numbers
from ..system import read_whole
from .fitted_law import FORMAT, Validity
from .load_law import LoadLaw
from .memory_law import MemoryLaw
from .reduced_law import Law, mean_speed

MIN_LOG_SPEED = 1e-300  # m/s, lower bound of a speed before its logarithm is taken
MAX_EXPONENT = 700.0  # exp of larger numbers overflows


@dataclass(frozen=True)
class RateStateLaw(Law):
    """Rate-and-state friction with one state: Dieterich's law if ``ageing``, else Ruina's."""

    kind: ClassVar[str] = "rate-state"
    times: ClassVar[Mapping[str, int]] = {"velocity": -1}
    a: float
    b: float
    length: float  # D_c, m
    mu: float  # mu* at v*
    velocity: float  # v*, m/s
    ageing: bool

    def _init(self, velocity: float) -> np.ndarray:
        """Return the state (v, phi) of steady sliding; below the slowest speed phi is constant."""
        slowest = self.validity.slowest if self.validity.slowest > 0.0 else 1e-6 * self.velocity
        speed = max(abs(velocity), slowest)
        return np.array([velocity, math.log(self.velocity / speed)])

    def _step(self, state: np.ndarray, v: float, dt: float) -> tuple[np.ndarray, float]:
        """Return the state and mu after a step at the mean speed; see ``Law.step``."""
        speed, phi = max(mean_speed(state[0], v), MIN_LOG_SPEED), state[1]
        steady, x = math.log(self.velocity / speed), speed * dt / self.length
        if not self.ageing:
            phi = steady + (phi - steady) * math.exp(-x)
        elif x > 0.0:  # theta v/D_c becomes 1 + (theta v/D_c - 1) exp(-x); at rest theta += dt
            phi = float(np.logaddexp(steady + math.log(-math.expm1(-x)), phi - x))
        return np.array([v, phi]), self._mu(v, phi)

    def _mu(self, v: float, phi: float) -> float:
        power = min((self.mu + self.b * phi) / self.a, MAX_EXPONENT)
        return self.a * math.asinh(0.5 * v / self.velocity * math.exp(power))

    def steady(self, v: ArrayLike) -> np.ndarray:
        """Return mu_ss(v); below the slowest speed the state is constant."""
        velocities = np.ravel(finite_numbers("v", v))
        flat = [self._mu(velocity, float(self._init(velocity)[1])) for velocity in velocities]
        return np.reshape(flat, np.shape(v))


@dataclass(frozen=True)
class LuGreLaw(Law):
    """LuGre law: one bristle, a Stribeck curve, damping and viscous friction."""

    kind: ClassVar[str] = "lugre"
    times: ClassVar[Mapping[str, int]] = {"damping": 1, "viscous": 1, "stribeck": -1}
    stiffness: float  # sigma_0, 1/m
    damping: float  # sigma_1, s/m
    viscous: float  # sigma_2, s/m
    coulomb: float  # mu_c
    static: float  # mu_s
    stribeck: float  # v_s, m/s

    def _limit(self, v: ArrayLike) -> Any:
        """Return g(v), the steady deflection of the bristle in units of mu."""
        fall = np.exp(-np.minimum((np.asarray(v) / self.stribeck) ** 2, MAX_EXPONENT))
        return self.coulomb + (self.static - self.coulomb) * fall

    def _init(self, velocity: float) -> np.ndarray:
        """Return the state (v, s) of steady sliding; at rest the bristle is not deflected."""
        return np.array([velocity, np.sign(velocity) * float(self._limit(velocity))])

    def _step(self, state: np.ndarray, v: float, dt: float) -> tuple[np.ndarray, float]:
        """Return the state and mu after a step at the mean velocity; see ``Law.step``."""
        mean = 0.5 * (state[0] + v)
        limit = float(self._limit(mean))
        decay = math.exp(-self.stiffness * mean_speed(state[0], v) * dt / limit)
        end = math.copysign(limit, mean)
        s = end + (state[1] - end) * decay
        slip = v - abs(v) * s / float(self._limit(v))
        return np.array([v, s]), s + self.damping * slip + self.viscous * v

    def steady(self, v: ArrayLike) -> np.ndarray:
        """Return mu_ss(v) = g(v) sign(v) + sigma_2 v."""
        v = finite_numbers("v", v)
        return np.sign(v) * self._limit(v) + self.viscous * v


LAWS_BY_KIND: dict[str, type[Law]] = {law.kind: law for law in (MemoryLaw, RateStateLaw, LuGreLaw)}
READABLE_LAWS: dict[str, type[Law | LoadLaw]] = {**LAWS_BY_KIND, LoadLaw.kind: LoadLaw}


def read_law(source: str | Path) -> Law | LoadLaw:
    """Return the law in a JSON text, or in the file at a path.

    source : text that begins with a bracket is JSON; other text is a path.

    Raises UserError for text that does not describe a law.
    """
    text: str | bytes
    if isinstance(source, str) and source.lstrip().startswith(("{", "[")):
        place, text = "the text", source
    else:
        place, text = str(source), read_whole(Path(source))
    try:
        content = json.loads(text)
        law_class: type[Law | LoadLaw] = READABLE_LAWS[content["kind"]]
        if content["format"] != FORMAT:
            raise ValueError(f"its format is {content['format']}, not {FORMAT}")
        fixed = ("names", "validity")
        numbers = [field.name for field in fields(law_class) if field.name not in fixed]
        values = {name: _checked(name, content[name]) for name in numbers}
        if law_class.kind in (MemoryLaw.kind, LoadLaw.kind):
            values["names"] = tuple(content.get("names", ()))
        return law_class(**values, validity=_validity(content["validity"]))
    except (LookupError, TypeError, ValueError, ArithmeticError, RecursionError) as error:
        raise LawError(f"{place}: is not a law as JSON: {error}") from error


def _checked(name: str, value: Any) -> Any:
    """Return a number, or a list of them as an array. Raises ValueError or TypeError."""
    if not isinstance(value, int | float | list) or not np.isfinite(np.array(value, float)).all():
        raise ValueError(f"{name} = {value!r:.40}: must be finite")
    return np.array(value, float) if isinstance(value, list) else value


def _validity(content: Mapping[str, Any]) -> Validity:
    """Return the range and errors of a law from its JSON object; missing fields are unknown."""
    values: dict[str, Any] = {}
    for field in fields(Validity):
        if field.name not in content:
            continue
        value = values[field.name] = content[field.name]
        if field.name == "motions":
            values["motions"] = tuple((str(name), float(rms)) for name, rms in value)
        elif field.type is not str:
            values[field.name] = float(value)
        elif not isinstance(value, str):
            raise TypeError(f"validity.{field.name} = {value!r:.40}: must be a text")
    json.loads(values.get("shift") or "{}")
    return Validity(**values)
