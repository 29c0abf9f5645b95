"""Friction of steady sliding and of the jump from it, at as many samples as the contacts need."""

import math
from typing import NamedTuple

import numpy as np

from kernels.friction import elastic_correction, quadrature, step_average
from kernels.patches.refined import NARROW, Refined, refined
from kernels.patches.samples import samples_per_contact
from kernels.rheology.kelvin import SCHEMES
from kernels.rheology.law import State
from kernels.steady import steady_sliding
from kernels.surfaces.line import Line


class Sliding(NamedTuple):
    """Steady sliding on one line."""

    state: State  # on the samples of the line, from which a march starts
    seen: Refined  # where friction is read: the line itself, or finer samples of its contacts
    speed: float  # vbar
    mu: float  # in h/dx
    summed: float  # mu as quadrature gives it
    contact: float  # share of the line
    indentation: float  # in h, over the mean line
    samples: float  # of the line per contact; below 1 where finer ones tell
    updates: int  # of elements, the measure of cost


def steady_friction(line: Line, speed: float, scheme: str, load: float) -> Sliding:
    """Return steady sliding and its friction. speed : vbar; load : n Fbar.

    Contacts of fewer than NARROW samples are refined (refined.py) where the line allows it.
    """
    law = SCHEMES[scheme](1.0 / (line.steps_per_spacing * speed))
    state, sweeps = steady_sliding(law, line.z, load)
    samples = samples_per_contact(state.d - (line.z - state.w))
    seen = Refined(line, state, load, 1.0, samples)
    updates = sweeps * line.z.size
    if samples < NARROW:
        finer = refined(line, speed, scheme, load, state)
        if finer is not None:
            seen = finer
            samples = finer.samples * line.steps_per_spacing / finer.line.steps_per_spacing
            updates += finer.line.z.size
    mu, summed, contact = _friction(seen, speed)
    indentation = seen.state.d + line.datum
    contact *= seen.share
    return Sliding(state, seen, speed, mu, summed, contact, indentation, samples, updates)


def jump(sliding: Sliding, speed: float) -> float:
    """Return the change of mu at the moment when the speed becomes ``speed`` (vbar)."""
    line, state, load = sliding.seen.line, sliding.seen.state, sliding.seen.load
    mu_0, _, _ = quadrature(line.z, line.slope, *state, sliding.speed, speed, load)
    return mu_0 - sliding.summed  # errors of the elastic part cancel


def _friction(seen: Refined, speed: float) -> tuple[float, float, float]:
    """Return mu of the steady state, mu as quadrature gives it, and the share in contact.

    The first has its elastic part corrected as far as a sample lasts longer than tau: by
    measurement the better estimate there, and the worse one beyond.
    """
    line, (w, d), load = seen.line, seen.state, seen.load
    z, slope, steps = line.z, line.slope, line.steps_per_spacing
    mu, rate, contact = quadrature(z, slope, w, d, speed, speed, load)
    corrected = mu
    share = math.exp(-((steps * speed) ** 2))
    if share >= 1e-3:
        corrected += share * elastic_correction(z, slope, w, d, speed, rate, steps) / load
        # Where a contact is narrower than a sample nothing is sure, but that mu is a mean of slopes
        steepest = float(np.abs(slope[z - w < d]).max())
        corrected = min(max(corrected, -steepest), steepest)
    if line.band_limited and corrected <= 0.0:
        # ... and that it takes work: what the forces do while the line rises.
        corrected = step_average(steps * (np.roll(z, -1) - z), z - w, d)
    return corrected, mu, contact
