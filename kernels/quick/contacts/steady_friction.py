"""Friction of steady sliding and of velocity jumps, at the samples or between them."""

from collections.abc import Sequence
from functools import cached_property
from typing import NamedTuple

import numpy as np

from ...lines.line import Line
from ...model.friction import correction_share
from ...rheology.kelvin import SCHEMES, Kelvin
from ...rheology.law import State
from ..steady.span_sliding import DecayFactors, sweep_spans
from ..steady.spans import (
    Spans,
    Stack,
    add_rises,
    single_line,
    spans_of_line,
    stack_of,
    stacked,
)
from .between_samples import MIN_SMOOTH_STEPS, FollowedColumns, slide_between
from .loads import (
    CONTACT_COLUMN,
    D_COLUMN,
    FULL_COLUMN,
    MU_COLUMN,
    PRESSED_COLUMN,
    SWEEPS_COLUMN,
    WIDTH_COLUMN,
    FrictionOptions,
    LoadTable,
    slide_on_lines,
)
from .smooth_line import SmoothLine, smooth_line

# Least effective samples of a followed contact; with as many, a sampled jump errs by 2 %.
FOLLOWED_SAMPLES = 24.0


class LineData:
    """A line of a stack, with cached data for all loads and speeds."""

    def __init__(self, line: Line, stack: Stack, row: int) -> None:
        """Store a line, its stack and its row in the stack."""
        self.line, self.stack, self.row = line, stack, row

    @cached_property
    def spans(self) -> Spans:
        """Spans of the line."""
        return spans_of_line(self.stack, self.row)

    @cached_property
    def smooth(self) -> SmoothLine:
        """The SmoothLine through as few samples as MIN_SMOOTH_STEPS allows."""
        line, stride = self.line, self.stride
        z, slope = (np.ascontiguousarray(field[::stride]) for field in (line.z, line.slope))
        return smooth_line(z, slope, stride / line.steps_per_spacing)

    @property
    def stride(self) -> int:
        """Distance, in samples, between the samples used by ``smooth``."""
        steps = self.line.steps_per_spacing
        return max(k for k in range(1, steps // MIN_SMOOTH_STEPS + 1) if steps % k == 0)


class LineSet(NamedTuple):
    """Lines with equally many samples, for which one call computes steady sliding."""

    stack: Stack
    lines: list[LineData]

    @property
    def smooth(self) -> bool:
        """Return whether contacts on the lines can be followed between their samples."""
        line = self.lines[0].line
        return line.band_limited and line.steps_per_spacing >= MIN_SMOOTH_STEPS

    @classmethod
    def of(cls, lines: Sequence[Line], marched: bool = False) -> "LineSet":
        """Return the LineSet of lines. marched : whether to add the sums that a march needs."""
        heights, slopes = [line.z for line in lines], [line.slope for line in lines]
        stack = stack_of(stacked(heights), stacked(slopes))
        if marched:
            for rows, line in zip(stack.spans.rows, lines, strict=True):
                add_rises(rows, line.z, line.slope)
        return cls(stack, [LineData(line, stack, row) for row, line in enumerate(lines)])


class SpeedConstants(NamedTuple):
    """A speed of steady sliding and the constants that it determines for all lines."""

    speed: float  # vbar
    others: np.ndarray  # speeds after a jump, vbar, shape (others,)
    scheme: str
    law: Kelvin  # for steps of one sample
    elastic_share: float  # share of the elastic part of mu that is corrected

    @classmethod
    def of(
        cls, scheme: str, steps: int, speed: float, others: tuple[float, ...] = ()
    ) -> "SpeedConstants":
        """Return the constants at ``speed`` with ``steps`` samples per spacing; speeds are vbar."""
        law = SCHEMES[scheme](1.0 / (steps * speed))
        return cls(speed, np.array(others, float), scheme, law, correction_share(steps, speed))


class SteadySliding(NamedTuple):
    """Steady sliding on lines at one speed; fields from d on have the shape (lines, loads)."""

    line_set: LineSet
    constants: SpeedConstants
    thresholds: np.ndarray  # d above which whole spans touch (spans.py), shape (lines, spans)
    decay: DecayFactors
    loads: np.ndarray  # n Fbar, shape (loads,)
    results: LoadTable  # jumps and rates are replaced by follow_contacts
    d: np.ndarray  # indentation over the deepest sample, in h, by the samples as in a march
    full: np.ndarray  # whether the whole line touches
    mu: np.ndarray  # in h/dx
    contact: np.ndarray  # share of the line
    indentation: np.ndarray  # in h, over the mean line
    samples: np.ndarray  # per contact; not an integer where contacts are followed
    updates: np.ndarray  # of elements, the measure of cost
    followed: np.ndarray  # whether contacts were followed between the samples

    def effective_samples(self, j: int, i: int) -> float:
        """Return the samples per contact that set the error of friction on line j, load i.

        Friction of contacts followed between the samples is as accurate as that of wide contacts.
        """
        samples = float(self.samples[j, i])
        return max(samples, FOLLOWED_SAMPLES) if self.followed[j, i] else samples

    def state(self, j: int, i: int) -> State:
        """Return the State at the samples of line j under load i."""
        data, d = self.line_set.lines[j], float(self.d[j, i])
        w = np.empty_like(data.line.z)
        sweep_spans(self.decay, data.line.z, data.spans, self.thresholds[j], d, None, w)
        return State(w, d)


def steady_friction(
    line_set: LineSet, constants: SpeedConstants, loads: np.ndarray, follow: bool = False
) -> SteadySliding:
    """Return steady sliding on every line, its friction and its jumps to other speeds.

    loads : n Fbar. The result for one load and line does not depend on the others.
    follow : whether friction and jumps in partial contact are left to follow_contacts.
    """
    line = line_set.lines[0].line
    steps = float(line.steps_per_spacing)
    options = FrictionOptions(steps, constants.elastic_share, line.band_limited, follow)
    thresholds, decay, results = slide_on_lines(
        constants.law, line_set.stack, constants.speed, constants.others, loads, options
    )
    table = results.table
    datum = np.array([[data.line.datum] for data in line_set.lines])
    return SteadySliding(
        line_set,
        constants,
        thresholds,
        decay,
        loads,
        results,
        table[..., D_COLUMN],
        table[..., FULL_COLUMN] > 0.0,
        table[..., MU_COLUMN],
        table[..., CONTACT_COLUMN],
        table[..., D_COLUMN] + datum,
        table[..., WIDTH_COLUMN],
        table[..., SWEEPS_COLUMN] * line_set.stack.z.shape[1],
        np.zeros(table.shape[:2], bool),
    )


def follow_contacts(sliding: SteadySliding, before: SteadySliding | None = None) -> np.ndarray:
    """Fill in friction and jumps in partial contact by following contacts between the samples.

    Return the number of patches visited per load, summed over all lines. Where rounding prevents a
    solution, friction is computed at the samples. before : sliding at another speed, already
    followed; its ratio of followed to sampled depth corrects the initial guess.
    """
    constants, events = sliding.constants, np.zeros(sliding.loads.size)
    for j, data in enumerate(sliding.line_set.lines):
        partial = np.flatnonzero(sliding.results.table[j, :, PRESSED_COLUMN] == 0.0)
        if partial.size == 0:
            continue
        guesses = _smooth_guesses(sliding, before, j, partial)
        loads = sliding.loads[partial] / data.stride
        table, jumps, rates = slide_between(
            data.smooth, constants.speed, constants.others, loads, guesses
        )
        columns = FollowedColumns(*table.T)
        solved = columns.events > 0.0
        at, rest = (j, partial[solved]), partial[~solved]
        n, steps = data.line.z.size, data.line.steps_per_spacing
        sliding.followed[at] = True
        sliding.results.jumps[at] = jumps[solved]
        sliding.results.rates[at] = rates[solved]
        sliding.mu[at] = columns.mu[solved]
        sliding.contact[at] = np.minimum(columns.length[solved] * steps / n, 1.0)
        sliding.indentation[at] = columns.d[solved] + data.line.datum
        sliding.samples[at] = columns.median_width[solved] * steps
        sliding.updates[at] += columns.events[solved]
        events[partial] += columns.events
        if rest.size:
            single = LineSet(single_line(sliding.line_set.stack, j), [data])
            sampled = steady_friction(single, constants, sliding.loads[rest])
            for field, sampled_field in zip(sliding.results, sampled.results, strict=True):
                field[j, rest] = sampled_field[0]
    return events


def _smooth_guesses(
    sliding: SteadySliding, before: SteadySliding | None, j: int, loads: np.ndarray
) -> np.ndarray:
    """Return initial guesses of d on the smooth line j for the loads with the indices ``loads``."""
    d = sliding.d[j, loads]
    if before is None:
        return d
    data = sliding.line_set.lines[j]
    deepest = data.smooth.deepest[2]
    depth = before.indentation[j, loads] - data.line.datum - deepest
    ratio = depth / (before.d[j, loads] - deepest)
    return deepest + (d - deepest) * np.where(before.followed[j, loads], ratio, 1.0)
