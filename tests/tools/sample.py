"""A random sample of the work of a plan, and what follows from it for the whole.

Batches are drawn within each variant, with repetition, in proportion to their predicted cost, and a
few of their lines by chance, or one of a quartet that takes long. The mean of measured over
predicted time of the draws, times the predicted time of the variant, estimates what the variant
takes. It does so without bias however wrong predictions are: wrong ones widen the standard error,
which is that of a mean of independent draws.
"""

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from elastomer_friction.kernels import QUARTET
from elastomer_friction.workflow.plan.batches import (
    batch_target,
    cut,
    make_batches,
    missing_work,
    total_seconds,
)
from elastomer_friction.workflow.plan.plan import Plan
from elastomer_friction.workflow.simulate import Batch

LEAST_DRAWS = 8  # of a variant: its share of the error is known then
LEAST_SECONDS = 2.0  # of a draw, predicted: what a batch begins with is lost in it
LONG_SECONDS = 8.0  # of a quartet, predicted, of which the first line alone is run


class Stratum(NamedTuple):
    """A variant of a study, cut into the batches of a run."""

    label: str
    batches: list[Batch]

    @property
    def seconds(self) -> float:
        """Predicted seconds of all batches."""
        return sum(batch.seconds for batch in self.batches)


class Draw(NamedTuple):
    """A batch that was drawn, cut down to a few of its lines."""

    label: str
    batch: Batch
    share: float  # of the lines of the batch
    first_line: int


def strata(plan: Plan) -> list[Stratum]:
    """Return the variants of a plan with the batches of a run that has nothing stored."""
    missing = missing_work(plan, set())
    target = batch_target(total_seconds(missing))
    found: dict[str, list[Batch]] = {variant.label: [] for variant in plan.variants}
    for piece in cut(plan, missing, target):
        found[piece.variant.label] += make_batches(plan, [piece], target)
    return [Stratum(label, batches) for label, batches in found.items()]


def number_of_draws(whole: list[Stratum], least: int, seconds: float) -> list[int]:
    """Return the draws of each variant, in proportion to its cost: ``least`` at least in all.

    There are more where ``seconds`` of predicted work are not reached with as many.
    """
    total = sum(stratum.seconds for stratum in whole)
    each = sum(s.seconds / total * expected_seconds(s.batches) for s in whole)
    number = max(least, math.ceil(seconds / each))
    return [max(LEAST_DRAWS, round(number * s.seconds / total)) for s in whole]


def expected_seconds(batches: list[Batch]) -> float:
    """Return the predicted seconds that a draw takes on average."""
    seconds = np.array([batch.seconds for batch in batches])
    shares = np.array([_share(*_cuts(batch)) for batch in batches])
    return float(seconds @ (seconds * shares) / seconds.sum())


def drawn(stratum: Stratum, number: int, generator: np.random.Generator) -> Iterator[Draw]:
    """Yield so many draws of a variant."""
    seconds = np.array([batch.seconds for batch in stratum.batches])
    for k in generator.choice(seconds.size, number, p=seconds / seconds.sum()):
        yield cut_down(stratum.label, stratum.batches[k], generator)


def cut_down(label: str, batch: Batch, generator: np.random.Generator) -> Draw:
    """Return a batch for a few of its lines. They are those of the study, all alike."""
    size, units, kept, lines = _cuts(batch)
    share = _share(size, units, kept, lines)
    first = batch.first_block * batch.realizations_per_block // size
    first += int(generator.integers(units - kept + 1)) if kept < units else 0
    own = replace(
        batch,
        realizations_per_block=lines,
        first_block=first,
        blocks=kept,
        seconds=share * batch.seconds,
    )
    return Draw(label, own, share, first * size)


def _cuts(batch: Batch) -> tuple[int, int, int, int]:
    """Return (lines of a unit, units, units to keep, lines of each to keep).

    A unit is a quartet of a batch, or a block of other numbers.
    """
    size, units = batch.realizations_per_block, batch.blocks
    if size % QUARTET == 0:
        size, units = QUARTET, units * size // QUARTET
    each = batch.seconds / units
    kept = min(units, max(1, math.ceil(LEAST_SECONDS / each)))
    return size, units, kept, 1 if size == QUARTET and each > LONG_SECONDS else size


def _share(size: int, units: int, kept: int, lines: int) -> float:
    """Return the share of the lines of a batch that is kept."""
    return kept * lines / (units * size)


class Estimate(NamedTuple):
    """A number and its standard error."""

    value: float
    error: float

    def __str__(self) -> str:
        return f"{self.value:.3g} ± {self.error:.2g}"


def total(predicted: Sequence[float], ratios: Sequence[Sequence[float]]) -> Estimate:
    """Return what all variants take, in the unit of their predictions.

    ratios : measured over predicted, of every draw of each variant.
    """
    value = variance = 0.0
    for whole, own in zip(predicted, ratios, strict=True):
        value += whole * float(np.mean(own))
        variance += whole**2 * float(np.var(own, ddof=1)) / len(own)
    return Estimate(value, math.sqrt(variance))
