"""What a worker is given and gives back: problems, tasks, batches, block means. Plain data."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from kernels import Outcome, Quantities, Seconds
from workflow.system import Maker


class Problem(NamedTuple):
    """One dimensionless problem."""

    hurst: float
    elements: int  # N = L / dx
    load: float  # Fbar = F_N / (4 G L h)
    speed: float  # vbar = v1 tau / dx
    ratio: float  # r = v2 / v1


Record = tuple[str, int]  # (key of a task, block of realizations)

# Block means of these are stored: all that a case gives but its curves and what it cost.
SCALARS = tuple(f for f in Outcome._fields if f not in ("curves", "work", "seconds"))

PHASES = ("surfaces", *Seconds._fields)  # of the work on a line; the rest is calls


@dataclass(frozen=True)
class Task:
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
    curve_samples: int
    tasks: tuple[Task, ...]
    first_block: int
    blocks: int
    realizations_per_block: int
    seconds: float  # predicted


class BatchResult(NamedTuple):
    """Block means of a batch, dimensionless: mu in h/dx, indentation in h; and what they cost."""

    scalars: np.ndarray  # shape (tasks, blocks, len(SCALARS)); NaN: not asked for
    curves: np.ndarray  # shape (tasks, blocks, samples - 1); NaN beyond the recorded steps
    spent: np.ndarray  # shape (tasks, len(PHASES)), CPU seconds; shared work in equal parts
    seconds: float  # CPU time used in all
    peak: int  # bytes, the most memory this process has had so far
    maker: Maker  # what computed them
