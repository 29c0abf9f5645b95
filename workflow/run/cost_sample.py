"""Core time of a study, estimated from a random sample of its work.

A draw is some lines of one piece of work, computed as in a run and timed in this process. Pieces
are drawn with known probabilities. The mean of the times, each divided by the probability of its
draw, estimates the total without bias however wrong the predictions are (M. H. Hansen and W. N.
Hurwitz, Ann. Math. Stat. 14 (1943) 333, doi:10.1214/aoms/1177731356). Wrong predictions widen the
standard error, which is that of independent draws.
"""

import math
from dataclasses import replace
from statistics import mean, stdev
from typing import NamedTuple

import numpy as np

from ...kernels import QUARTET
from ...kernels.compile import cache
from ..ground import counted
from ..plan import Missing, Plan, batch_of, batch_target, cut, missing_work, total_seconds
from ..simulate import Batch, block_means, load_kernels
from ..study import HALF_SPACE
from ..system import report_compilation

DRAW_SECONDS = 0.2  # predicted, of a draw, where single lines are short enough
TYPICAL_DRAWS = 40  # in a time that is shorter than as many such draws
MIN_DRAWS = 8  # for a standard error
GOLDEN_RATIO = 0.5 * (math.sqrt(5.0) - 1.0)


class CostSample(NamedTuple):
    """Estimated core time of a study."""

    seconds: float  # of one core
    error: float | None  # standard error; None with fewer than MIN_DRAWS draws
    draws: int

    def __str__(self) -> str:
        """Return it in words: 12.5 ± 0.4 core-hours from 43 samples."""
        units = ((3600.0, "core-hours"), (60.0, "core-minutes"), (1.0, "core-seconds"))
        size, unit = next((u for u in units if self.seconds >= 2.0 * u[0]), units[-1])
        value, count = self.seconds / size, counted(self.draws, "sample")
        if self.error is None:
            return f"about {value:.2g} {unit} from {count}, too few to state an error"
        error = self.error / size
        digits = max(0, -math.floor(math.log10(error))) if error else 2
        return f"{value:.{digits}f} ± {error:.{digits}f} {unit} from {count}"


class Share(NamedTuple):
    """The lines of a piece of work that one draw computes."""

    size: int  # realizations of a unit: of a block, a quartet of lines, or one map
    units: int  # in the piece
    drawn: int  # units that are drawn
    lines: int  # realizations that are computed of each of them

    @property
    def share(self) -> float:
        """Share of the piece that is computed."""
        return self.drawn * self.lines / (self.units * self.size)


def sample_cost(plan: Plan, seconds: float) -> CostSample:
    """Return the core time of a study from draws that take about ``seconds`` of core time.

    The sequence of draws follows from the seed of the study, its length from the time that they
    take. No draw begins after ``seconds``, but one that has begun ends: at least one is computed.
    """
    missing = missing_work(plan, ())
    pieces = cut(plan, missing, batch_target(total_seconds(missing)))
    draw_seconds = min(DRAW_SECONDS, seconds / TYPICAL_DRAWS)
    shares = [share_of(plan, piece, draw_seconds) for piece in pieces]
    weights = draw_weights(pieces, shares, draw_seconds)
    generator = np.random.default_rng(plan.study.seed)
    _warm_up(plan, pieces, shares)
    ends, start = np.cumsum(weights), generator.random()
    estimates: list[float] = []
    spent = 0.0
    while not estimates or spent < seconds:
        # A sequence of low discrepancy spreads any number of draws evenly over the pieces.
        place = (start + GOLDEN_RATIO * len(estimates)) % 1.0
        row = int(np.searchsorted(ends, place * ends[-1], side="right"))
        batch = drawn_batch(plan, pieces[row], shares[row], generator)
        used = block_means(batch).seconds
        spent += used
        estimates.append(used / shares[row].share * ends[-1] / weights[row])
    error = stdev(estimates) / math.sqrt(len(estimates)) if len(estimates) >= MIN_DRAWS else None
    return CostSample(mean(estimates), error, len(estimates))


def share_of(plan: Plan, piece: Missing, seconds: float) -> Share:
    """Return the lines of a piece that are predicted to take ``seconds``, or the least there are.

    Lines of a block are alike. Measured lines, and those run with halved steps too, stay in blocks.
    """
    size = plan.study.realizations_per_block
    units, single = piece.blocks, size
    if piece.variant.lines.profile is None and not piece.variant.recording.refined_blocks:
        on_map = piece.variant.lines.body == HALF_SPACE
        unit = 1 if on_map else QUARTET
        if size % unit == 0:
            size, units, single = unit, units * size // unit, 1
    unit_seconds = piece.seconds * piece.blocks / units
    drawn = min(units, round(seconds / unit_seconds))
    return Share(size, units, drawn, size) if drawn else Share(size, units, 1, single)


def draw_weights(pieces: list[Missing], shares: list[Share], seconds: float) -> np.ndarray:
    """Return the probabilities of the pieces, up to a factor.

    They are proportional to the predicted time of a piece. Where a draw takes longer than
    ``seconds`` they fall with the root of its time, which gives the smallest error in a given time.
    """
    predicted = np.array([piece.blocks * piece.seconds for piece in pieces])
    drawn = predicted * np.array([share.share for share in shares])
    return predicted / np.sqrt(np.maximum(drawn, seconds))


def drawn_batch(plan: Plan, piece: Missing, share: Share, generator: np.random.Generator) -> Batch:
    """Return a batch of randomly chosen lines of a piece."""
    first = piece.first_block * plan.study.realizations_per_block // share.size
    first += int(generator.integers(share.units - share.drawn + 1))
    batch = batch_of(plan, piece, first, share.drawn)
    return replace(batch, realizations_per_block=share.lines)


def _warm_up(plan: Plan, pieces: list[Missing], shares: list[Share]) -> None:
    """Compile or load the kernels, and run a short draw of each variant that is not timed."""
    generator = np.random.default_rng(plan.study.seed)
    with report_compilation("the kernels needed", "10 to 60 s", cache.WAITING_EVENT):
        for variant in plan.variants:
            load_kernels(variant.lines.body, variant.numerics.scheme, plan.quantities)
            rows = [row for row, piece in enumerate(pieces) if piece.variant is variant]
            row = min(rows, key=lambda row: pieces[row].seconds * shares[row].share)
            block_means(drawn_batch(plan, pieces[row], shares[row], generator))
