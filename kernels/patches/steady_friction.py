"""Friction of steady sliding and of the jumps from it, at as many samples as the contacts need."""

import math
from typing import NamedTuple

import numpy as np

from kernels.friction import elastic_correction, quadrature, step_average
from kernels.patches.loads import (
    CONTACT,
    FULL,
    INDENTATION,
    MU,
    SAMPLES,
    SWEEPS,
    Speeds,
    slide,
)
from kernels.patches.refined import Refined, refined
from kernels.rheology.kelvin import SCHEMES, Kelvin
from kernels.rheology.law import State
from kernels.steady.carry import Decay, carry, decay_of
from kernels.steady.spans import Spans, Thresholds, spans_of, thresholds_of
from kernels.surfaces.line import Line


class Ground(NamedTuple):
    """A line, and what is shared by all loads and speeds on it."""

    line: Line
    spans: Spans

    @classmethod
    def of(cls, line: Line) -> "Ground":
        """Return the ground that a line is."""
        return cls(line, spans_of(line.z, line.slope))


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
    full: np.ndarray  # whether the whole line touches
    mu: np.ndarray  # in h/dx
    contact: np.ndarray  # share of the line
    indentation: np.ndarray  # in h, over the mean line
    samples: np.ndarray  # of the line per contact; below 1 where finer ones tell
    seen: dict[int, Refined]  # load -> finer samples, where friction is read from those
    jumps: np.ndarray  # shape (loads, speeds jumped to): change of mu at the moment
    updates: np.ndarray  # of elements, the measure of cost

    @property
    def samples_seen(self) -> np.ndarray:
        """Return the samples per contact that the friction rests on, shape (loads,)."""
        found = self.samples.copy()
        for i, finer in self.seen.items():
            found[i] = finer.samples
        return found

    def state(self, i: int) -> State:
        """Return the state under load i on the samples of the line."""
        z, d = self.ground.line.z, float(self.d[i])
        w = np.empty_like(z)
        carry(self.decay, z, self.ground.spans, self.own.stay, d, None, w)
        return State(w, d)


def steady_friction(
    ground: Ground,
    speed: float,
    scheme: str,
    loads: np.ndarray,
    guesses: np.ndarray | None = None,
    others: tuple[float, ...] = (),
) -> Sliding:
    """Return steady sliding, its friction and its jumps to ``others``, all speeds vbar.

    loads : n Fbar, guesses : of d, shape (loads,). What is found under a load depends on its own
    guess and on no other load. Narrow contacts are refined (refined.py) where the line allows it.
    """
    line, spans = ground
    law = SCHEMES[scheme](1.0 / (line.steps_per_spacing * speed))
    decay = decay_of(law)
    own = thresholds_of(line.z, line.slope, speed, law.stiffness)
    press = np.empty((len(others), own.press.size + 1))
    for k, other in enumerate(others):
        # At the speeds jumped to, only the pressures matter.
        there = thresholds_of(line.z, line.slope, other, law.stiffness)
        press[k, :-1], press[k, -1] = there.press, there.press_all
    guesses = np.full(loads.size, np.nan) if guesses is None else guesses
    share = _corrected_share(line.steps_per_spacing, speed)
    speeds = Speeds(speed, own, np.array(others, float), press)
    steps = float(line.steps_per_spacing)
    found, jumps = slide(decay, line.z, line.slope, spans, speeds, loads, guesses, steps, share)
    d = found[:, INDENTATION]
    sliding = Sliding(
        ground,
        own,
        law,
        decay,
        scheme,
        speed,
        loads,
        d,
        found[:, FULL] > 0.0,
        found[:, MU],
        found[:, CONTACT],
        d + line.datum,
        found[:, SAMPLES],
        {},
        jumps,
        found[:, SWEEPS] * line.z.size,
    )
    _refine(sliding, others)
    if line.band_limited:
        for i in np.flatnonzero(sliding.mu <= 0.0):
            seen = sliding.seen.get(int(i))
            state = seen.state if seen else sliding.state(int(i))
            sliding.mu[i] = _working(seen.line if seen else line, state)
    return sliding


def _refine(sliding: Sliding, others: tuple[float, ...]) -> None:
    """Read friction and jumps from finer samples under the loads whose contacts are narrow."""
    line, speed = sliding.ground.line, sliding.speed
    for i, samples in enumerate(sliding.samples.tolist()):
        load, d = float(sliding.loads[i]), float(sliding.d[i])
        finer = refined(line, speed, sliding.scheme, load, d, samples)
        if finer is None:
            continue
        sliding.seen[i] = finer
        mu, summed, contact = _friction(finer, speed)
        sliding.mu[i], sliding.contact[i] = mu, contact * finer.share
        sliding.indentation[i] = finer.state.d + line.datum
        coarser = line.steps_per_spacing / finer.line.steps_per_spacing
        sliding.samples[i] = finer.samples * coarser
        sliding.updates[i] += finer.line.z.size
        z, slope = finer.line.z, finer.line.slope
        for k, other in enumerate(others):
            after, _, _ = quadrature(z, slope, *finer.state, speed, other, finer.load)
            sliding.jumps[i, k] = after - summed  # errors of the elastic part cancel


def _corrected_share(steps: float, speed: float) -> float:
    """Return which share of the elastic part of mu is corrected.

    As far as a sample lasts longer than tau: by measurement the better estimate there, and the
    worse one beyond.
    """
    share = math.exp(-((steps * speed) ** 2))
    return share if share >= 1e-3 else 0.0


def _friction(seen: Refined, speed: float) -> tuple[float, float, float]:
    """Return mu of the steady state, mu as quadrature gives it, and the share in contact."""
    line, (w, d), load = seen.line, seen.state, seen.load
    z, slope, steps = line.z, line.slope, line.steps_per_spacing
    mu, rate, contact = quadrature(z, slope, w, d, speed, speed, load)
    corrected = mu
    share = _corrected_share(steps, speed)
    if share > 0.0:
        corrected += share * elastic_correction(z, slope, w, d, speed, rate, steps) / load
        steepest = float(np.abs(slope[z - w < d]).max())
        corrected = min(max(corrected, -steepest), steepest)
    return corrected, mu, contact


def _working(line: Line, state: State) -> float:
    """Return mu from the work of the forces while the line rises: it takes work to slide."""
    rise = line.steps_per_spacing * (np.roll(line.z, -1) - line.z)
    return step_average(rise, line.z - state.w, state.d)
