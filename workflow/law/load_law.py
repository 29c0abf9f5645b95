"""Laws of one surface under several normal forces, as tables over the load.

Every number of the law between two loads is linear in ln F_N between those of the laws that were
fitted to them; below the least load and above the greatest it is that of the end.
"""

import warnings
from dataclasses import dataclass, replace
from typing import ClassVar, Self

import numpy as np

from ..given_motion import LawError
from .memory_law import MemoryLaw
from .reduced_law import BeyondLawWarning, FittedLaw, finite_number

LOAD_TABLES = ("direct", "target", "rate_per_length", "rate", "age")  # that depend on the load
LEAST_LOADS = 3  # of which one can be held out


@dataclass(frozen=True)
class LoadLaw(FittedLaw):
    """The numbers of a MemoryLaw over the load; ``at`` gives the law of one load."""

    kind: ClassVar[str] = "states-over-load"
    load: np.ndarray  # N, increasing, shape (loads,)
    speed: np.ndarray  # of the tables, m/s, shape (speeds,)
    direct: np.ndarray  # D, shape (loads, speeds)
    target: np.ndarray  # Z_j, shape (loads, n, speeds)
    rate_per_length: np.ndarray  # 1/m, shape (loads, n + 1)
    rate: np.ndarray  # 1/s, shape (loads, n + 1)
    age: np.ndarray  # g_s, shape (loads, speeds)

    def __post_init__(self) -> None:
        """Raise UserError where loads do not increase or the law of one of them is none."""
        for name in ("load", "speed", *LOAD_TABLES):
            object.__setattr__(self, name, np.asarray(getattr(self, name), float))
        if not self.target.size:
            object.__setattr__(self, "target", np.zeros((self.load.size, 0, self.speed.size)))
        rising = self.load.ndim == 1 and (np.diff(self.load, prepend=0.0) > 0.0).all()
        if self.load.size < 2 or not rising:
            raise LawError("loads must be two or more, and increase from above zero")
        if any(len(getattr(self, name)) != self.load.size for name in LOAD_TABLES):
            raise LawError("the tables must hold one row of values for each load")
        for force in self.load:
            self._law(force)

    @classmethod
    def of(cls, loads: list[float], laws: list[MemoryLaw]) -> Self:
        """Return the table over loads (N), increasing, of laws of the same speeds."""
        rows = [np.array([getattr(law, name) for law in laws]) for name in LOAD_TABLES]
        return cls(np.array(loads), laws[0].speed, *rows)

    def at(
        self, *, normal_force: float | None = None, temperature: float | None = None
    ) -> MemoryLaw:
        """Return the law of one load (N), and of another temperature, as ``Law.at`` does.

        Beyond the loads of the table it warns and takes the nearest of them. Raises UserError
        without a load, and for what is no finite number above zero.
        """
        if normal_force is None:
            raise LawError(f"normal_force: missing; the law is a table over {self._loads()} N")
        force = finite_number("normal_force", normal_force, "N")
        if not force > 0.0:
            raise LawError(f"normal_force = {force!r}: must be greater than zero")
        nearest = float(np.clip(force, self.load[0], self.load[-1]))
        if nearest != force:
            said = f"normal_force = {force:g}: the law was fitted to {self._loads()} N; the nearest"
            warnings.warn(f"{said}, {nearest:g} N, is taken", BeyondLawWarning, stacklevel=2)
        law = self._law(nearest)
        return law if temperature is None else law.at(temperature=temperature)

    def _law(self, force: float) -> MemoryLaw:
        k = min(max(int(np.searchsorted(self.load, force)), 1), self.load.size - 1)
        share = np.log(force / self.load[k - 1]) / np.log(self.load[k] / self.load[k - 1])
        rows = [getattr(self, name) for name in LOAD_TABLES]
        validity = replace(self.validity, normal_force=float(force))
        between = [(1.0 - share) * row[k - 1] + share * row[k] for row in rows]
        return MemoryLaw(self.speed, *between, validity=validity)

    def outside(self) -> str:
        """Return what the law does outside its range."""
        return f"{self._law(self.load[0]).outside()}; a load beyond the table is clamped to its end"

    def _loads(self) -> str:
        return f"{self.load[0]:.4g} ... {self.load[-1]:.4g}"
