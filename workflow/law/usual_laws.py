"""Rate-and-state friction and LuGre, as laws that stand beside ours, and the reading of any law.

Rate and state is the regularised form of J. R. Rice, N. Lapusta and K. Ranjith, J. Mech. Phys.
Solids 49, 1865 (2001), with the states of workflow/reduce/rate_state.py, as phi = ln(v* theta/D_c):

    mu = a asinh(v/(2 v*) exp((mu* + b phi)/a))

LuGre is that of C. Canudas de Wit, H. Olsson, K. J. Astrom and P. Lischinsky, IEEE Trans. Autom.
Control 40, 419 (1995), per normal force, with bristles in units of mu (s = sigma_0 z):

    mu = s + sigma_1 dz/dt + sigma_2 v,   dz/dt = v - |v| s/g(v),
    g(v) = mu_c + (mu_s - mu_c) exp(-(v/v_s)^2)
"""

import json
import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from ..given_motion import LawError, finite_numbers
from ..system import read_whole
from .load_law import LoadLaw
from .memory_law import MemoryLaw
from .reduced_law import ADDED, FORMAT, WORDS, Law, Validity, mean_speed

LEAST = 1e-300  # m/s, of a speed in a logarithm
LARGEST = 700.0  # of an exponent


@dataclass(frozen=True)
class RateStateLaw(Law):
    """Rate-and-state friction with one state; ``ageing`` after Dieterich, else slip after Ruina."""

    kind: ClassVar[str] = "rate-state"
    times: ClassVar[Mapping[str, int]] = {"velocity": -1}
    a: float
    b: float
    length: float  # D_c, m
    mu: float  # mu* at v*
    velocity: float  # v*, m/s
    ageing: bool

    def _init(self, velocity: float) -> np.ndarray:
        """Return (v, phi) of steady sliding; at rest as after sliding at the slowest speed."""
        least = self.validity.slowest if self.validity.slowest > 0.0 else 1e-6 * self.velocity
        speed = max(abs(velocity), least)
        return np.array([velocity, math.log(self.velocity / speed)])

    def _step(self, state: np.ndarray, v: float, dt: float) -> tuple[np.ndarray, float]:
        """Return the state after a step, and mu; see ``Law.step``. Speeds count by their mean."""
        speed, phi = max(mean_speed(state[0], v), LEAST), state[1]
        steady, x = math.log(self.velocity / speed), speed * dt / self.length
        if not self.ageing:
            phi = steady + (phi - steady) * math.exp(-x)
        elif x > 0.0:  # theta v/D_c becomes 1 + (theta v/D_c - 1) exp(-x); at rest it grows by dt
            phi = float(np.logaddexp(steady + math.log(-math.expm1(-x)), phi - x))
        return np.array([v, phi]), self._mu(v, phi)

    def _mu(self, v: float, phi: float) -> float:
        power = min((self.mu + self.b * phi) / self.a, LARGEST)
        return self.a * math.asinh(0.5 * v / self.velocity * math.exp(power))

    def steady(self, v: ArrayLike) -> np.ndarray:
        """Return mu_ss(v), that of the slowest speed and less with v below it."""
        flat = [
            self._mu(each, float(self._init(each)[1])) for each in np.ravel(finite_numbers("v", v))
        ]
        return np.reshape(flat, np.shape(v))


@dataclass(frozen=True)
class LuGreLaw(Law):
    """LuGre: one bristle, a Stribeck curve, a damping and a viscous part."""

    kind: ClassVar[str] = "lugre"
    times: ClassVar[Mapping[str, int]] = {"damping": 1, "viscous": 1, "stribeck": -1}
    stiffness: float  # sigma_0, 1/m
    damping: float  # sigma_1, s/m
    viscous: float  # sigma_2, s/m
    coulomb: float  # mu_c
    static: float  # mu_s
    stribeck: float  # v_s, m/s

    def _limit(self, v: ArrayLike) -> Any:
        fall = np.exp(-np.minimum((np.asarray(v) / self.stribeck) ** 2, LARGEST))
        return self.coulomb + (self.static - self.coulomb) * fall

    def _init(self, velocity: float) -> np.ndarray:
        """Return (v, s) of steady sliding; at rest the bristle is slack."""
        return np.array([velocity, np.sign(velocity) * float(self._limit(velocity))])

    def _step(self, state: np.ndarray, v: float, dt: float) -> tuple[np.ndarray, float]:
        """Return the state after a step, and mu; see ``Law.step``. Velocities count by the mean."""
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


KINDS: dict[str, type[Law]] = {law.kind: law for law in (MemoryLaw, RateStateLaw, LuGreLaw)}
READ: dict[str, type[Law | LoadLaw]] = {**KINDS, LoadLaw.kind: LoadLaw}


def read_law(source: str | Path) -> Law | LoadLaw:
    """Return the law of a JSON text, or of a file of it. Raises UserError for what is none."""
    text: str | bytes
    if isinstance(source, Path):
        place, text = str(source), read_whole(source)
    else:
        place, text = "the law", source
    try:
        found = json.loads(text)
        kind: type[Law | LoadLaw] = READ[found["kind"]]
        if found["format"] != FORMAT:
            raise ValueError(f"its format is {found['format']}, not {FORMAT}")
        told = asdict(Validity()) | {
            each.name: found["validity"][each.name]
            for each in fields(Validity)
            if each.name not in ADDED or each.name in found["validity"]
        }
        told["motions"] = tuple((str(name), float(rms)) for name, rms in told["motions"])
        numbers = {k: float(each) for k, each in told.items() if k not in WORDS}
        validity = Validity(**{**told, **numbers})
        own = {each.name: found[each.name] for each in fields(kind) if each.name != "validity"}
        values = {k: np.array(v, float) if isinstance(v, list) else v for k, v in own.items()}
        return kind(**values, validity=validity)
    except (LookupError, TypeError, ValueError) as error:
        raise LawError(f"{place}: is no law of this program as JSON: {error}") from error
