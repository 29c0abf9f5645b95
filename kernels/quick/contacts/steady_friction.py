"""Friction of steady sliding and of the jumps from it, at as many samples as the contacts need."""

from collections.abc import Sequence
from functools import cached_property
from typing import NamedTuple

import numpy as np

from ...lines.line import Line
from ...model.friction import corrected_share
from ...rheology.kelvin import SCHEMES, Kelvin
from ...rheology.law import State
from ..steady.carry import NO_GAPS, Decay, carry
from ..steady.spans import Spans, add_rises
from ..steady.stack import Stack, alone, spans_of_line, stack_of, stacked
from .loads import CONTACT, FULL, INDENTATION, MU, SAMPLES, SWEEPS, Found, How
from .part import Part, slide_on
from .refined import NARROW, Refined, curvatures_of, refined


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
    def curvature(self) -> np.ndarray | None:
        """z'', shape (n,), where the line is known between its samples."""
        return curvatures_of(self.line)


class Grounds(NamedTuple):
    """Lines of as many samples, on which steady sliding is found in one call."""

    stack: Stack
    each: list[Ground]

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
    others: tuple[float, ...]  # speeds jumped to, vbar
    scheme: str
    law: Kelvin  # for steps of one sample
    share: float  # of the elastic part of mu that is corrected
    at_speeds: tuple[float, np.ndarray, np.ndarray]  # as of slide_on

    @classmethod
    def of(
        cls,
        scheme: str,
        steps: int,
        speed: float,
        others: tuple[float, ...] = (),
        following: tuple[float, ...] = (),
    ) -> "AtSpeed":
        """Return what holds at ``speed`` with ``steps`` samples per spacing; all speeds vbar.

        following : speeds at which steady sliding is asked for next, for which d is guessed.
        """
        law, *later = (SCHEMES[scheme](1.0 / (steps * some)) for some in (speed, *following))
        at_speeds = speed, np.array(others, float), np.array([own.decay for own in later])
        return cls(speed, others, scheme, law, corrected_share(steps, speed), at_speeds)


class Sliding(NamedTuple):
    """Steady sliding on lines at one speed; arrays of shape (lines, loads) but for the first."""

    grounds: Grounds
    at_speed: AtSpeed
    stay: np.ndarray  # shape (lines, spans): thresholds above which contact lasts (Thresholds)
    decay: Decay
    loads: np.ndarray  # n Fbar, shape (loads,)
    found: Found  # of refined contacts its jumps are those of finer samples
    d: np.ndarray  # indentation over the deepest sample, from which a march starts, in h
    full: np.ndarray  # whether the whole line touches
    mu: np.ndarray  # in h/dx
    contact: np.ndarray  # share of the line
    indentation: np.ndarray  # in h, over the mean line
    samples: np.ndarray  # of the line per contact; below 1 where finer ones tell
    updates: np.ndarray  # of elements, the measure of cost
    seen: dict[tuple[int, int], Refined]  # (line, load) -> finer samples, if friction is read there

    def samples_seen(self, j: int, i: int) -> float:
        """Return the samples per contact that the friction on line j under load i rests on."""
        return self.seen[j, i].samples if (j, i) in self.seen else float(self.samples[j, i])

    def state(self, j: int, i: int) -> State:
        """Return the state on line j under load i, on its samples."""
        ground, d = self.grounds.each[j], float(self.d[j, i])
        w = np.empty_like(ground.line.z)
        carry(self.decay, ground.line.z, ground.spans, self.stay[j], d, None, w, NO_GAPS)
        return State(w, d)


def steady_friction(
    grounds: Grounds, at_speed: AtSpeed, loads: np.ndarray, guesses: np.ndarray | None = None
) -> Sliding:
    """Return steady sliding on every line, its friction and its jumps to other speeds.

    loads : n Fbar, guesses : of d, shape (lines, loads). What is found under a load depends on
    its own guess and on no other load or line. Narrow contacts are to be refined after it.
    """
    one = grounds.each[0].line
    if guesses is None:
        guesses = np.full((len(grounds.each), loads.size), np.nan)
    how = How(float(one.steps_per_spacing), at_speed.share, one.band_limited)
    stay, decay, found, _ = slide_on(
        at_speed.law, Part(grounds.stack), at_speed.at_speeds, loads, guesses, how
    )
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
        table[..., SWEEPS] * one.z.size,
        {},
    )


def refine(sliding: Sliding, j: int, i: int) -> bool:
    """Read friction and jumps on line j under load i from finer samples, if contacts are narrow.

    Return whether that was tried. Lines that are not known between their samples stay as they are.
    """
    ground, at_speed = sliding.grounds.each[j], sliding.at_speed
    samples = float(sliding.samples[j, i])
    if samples >= NARROW or ground.curvature is None:
        return False
    line, speeds = ground.line, (at_speed.speed, *at_speed.others)
    state, load = sliding.state(j, i), float(sliding.loads[i])
    stack, curvature = alone(sliding.grounds.stack, j), ground.curvature
    found = refined(line, stack, curvature, speeds, at_speed.scheme, load, state, samples)
    if found is None:
        return True
    sliding.seen[j, i] = found
    sliding.mu[j, i], sliding.contact[j, i] = found.mu, found.contact
    sliding.indentation[j, i] = found.d + line.datum
    sliding.samples[j, i] = found.samples / found.fold
    sliding.updates[j, i] += found.updates
    sliding.found.jumps[j, i] = found.jumps
    return True
