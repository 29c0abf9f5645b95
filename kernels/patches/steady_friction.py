"""Friction of steady sliding and of the jumps from it, at as many samples as the contacts need."""

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


class Ground(NamedTuple):
    """A line, and what is shared by all loads and speeds on it."""

    line: Line
    spans: Spans
    curvature: np.ndarray | None  # shape (n,); where it is wanted and known between its samples

    @classmethod
    def of(cls, line: Line, finer: bool = True, marched: bool = False) -> "Ground":
        """Return the ground that a line is; finer : it may be refined; marched : it is marched."""
        spans = spans_of(line.z, line.slope)
        if marched:
            add_rises(spans.rows, line.z, line.slope)
        return cls(line, spans, curvatures_of(line) if finer else None)


class Sliding(NamedTuple):
    """Steady sliding on one line at one speed; arrays of shape (loads,)."""

    ground: Ground
    own: Thresholds
    law: Kelvin  # for steps of one sample
    decay: Decay
    scheme: str
    speed: float  # vbar
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


def kelvin_at(scheme: str, line: Line, speed: float) -> Kelvin:
    """Return the law for steps of one sample at ``speed`` (vbar)."""
    return SCHEMES[scheme](1.0 / (line.steps_per_spacing * speed))


def steady_friction(
    ground: Ground,
    speed: float,
    scheme: str,
    loads: np.ndarray,
    guesses: np.ndarray | None = None,
    others: tuple[float, ...] = (),
    following: tuple[float, ...] = (),
) -> Sliding:
    """Return steady sliding, its friction and its jumps to ``others``, all speeds vbar.

    loads : n Fbar, guesses : of d, shape (loads,). following : speeds at which it is asked for
    next, for which d is guessed. What is found under a load depends on its own guess and on no
    other load. Narrow contacts are to be refined after it.
    """
    line, spans, _ = ground
    law = kelvin_at(scheme, line, speed)
    none = np.full(loads.size, np.nan)
    guesses = none if guesses is None else np.ascontiguousarray(guesses)  # compiled once
    share = corrected_share(line.steps_per_spacing, speed)
    left = np.array([kelvin_at(scheme, line, later).decay for later in following])
    at_speeds = speed, np.array(others, float), left
    how = How(float(line.steps_per_spacing), share, line.band_limited)
    part = Part(line.z, line.slope, spans)
    own, decay, under, _ = slide_on(law, part, at_speeds, loads, guesses, how)
    found, jumps, rates, entered, ahead = under
    d = found[:, INDENTATION]
    return Sliding(
        ground,
        own,
        law,
        decay,
        scheme,
        speed,
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


def refine(sliding: Sliding, i: int, others: tuple[float, ...] = ()) -> None:
    """Read friction and jumps under load i from finer samples, if its contacts are narrow.

    others : speeds jumped to. Lines that are not known between their samples stay as they are.
    """
    line, spans, curvature = sliding.ground
    if curvature is None or sliding.samples[i] >= NARROW:
        return
    speeds, state = (sliding.speed, *others), sliding.state(i)
    load, samples = float(sliding.loads[i]), float(sliding.samples[i])
    found = refined(line, spans, curvature, speeds, sliding.scheme, load, state, samples)
    if found is None:
        return
    sliding.seen[i] = found
    sliding.mu[i], sliding.contact[i] = found.mu, found.contact
    sliding.indentation[i] = found.d + line.datum
    sliding.samples[i] = found.samples / found.fold
    sliding.updates[i] += found.updates
    sliding.jumps[i] = found.jumps
