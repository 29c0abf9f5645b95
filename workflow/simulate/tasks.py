"""Plain data of a worker: problems, tasks, batches and block means."""

from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np

from ...kernels import (
    KELVIN,
    NO_EFFECTS,
    ZERO_ORIGIN,
    Effects,
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
    """Properties of lines or maps other than H and N: band limits, or a measured surface."""

    rolloff: float = 0.0  # wave number of lambda_r in 2 pi/period, below it random ones are flat
    cutoff: int = 0  # number of the last mode; 0: N/2
    measured: str = ""  # identity of measured lines, or of random ones with their spectrum
    slope: float = 0.0  # rms slope of a given spectrum, in h/dx
    body: str = "foundation"  # or "half-space", which has maps (bodies.py)
    flat: bool = False  # maps of one row: uniform across, as in a line contact
    shortest: float = 2.0  # wave that matters for contacts of a map, in dx; for predictions alone
    spectrum: str = ""  # identity of a measured spectrum, of which random lines are drawn

    @property
    def given(self) -> bool:
        """Return whether a measurement gives the spectrum, for which no law of errors is known."""
        return bool(self.measured or self.spectrum)


class Problem(NamedTuple):
    """One dimensionless problem: the numbers of the paper, then those of a scene."""

    hurst: float  # for measured lines a typical value, used in predictions alone
    elements: int  # N = L / dx
    load: float  # Fbar = F_N / (4 G L h); 0 where the indentation is prescribed
    speed: float  # vbar = v1 tau / dx; v1 is before the first velocity step
    ratio: float  # r = v2 / v1, of the first velocity step
    spectrum: Spectrum = KELVIN
    surface: LineShape = LineShape()
    programme: Programme = ()  # if empty: steady states and the step from v1 to v2
    start: str = "steady"
    indentation: float | ScaledHistory | None = None  # in h over the mean line; None: a given load
    drive: Drive | None = None  # None: the programme moves the line itself
    effects: Effects = NO_EFFECTS

    @property
    def kernel_effects(self) -> Effects:
        """Return the effects on which the record depends.

        The shear of a prescribed motion without heat is added when points are reduced.
        """
        known = self.drive is not None or self.effects.heat is not None
        return self.effects if known else self.effects._replace(shear=None)

    def marched_effects(self, requested: tuple[str, ...]) -> Effects:
        """Return the effects on which a march depends; only a march can average over cycles."""
        return self.effects if "cycle_mean" in requested else self.kernel_effects

    def samples(self, steps_per_spacing: Any) -> Any:
        """Return the number of samples of the line or map.

        steps_per_spacing : a number, or an array for many problems.
        """
        along = self.elements * steps_per_spacing
        return along * self.rows(steps_per_spacing)

    def rows(self, steps_per_spacing: Any) -> Any:
        """Return the number of rows of the surface: 1 for a line and for a line contact."""
        square = self.surface.body == "half-space" and not self.surface.flat
        return self.elements * steps_per_spacing if square else 1

    @property
    def ends(self) -> tuple[float, float]:
        """Return the speeds to which mu_1 and mu_2 belong: of the first and of the last slide."""
        slides = [leg.speed for leg in self.programme if isinstance(leg, Slide)]
        return (slides[0], slides[-1]) if slides else (self.speed, self.ratio * self.speed)


Record = tuple[str, int]  # (key of a task, block of realizations)

# SCALARS : fields of an outcome with a column each; layout.py lays out the rest of a record.
OTHER_FIELDS = ("curves", "work", "seconds", "initial_rate", "tiles", "areas", "hot")
SCALARS = tuple(name for name in Outcome._fields if name not in OTHER_FIELDS)

PHASES = ("surfaces", *Seconds._fields)  # of the work on a line, without the cost of calls


class Recording(NamedTuple):
    """Settings of the samples of a march that are stored."""

    samples: int  # of a curve, approximately
    record: str = "time"  # samples are equidistant in "time", "distance", or the "log" of time
    every: int = 0  # if not 0, store every n-th step instead
    requested: tuple[str, ...] = ()  # results of a programme (kernels/scene)
    dense: tuple[str, ...] = ()  # "healing", "loop": results with additional samples
    origin: Origin = ZERO_ORIGIN  # start of a resumed programme
    refined_blocks: int = 0  # blocks whose first line is also run with halved steps
    one_slider: bool = False  # a drive pulls a single line: ``every`` counts the line's own steps,
    # and an unsteady drive is repeated with other heights
    tiles: int = 0  # per side of a single map, whose sums are stored; 0: none


class Task(NamedTuple):
    """One problem with its discretisation, and the key of its results."""

    problem: Problem
    steps_per_spacing: int
    march_steps: int  # after the jump
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
    refine: bool = True  # locate contact edges between samples (kernels/quick/contacts)
    # Heights of measured lines, a row per realization of the batch; or mode amplitudes of random
    # lines with a measured spectrum; both in h. If both are None, random lines are given by H.
    heights: np.ndarray | None = field(default=None, compare=False)
    modes: np.ndarray | None = field(default=None, compare=False)
    resumed: SavedState | None = field(default=None, compare=False)  # initial state

    @property
    def stepped(self) -> bool:
        """Return whether steady friction and jumps are those of the steps of the march.

        This shows what implicit Euler with a given number of steps does.
        """
        return self.scheme == "implicit-euler" and not self.refine


class BatchResult(NamedTuple):
    """Block means of a batch, dimensionless (mu in h/dx, indentation in h), and their cost."""

    scalars: np.ndarray  # shape (tasks, blocks, len(SCALARS)); NaN: not requested
    curves: np.ndarray  # shape (tasks, blocks, values): rows laid out by layout.py, NaN beyond
    spent: np.ndarray  # shape (tasks, len(PHASES)), CPU seconds; shared work in equal parts
    seconds: float  # total CPU time
    peak: int  # bytes, peak memory of the process so far
    maker: Maker
