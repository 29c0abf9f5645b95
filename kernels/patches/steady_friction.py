"""Friction of steady sliding and of the jumps from it, at as many samples as the contacts need."""

from functools import cached_property
from typing import NamedTuple

import numpy as np

from kernels.patches.loads import (
    CONTACT,
    FULL,
    INDENTATION,
    MU,
    SAMPLES,
    SWEEPS,
    How,
    corrected_share,
)
from kernels.patches.part import Part, slide_on
from kernels.patches.refined import NARROW, Refined, curvatures_of, refined
from kernels.rheology.kelvin import SCHEMES, Kelvin
from kernels.rheology.law import State
from kernels.steady.carry import NO_GAPS, Decay, carry
from kernels.steady.spans import Spans, Thresholds, add_rises, spans_of
from kernels.surfaces.line import Line


class Ground:
    """A line, and what is shared by all loads and speeds on it."""

    def __init__(self, line: Line, marched: bool = False) -> None:
        self.line: Line = line
        self.spans: Spans = spans_of(line.z, line.slope)
        if marched:
            add_rises(self.spans.rows, line.z, line.slope)

    @cached_property
    def curvature(self) -> np.ndarray | None:
        """z'', shape (n,), where the line is known between its samples."""
        return curvatures_of(self.line)


class Pace(NamedTuple):
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
    ) -> "Pace":
        """Return the pace at ``speed`` with ``steps`` samples per spacing; all speeds vbar.

        following : speeds at which steady sliding is asked for next, for which d is guessed.
        """

        def law_at(some: float) -> Kelvin:
            return SCHEMES[scheme](1.0 / (steps * some))

        left = np.array([law_at(later).decay for later in following])
        at_speeds = speed, np.array(others, float), left
        return cls(speed, others, scheme, law_at(speed), corrected_share(steps, speed), at_speeds)


class Sliding(NamedTuple):
    """Steady sliding on one line at one speed; arrays of shape (loads,)."""

    ground: Ground
    pace: Pace
    own: Thresholds
    decay: Decay
    loads: np.ndarray  # n Fbar
    d: np.ndarray  # indentation over the deepest sample, from which a march starts, in h
    entered: np.ndarray  # displacements with which elements come to spans (steady/contacts.py)
    full: np.ndarray  # whether the whole line touches
    mu: np.ndarray  # in h/dx
    contact: np.ndarray  # share of the line
    indentation: np.ndarray  # in h, over the mean line
    samples: np.ndarray  # of the line per contact; below 1 where finer ones tell
    seen: dict[int, Refined]  # load -> finer samples, where friction is read from those
    jumps: np.ndarray  # shape (loads, speeds jumped to): change of mu at the moment
    rates: np.ndarray  # of the same shape: d' just after the jump, in h/tau
    ahead: np.ndarray  # shape (loads, speeds that follow): about d there
    updates: np.ndarray  # of elements, the measure of cost
    known: dict[int, State]  # load -> state, of the last load that was asked for

    def samples_seen(self, i: int) -> float:
        """Return the samples per contact that the friction under load i rests on."""
        return self.seen[i].samples if i in self.seen else float(self.samples[i])

    def state(self, i: int) -> State:
        """Return the state under load i on the samples of the line; it is not to be changed."""
        if i not in self.known:
            z, d = self.ground.line.z, float(self.d[i])
            w = np.empty_like(z)
            carry(self.decay, z, self.ground.spans, self.own.stay, d, None, w, NO_GAPS)
            self.known.clear()
            self.known[i] = State(w, d)
        return self.known[i]


def steady_friction(
    ground: Ground, pace: Pace, loads: np.ndarray, guesses: np.ndarray | None = None
) -> Sliding:
    """Return steady sliding, its friction and its jumps to the other speeds of its pace.

    loads : n Fbar, guesses : of d, shape (loads,). What is found under a load depends on its own
    guess and on no other load. Narrow contacts are to be refined after it.
    """
    line = ground.line
    guesses = np.full(loads.size, np.nan) if guesses is None else np.ascontiguousarray(guesses)
    how = How(float(line.steps_per_spacing), pace.share, line.band_limited)
    part = Part(line.z, line.slope, ground.spans)
    own, decay, under, _ = slide_on(pace.law, part, pace.at_speeds, loads, guesses, how)
    found, jumps, rates, entered, ahead = under
    d = found[:, INDENTATION]
    return Sliding(
        ground,
        pace,
        own,
        decay,
        loads,
        d,
        entered,
        found[:, FULL] > 0.0,
        found[:, MU],
        found[:, CONTACT],
        d + line.datum,
        found[:, SAMPLES],
        {},
        jumps,
        rates,
        ahead,
        found[:, SWEEPS] * line.z.size,
        {},
    )


def refine(sliding: Sliding, i: int) -> None:
    """Read friction and jumps under load i from finer samples, if its contacts are narrow.

    Lines that are not known between their samples stay as they are.
    """
    ground, pace, samples = sliding.ground, sliding.pace, float(sliding.samples[i])
    if samples >= NARROW or ground.curvature is None:
        return
    line, speeds = ground.line, (pace.speed, *pace.others)
    state, load = sliding.state(i), float(sliding.loads[i])
    found = refined(line, ground.spans, ground.curvature, speeds, pace.scheme, load, state, samples)
    if found is None:
        return
    sliding.seen[i] = found
    sliding.mu[i], sliding.contact[i] = found.mu, found.contact
    sliding.indentation[i] = found.d + line.datum
    sliding.samples[i] = found.samples / found.fold
    sliding.updates[i] += found.updates
    sliding.jumps[i] = found.jumps
