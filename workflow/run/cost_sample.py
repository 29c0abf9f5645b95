"""Core time of a study, estimated from a random sample of its work.

A draw computes and times some lines of one piece of work in this process. Pieces are drawn with
known probabilities. Each time is divided by the probability of its draw; the mean of these ratios
is an unbiased estimate of the total, however wrong the predicted times are (M. H. Hansen and W. N.
Hurwitz, Ann. Math. Stat. 14 (1943) 333, doi:10.1214/aoms/1177731356). Wrong predictions increase
the standard error, which is computed as for independent draws.
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

DRAW_SECONDS = 0.2  # predicted time of a draw, unless its smallest possible share takes longer
TYPICAL_DRAWS = 40  # draws are shortened so that about this many fit into a short time limit
MIN_DRAWS = 8  # number of draws from which a standard error is given
GOLDEN_RATIO = 0.5 * (math.sqrt(5.0) - 1.0)


class CostSample(NamedTuple):
    """Estimated core time of a study."""

    seconds: float  # core time, s
    error: float | None  # standard error; None with fewer than MIN_DRAWS draws
    draws: int

    def __str__(self) -> str:
        """Return the estimate as text, such as "12.5 ± 0.4 core-hours from 43 samples"."""
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

    size: int  # realizations per unit; a unit is a block, a quartet of lines, or one map
    units: int  # number of units in the piece
    drawn: int  # number of units in a draw
    lines: int  # number of realizations computed in each drawn unit

    @property
    def share(self) -> float:
        """Share of the piece that is computed."""
        return self.drawn * self.lines / (self.units * self.size)


def sample_cost(plan: Plan, seconds: float) -> CostSample:
    """Estimate the core time of a study from draws that take about ``seconds`` of core time.

    The seed of the study determines the sequence of draws; their measured times determine its
    length. No draw begins after ``seconds``, but a running draw is completed and at least one runs.
    """
    missing = missing_work(plan, ())
    pieces = cut(missing, batch_target(total_seconds(missing)))
    draw_seconds = min(DRAW_SECONDS, seconds / TYPICAL_DRAWS)
    shares = [share_of(piece, draw_seconds) for piece in pieces]
    weights = draw_weights(pieces, shares, draw_seconds)
    generator = np.random.default_rng(plan.study.seed)
    _warm_up(plan, pieces, shares)
    ends, start = np.cumsum(weights), generator.random()
    estimates: list[float] = []
    spent = 0.0
    while not estimates or spent < seconds:
        # A low-discrepancy sequence spreads any number of draws evenly over the pieces.
        place = (start + GOLDEN_RATIO * len(estimates)) % 1.0
        row = int(np.searchsorted(ends, place * ends[-1], side="right"))
        batch = drawn_batch(pieces[row], shares[row], generator)
        used = block_means(batch).seconds
        spent += used
        estimates.append(used / shares[row].share * ends[-1] / weights[row])
    error = stdev(estimates) / math.sqrt(len(estimates)) if len(estimates) >= MIN_DRAWS else None
    return CostSample(mean(estimates), error, len(estimates))


def share_of(piece: Missing, seconds: float) -> Share:
    """Return the share of a piece predicted to take ``seconds``, or the smallest possible share.

    Blocks are split, except those of measured lines and of lines also run with halved steps.
    """
    size = piece.variant.block_size
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
    """Return the unnormalised probabilities of the pieces, shape (pieces,).

    They are proportional to the predicted time of a piece. If a draw takes longer than ``seconds``,
    they are divided by the square root of its time, which minimises the error for a given time.
    """
    predicted = np.array([piece.blocks * piece.seconds for piece in pieces])
    drawn = predicted * np.array([share.share for share in shares])
    return predicted / np.sqrt(np.maximum(drawn, seconds))


def drawn_batch(piece: Missing, share: Share, generator: np.random.Generator) -> Batch:
    """Return a batch of randomly chosen lines of a piece."""
    first = piece.first_block * piece.variant.block_size // share.size
    first += int(generator.integers(share.units - share.drawn + 1))
    batch = batch_of(piece, first, share.drawn)
    return replace(batch, realizations_per_block=share.lines)


def _warm_up(plan: Plan, pieces: list[Missing], shares: list[Share]) -> None:
    """Compile or load the kernels, and run one short untimed draw of each variant."""
    generator = np.random.default_rng(plan.study.seed)
    with report_compilation("the kernels needed", "10 to 60 s", cache.WAITING_EVENT):
        for variant in plan.variants:
            load_kernels(variant.lines.body, variant.numerics.scheme, variant.quantities)
            rows = [row for row, piece in enumerate(pieces) if piece.variant is variant]
            row = min(rows, key=lambda row: pieces[row].seconds * shares[row].share)
            block_means(drawn_batch(pieces[row], shares[row], generator))
