"""Friction of steady sliding and of the jumps from it, between the samples where that is known."""

from collections.abc import Sequence
from functools import cached_property
from typing import NamedTuple

import numpy as np

from ...lines.line import Line
from ...model.friction import correction_share
from ...rheology.kelvin import SCHEMES, Kelvin
from ...rheology.law import State
from ..steady.carry import Decay, carry
from ..steady.spans import Spans, add_rises
from ..steady.stack import Stack, alone, spans_of_line, stack_of, stacked
from .between_samples import LEAST_STEPS, Columns, slide_between
from .loads import CONTACT, FULL, INDENTATION, MU, PRESSED, SAMPLES, SWEEPS, Found, How
from .on_lines import slide_on
from .smooth_line import SmoothLine, smooth_line

# Samples per contact from which on samples keep 2 % of the jump: followed contacts are better.
AS_GOOD = 24.0


class Ground:
    """A line, and what is shared by all loads and speeds on it."""

    def __init__(self, line: Line, stack: Stack, k: int) -> None:
        """Take line k of a stack."""
        self.line, self.stack, self.row = line, stack, k

    @cached_property
    def spans(self) -> Spans:
        """What is known of spans of the line."""
        return spans_of_line(self.stack, self.row)

    @cached_property
    def smooth(self) -> SmoothLine:
        """The line between its samples, from so few of them that LEAST_STEPS or more are left."""
        line, every = self.line, self.every
        z, slope = (np.ascontiguousarray(one[::every]) for one in (line.z, line.slope))
        return smooth_line(z, slope, every / line.steps_per_spacing)

    @property
    def every(self) -> int:
        """Return k, where every k-th sample is taken for the line between them."""
        steps = self.line.steps_per_spacing
        return max(k for k in range(1, steps // LEAST_STEPS + 1) if steps % k == 0)


class Grounds(NamedTuple):
    """Lines of as many samples, on which steady sliding is found in one call."""

    stack: Stack
    each: list[Ground]

    @property
    def known_between(self) -> bool:
        """Whether the lines are known between their samples."""
        line = self.each[0].line
        return line.band_limited and line.steps_per_spacing >= LEAST_STEPS

    @classmethod
    def of(cls, lines: Sequence[Line], marched: bool = False) -> "Grounds":
        """Return the grounds that lines are; marched : they are marched too."""
        stack = stack_of(stacked([line.z for line in lines]), stacked([o.slope for o in lines]))
        if marched:
            for rows, line in zip(stack.rows, lines, strict=True):
                add_rises(rows, line.z, line.slope)
        return cls(stack, [Ground(line, stack, k) for k, line in enumerate(lines)])


class AtSpeed(NamedTuple):
    """A speed of steady sliding, and what of it is the same on all lines of as many samples."""

    speed: float  # vbar
    others: np.ndarray  # speeds jumped to, vbar, shape (others,)
    scheme: str
    law: Kelvin  # for steps of one sample
    share: float  # of the elastic part of mu that is corrected

    @classmethod
    def of(
        cls,
        scheme: str,
        steps: int,
        speed: float,
        others: tuple[float, ...] = (),
    ) -> "AtSpeed":
        """Return what holds at ``speed`` with ``steps`` samples per spacing; all speeds vbar."""
        law = SCHEMES[scheme](1.0 / (steps * speed))
        return cls(speed, np.array(others, float), scheme, law, correction_share(steps, speed))


class Sliding(NamedTuple):
    """Steady sliding on lines at one speed; arrays of shape (lines, loads) but for the first."""

    grounds: Grounds
    at_speed: AtSpeed
    stay: np.ndarray  # shape (lines, spans): thresholds above which contact lasts (Thresholds)
    decay: Decay
    loads: np.ndarray  # n Fbar, shape (loads,)
    found: Found  # its jumps and rates are those of contacts that are followed, once they are
    d: np.ndarray  # indentation over the deepest sample, from which a march starts, in h
    full: np.ndarray  # whether the whole line touches
    mu: np.ndarray  # in h/dx
    contact: np.ndarray  # share of the line
    indentation: np.ndarray  # in h, over the mean line
    samples: np.ndarray  # of the line per contact; any number where contacts are followed
    updates: np.ndarray  # of elements, the measure of cost
    followed: np.ndarray  # whether contacts are, between the samples

    def samples_seen(self, j: int, i: int) -> float:
        """Return the samples per contact that the friction on line j under load i rests on.

        Contacts that are followed between the samples are as good as wide ones.
        """
        samples = float(self.samples[j, i])
        return max(samples, AS_GOOD) if self.followed[j, i] else samples

    def state(self, j: int, i: int) -> State:
        """Return the state on line j under load i, on its samples."""
        ground, d = self.grounds.each[j], float(self.d[j, i])
        w = np.empty_like(ground.line.z)
        carry(self.decay, ground.line.z, ground.spans, self.stay[j], d, None, w)
        return State(w, d)


def steady_friction(
    grounds: Grounds, at_speed: AtSpeed, loads: np.ndarray, follow: bool = False
) -> Sliding:
    """Return steady sliding on every line, its friction and its jumps to other speeds.

    loads : n Fbar. What is found under a load depends on no other load or line.
    follow : friction and jumps are not read from samples but are to be, by follow_contacts.
    """
    line = grounds.each[0].line
    how = How(float(line.steps_per_spacing), at_speed.share, line.band_limited, follow)
    speeds = at_speed.speed, at_speed.others
    stay, decay, found = slide_on(at_speed.law, grounds.stack, speeds, loads, how)
    table = found.table
    datum = np.array([[ground.line.datum] for ground in grounds.each])
    return Sliding(
        grounds,
        at_speed,
        stay,
        decay,
        loads,
        found,
        table[..., INDENTATION],
        table[..., FULL] > 0.0,
        table[..., MU],
        table[..., CONTACT],
        table[..., INDENTATION] + datum,
        table[..., SAMPLES],
        table[..., SWEEPS] * grounds.stack.z.shape[1],
        np.zeros(table.shape[:2], bool),
    )


def follow_contacts(sliding: Sliding, before: Sliding | None = None) -> np.ndarray:
    """Find friction and jumps from contacts between the samples, where a line is not all pressed.

    Return how many patches of contact were come to under every load, on all lines, which are to be
    known between their samples. What rounding hides is read from the samples.
    before : sliding at another speed, which tells by how much samples miss the depth.
    """
    grounds, at_speed, events = sliding.grounds, sliding.at_speed, np.zeros(sliding.loads.size)
    speeds = at_speed.speed, at_speed.others
    for j, ground in enumerate(grounds.each):
        partial = np.flatnonzero(sliding.found.table[j, :, PRESSED] == 0.0)
        if partial.size == 0:
            continue
        smooth = ground.smooth
        d = sliding.d[j, partial]
        if before is not None:
            deepest = smooth.deepest[2]
            depth = before.indentation[j, partial] - ground.line.datum - deepest
            missed = depth / (before.d[j, partial] - deepest)
            d = deepest + (d - deepest) * np.where(before.followed[j, partial], missed, 1.0)
        table, *changes = slide_between(smooth, *speeds, sliding.loads[partial] / ground.every, d)
        found = Columns(*table.T)
        some = found.events > 0.0
        at, rest = (j, partial[some]), partial[~some]
        n, steps = ground.line.z.size, ground.line.steps_per_spacing
        sliding.followed[at] = True
        for own, change in zip((sliding.found.jumps, sliding.found.rates), changes, strict=True):
            own[at] = change[some]
        sliding.mu[at] = found.mu[some]
        sliding.contact[at] = np.minimum(found.length[some] * steps / n, 1.0)
        sliding.indentation[at] = found.d[some] + ground.line.datum
        sliding.samples[at] = found.median[some] * steps
        sliding.updates[at] += found.events[some]
        events[partial] += found.events
        if rest.size:
            lone = Grounds(alone(grounds.stack, j), [ground])
            sampled = steady_friction(lone, at_speed, sliding.loads[rest])
            for whole, part in zip(sliding.found, sampled.found, strict=True):
                whole[j, rest] = part[0]
    return events
