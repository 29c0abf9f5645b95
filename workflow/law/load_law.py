"""Tables of the laws of one surface over the normal force.

Between two loads every table value is interpolated linearly in ln F_N. Loads outside the table are
clamped to its ends.
"""

import warnings
from dataclasses import dataclass, field, replace
from typing import ClassVar, Self

import numpy as np

from ..given_motion import LawError
from .fitted_law import FittedLaw
from .memory_law import MemoryLaw
from .memory_names import checked_names, memory_texts
from .reduced_law import BeyondLawWarning, finite_number

LOAD_TABLES = ("direct", "target", "rate_per_length", "rate", "age")  # fields with a load axis
MIN_LOADS = 3  # so that two laws can predict one between them


@dataclass(frozen=True)
class LoadLaw(FittedLaw):
    """Tables of a MemoryLaw over the load; ``at`` returns the law of one load."""

    kind: ClassVar[str] = "states-over-load"
    load: np.ndarray  # N, increasing, shape (loads,)
    speed: np.ndarray  # speeds of the tables, m/s, shape (speeds,)
    direct: np.ndarray  # direct effect D, shape (loads, speeds)
    target: np.ndarray  # targets Z_j, shape (loads, n, speeds)
    rate_per_length: np.ndarray  # 1/m, shape (loads, n + 1)
    rate: np.ndarray  # 1/s, shape (loads, n + 1)
    age: np.ndarray  # contact age g_s, shape (loads, speeds)
    names: tuple[str, ...] = field(default=(), kw_only=True)  # of the memories g, z_1 ... z_n

    def __post_init__(self) -> None:
        """Raise UserError for loads that do not increase and for invalid tables."""
        for name in ("load", "speed", *LOAD_TABLES):
            object.__setattr__(self, name, np.asarray(getattr(self, name), float))
        if not self.target.size:
            object.__setattr__(self, "target", np.zeros((self.load.size, 0, self.speed.size)))
        rising = self.load.ndim == 1 and (np.diff(self.load, prepend=0.0) > 0.0).all()
        if self.load.size < 2 or not rising:
            raise LawError("load: must hold two or more increasing positive values")
        if any(len(getattr(self, name)) != self.load.size for name in LOAD_TABLES):
            raise LawError("the tables must hold one row per load")
        object.__setattr__(self, "names", checked_names(self.names, self.rate.shape[1]))
        for force in self.load:
            self._law_at(force)

    @classmethod
    def of(cls, loads: list[float], laws: list[MemoryLaw]) -> Self:
        """Return the table of laws with the same speeds, over increasing loads (N).

        The memories keep their names if these are the same under each load.
        """
        rows = [np.array([getattr(law, name) for law in laws]) for name in LOAD_TABLES]
        same = all(law.names == laws[0].names for law in laws)
        return cls(np.array(loads), laws[0].speed, *rows, names=laws[0].names if same else ())

    def memories(self) -> list[str]:
        """Return the names of the memories with their ranges of lengths and times."""
        return memory_texts(self.names, self.rate_per_length, self.rate)

    def at(
        self, *, normal_force: float | None = None, temperature: float | None = None
    ) -> MemoryLaw:
        """Return the law of one load (N), optionally at another temperature as in ``Law.at``.

        Loads outside the table are clamped to its ends, with a warning. Raises UserError for a load
        that is missing, or not finite and positive.
        """
        if normal_force is None:
            raise LawError(
                f"normal_force: missing; must be given for a law over {self._load_text()} N"
            )
        force = finite_number("normal_force", normal_force, "N")
        if not force > 0.0:
            raise LawError(f"normal_force = {force!r}: must be greater than zero")
        nearest = float(np.clip(force, self.load[0], self.load[-1]))
        if nearest != force:
            message = (
                f"normal_force = {force:g}: outside the fitted {self._load_text()} N; using the "
                f"nearest load, {nearest:g} N"
            )
            warnings.warn(message, BeyondLawWarning, stacklevel=2)
        law = self._law_at(nearest)
        return law if temperature is None else law.at(temperature=temperature)

    def _law_at(self, force: float) -> MemoryLaw:
        """Return the law of a load (N) within the table."""
        k = min(max(int(np.searchsorted(self.load, force)), 1), self.load.size - 1)
        share = np.log(force / self.load[k - 1]) / np.log(self.load[k] / self.load[k - 1])
        rows = [getattr(self, name) for name in LOAD_TABLES]
        validity = replace(self.validity, normal_force=float(force))
        between = [(1.0 - share) * row[k - 1] + share * row[k] for row in rows]
        return MemoryLaw(self.speed, *between, names=self.names, validity=validity)

    def outside(self) -> str:
        """Return a text on the behaviour of the law outside its range."""
        return (
            f"{self._law_at(self.load[0]).outside()}; a load beyond the table is clamped to its end"
        )

    def _load_text(self) -> str:
        return f"{self.load[0]:.4g} ... {self.load[-1]:.4g}"
