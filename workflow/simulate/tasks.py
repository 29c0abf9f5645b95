"""What a worker is given and gives back: problems, tasks, batches, block means. Plain data."""

from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from ...kernels import (
    KELVIN,
    ZERO_ORIGIN,
    Origin,
    Outcome,
    Programme,
    Quantities,
    SavedState,
    Seconds,
    Slide,
    Spectrum,
)
from ...kernels.drive import Drive
from ..system import Maker

ScaledHistory = tuple[tuple[float, ...], tuple[float, ...]]  # times in tau, indentations in h


class LineShape(NamedTuple):
    """What lines, or maps, are but for H and N: random with these modes, or measured."""

    rolloff: float = 0.0  # wave number below which the spectrum is flat, in 2 pi/L; 0: none
    cutoff: int = 0  # number of the last mode; 0: N/2
    measured: str = ""  # what measured lines, or random ones like them, are known by
    slope: float = 0.0  # their rms slope, in h/dx
    body: str = "foundation"  # what is behind them; a half-space has maps (bodies.py)
    flat: bool = False  # whether maps are uniform across: one row, as in a line contact


class Problem(NamedTuple):
    """One dimensionless problem: the numbers of the paper, then what a scene adds to them."""

    hurst: float  # of measured lines a typical one, for predictions alone
    elements: int  # N = L / dx
    load: float  # Fbar = F_N / (4 G L h); 0 where the indentation is prescribed
    speed: float  # vbar = v1 tau / dx; of the first slide of a programme
    ratio: float  # r = v2 / v1; of the first velocity step of a programme
    spectrum: Spectrum = KELVIN
    surface: LineShape = LineShape()
    programme: Programme = ()  # empty: only steady states and the step from v1 to v2
    start: str = "steady"
    indentation: float | ScaledHistory | None = None  # in h over the mean line; None: a load
    drive: Drive | None = None  # whose the programme is; None: it moves the line itself

    def samples(self, steps_per_spacing: Any) -> Any:
        """Return the number of samples of its surface: of a line, or of a square map.

        steps_per_spacing : one number, or an array for many problems together.
        """
        along = self.elements * steps_per_spacing
        return along * self.rows(steps_per_spacing)

    def rows(self, steps_per_spacing: Any) -> Any:
        """Return the number of rows of its surface: 1 of a line and of a line contact."""
        square = self.surface.body == "half-space" and not self.surface.flat
        return self.elements * steps_per_spacing if square else 1

    @property
    def ends(self) -> tuple[float, float]:
        """Return the speeds that mu_1 and mu_2 belong to: of the first and of the last slide."""
        slides = [leg.speed for leg in self.programme if isinstance(leg, Slide)]
        return (slides[0], slides[-1]) if slides else (self.speed, self.ratio * self.speed)


Record = tuple[str, int]  # (key of a task, block of realizations)

# Block means of these are stored as they are; all else of a record is laid out by layout.py.
NOT_SCALARS = ("curves", "work", "seconds", "initial_rate")
SCALARS = tuple(f for f in Outcome._fields if f not in NOT_SCALARS)

PHASES = ("surfaces", *Seconds._fields)  # of the work on a line; the rest is calls


class Recording(NamedTuple):
    """What is kept of a march."""

    samples: int  # of a curve, about
    record: str = "time"  # samples evenly over "time", "distance", or the "log" of time in a leg
    every: int = 0  # keep every so many steps instead; 0: samples
    requested: tuple[str, ...] = ()  # results of a programme (kernels/scene)
    dense: tuple[str, ...] = ()  # "healing", "loop": what needs samples of its own
    origin: Origin = ZERO_ORIGIN  # where a programme begins that is resumed
    refined_blocks: int = 0  # blocks whose first line is also run with halved steps


class Task(NamedTuple):
    """One problem with its discretisation, and the key of its results."""

    problem: Problem
    steps_per_spacing: int
    march_steps: int  # to march after the jump
    key: str


@dataclass(frozen=True)
class Batch:
    """Tasks on the same random lines, for consecutive blocks of realizations."""

    seed: int
    normalisation: str
    quantities: Quantities
    scheme: str
    recording: Recording
    tasks: tuple[Task, ...]
    first_block: int
    blocks: int
    realizations_per_block: int
    seconds: float  # predicted
    refine: bool = True  # follow contacts between samples (kernels/quick/contacts)
    # Measured lines, a row for each realization of the batch, or the amplitudes of the modes of
    # random ones like them, both in h. None: random lines of H alone.
    heights: np.ndarray | None = field(default=None, compare=False)
    modes: np.ndarray | None = field(default=None, compare=False)
    resumed: SavedState | None = field(default=None, compare=False)  # where a programme goes on


class BatchResult(NamedTuple):
    """Block means of a batch, dimensionless: mu in h/dx, indentation in h; and what they cost."""

    scalars: np.ndarray  # shape (tasks, blocks, len(SCALARS)); NaN: not asked for
    curves: np.ndarray  # shape (tasks, blocks, values): rows as layout.py says, NaN beyond
    spent: np.ndarray  # shape (tasks, len(PHASES)), CPU seconds; shared work in equal parts
    seconds: float  # CPU time used in all
    peak: int  # bytes, the most memory this process has had so far
    maker: Maker  # what computed them
