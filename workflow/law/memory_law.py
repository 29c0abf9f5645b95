"""Law with exponential states: a direct effect, n states and the age of contacts.

    mu = g (D(v) + sum_j z_j)
    dz_j/dt = (|v|/D_j + 1/t_j) (Z_j(v) - z_j),   dg/dt = (|v|/D_c + 1/t_c) (g_s(|v|) - g)

The state z_j holds the memory of the motion over a length D_j and a time t_j. The age of contacts
g corresponds to the state of rate-and-state friction and is 1 at the fastest speed. D and Z_j are
odd in v, g_s is even. All three are tables, linear in v between speeds and constant above the
fastest. Between rest and the slowest speed D and Z_j are linear and g_s is constant. Steady
friction is

    mu_ss(v) = g_s(|v|) (D(v) + sum_j Z_j(v)),

odd in v, and linear in v below the slowest speed. At constant v a step is exact. For v linear in
time each small part of a step (``divided``) is of second order: it uses the rates at the mean speed
of the part, and targets linear in time.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from ..given_motion import LawError, finite_numbers
from .memory_names import checked_names, memory_texts
from .reduced_law import Law, mean_speed

SERIES_STEP = 1e-6  # relative to the relaxation time; shorter steps use a series


def odd(v: ArrayLike, speeds: np.ndarray, table: np.ndarray) -> np.ndarray:
    """Interpolate odd tables (..., speeds): zero at rest, linear in v, constant above."""
    at = np.abs(v)
    above = np.minimum(np.searchsorted(speeds, at), speeds.size - 1)
    low = np.where(above > 0, speeds[above - 1], 0.0)
    share = np.minimum((at - low) / (speeds[above] - low), 1.0)
    before = np.where(above > 0, table[..., above - 1], 0.0)
    return np.sign(v) * (before + share * (table[..., above] - before))


def even(v: ArrayLike, speeds: np.ndarray, table: np.ndarray) -> np.ndarray:
    """Interpolate even tables (..., speeds): linear in |v|, constant below and above."""
    at = np.clip(np.abs(v), speeds[0], speeds[-1])
    above = np.maximum(np.searchsorted(speeds, at), 1)
    share = (at - speeds[above - 1]) / (speeds[above] - speeds[above - 1])
    return table[..., above - 1] + share * (table[..., above] - table[..., above - 1])


def relaxed_to(state: np.ndarray, old: np.ndarray, new: np.ndarray, x: np.ndarray) -> np.ndarray:
    """Return states after a step of x relaxation times with a target linear in time."""
    mean = np.where(
        x > SERIES_STEP, -np.expm1(-x) / np.where(x > SERIES_STEP, x, 1.0), 1.0 - 0.5 * x
    )
    return new + (state - old) * np.exp(-x) - (new - old) * mean


@dataclass(frozen=True)
class MemoryLaw(Law):
    """Law with a direct effect, n exponential states and the age of contacts."""

    kind: ClassVar[str] = "states"
    times: ClassVar[Mapping[str, int]] = {"speed": -1, "rate": -1}
    speed: np.ndarray  # speeds of the tables, m/s, positive and increasing, shape (speeds,)
    direct: np.ndarray  # direct effect D, shape (speeds,)
    target: np.ndarray  # targets Z_j, shape (n, speeds)
    rate_per_length: np.ndarray  # 1/D_c, then 1/D_j, 1/m, shape (n + 1,)
    rate: np.ndarray  # 1/t_c, then 1/t_j, 1/s, shape (n + 1,)
    age: np.ndarray  # contact age g_s, shape (speeds,)
    names: tuple[str, ...] = field(default=(), kw_only=True)  # of the memories g, z_1 ... z_n

    def __post_init__(self) -> None:
        """Raise UserError for tables with inconsistent shapes or values."""
        for name in ("speed", "direct", "target", "rate_per_length", "rate", "age"):
            object.__setattr__(self, name, np.asarray(getattr(self, name), float))
        if not self.target.size:
            object.__setattr__(self, "target", np.zeros((0, self.speed.size)))
        count, states = self.speed.size, self.target.shape[0]
        tables = self.direct.shape == self.age.shape == (count,) and count > 1
        rates = self.rate.shape == self.rate_per_length.shape == (states + 1,)
        if not (tables and rates and self.target.shape == (states, count)):
            raise LawError(
                "the tables must hold two speeds or more, and one value per speed and state"
            )
        positive = bool((np.diff(self.speed, prepend=0.0) > 0.0).all())
        if not positive or min(self.rate.min(), self.rate_per_length.min()) < 0.0:
            raise LawError("speed must be positive and increasing; rates must not be negative")
        object.__setattr__(self, "names", checked_names(self.names, states + 1))

    @property
    def numbers(self) -> int:
        """Return the length of a state vector."""
        return self.rate.size + 1

    def _init(self, velocity: float) -> np.ndarray:
        """Return the state (v, g, z_1 ... z_n) of steady sliding."""
        return np.concatenate([[velocity], self._targets(velocity)])

    def _targets(self, v: float) -> np.ndarray:
        """Return g_s and Z_j at a velocity."""
        odds = odd(v, self.speed, self.target)
        return np.concatenate([[even(v, self.speed, self.age)], odds])

    def _step(self, state: np.ndarray, v: float, dt: float) -> tuple[np.ndarray, float]:
        """Return the state and mu after a step; see ``Law.step``."""
        x = dt * (mean_speed(state[0], v) * self.rate_per_length + self.rate)
        after = relaxed_to(state[1:], self._targets(state[0]), self._targets(v), x)
        mu = after[0] * (float(odd(v, self.speed, self.direct)) + float(np.sum(after[1:])))
        return np.concatenate([[v], after]), float(mu)

    def steady(self, v: ArrayLike) -> np.ndarray:
        """Return mu_ss(v)."""
        v = finite_numbers("v", v)
        total = self.direct + self.target.sum(axis=0)
        return even(v, self.speed, self.age) * odd(v, self.speed, total)

    def memories(self) -> list[str]:
        """Return the names of the memories with their lengths and times."""
        return memory_texts(self.names, self.rate_per_length[None], self.rate[None])

    def outside(self) -> str:
        """Return a text on the behaviour of the law outside its range."""
        return (
            f"below {self.validity.slowest:.3g} m/s mu decreases to zero at rest, in proportion to "
            f"v below {self.speed[0]:.3g} m/s; {self._above()}"
        )

    def _above(self) -> str:
        return f"the tables clamp the speed to {self.speed[-1]:.3g} m/s"

    def _smallest_speed(self, fastest: float) -> float:
        """Return the slowest speed of the tables, which are linear below it."""
        return float(self.speed[0])
