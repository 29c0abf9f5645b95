"""One realization: a line, its steady states, the jumps from them and the relaxations.

Only what is asked for is computed. Points share what they can: one line serves all loads and
speeds, one steady state at v1 serves all velocity jumps.
"""

import math
import time
from typing import NamedTuple

import numpy as np

from kernels.control.force import ConstantForce
from kernels.control.printed_eq3 import PrintedForce
from kernels.friction import elastic_correction, lagged_slope, quadrature, step_average
from kernels.march import march
from kernels.rheology.kelvin import SCHEMES, SHORTEST, Kelvin
from kernels.rheology.law import State
from kernels.steady import steady_sliding
from kernels.surfaces.line import Line

LOADS = (1e-100, 1e100)  # Fbar; the rounding of d does not depend on it
SPEEDS = (1e-12, 1e12)  # vbar; slower, rounding would show in the jump, which falls with v
LEAST_STEP = 1e-9  # |r - 1|, or zero; r is then known to 1e-7 of it, the jump to 1e-5


class Quantities(NamedTuple):
    """What a scene asks for."""

    steady: bool = True
    jump: bool = True
    relaxation: bool = True
    indentation_rate: bool = True  # effect: d' in the force (eq. 3 as printed drops it)


class Case(NamedTuple):
    """One load, one speed v1 and the jumps from it, on a line that is given."""

    load: float  # Fbar = F_N / (4 G L h)
    speed: float  # vbar = v1 tau / dx
    ratios: tuple[float, ...]  # v2 / v1
    kept_steps: tuple[np.ndarray, ...]  # per ratio: the steps at which the relaxation is kept
    scheme: str


class Seconds(NamedTuple):
    """CPU time of this thread in the phases of a case. No result depends on it."""

    steady: float
    jump: float
    marching: float


class Outcome(NamedTuple):
    """Results of a case; mu in h/dx, indentation in h over the mean line."""

    mu_1: float
    indentation: float
    contact_fraction: float
    mu_2: np.ndarray  # shape (ratios,)
    jump: np.ndarray  # shape (ratios,)
    curves: list[np.ndarray]  # per ratio: mu at the recorded steps, ending towards mu_2
    work: int  # element updates, the measure of cost
    seconds: Seconds


def _friction(line: Line, state: State, speed: float, load: float) -> tuple[float, float, float]:
    """Return mu of the steady state, mu as quadrature gives it, and the share in contact.

    The first has its elastic part corrected as far as a sample lasts longer than tau: by
    measurement the better estimate there, and the worse one beyond.
    """
    z, slope, w, d, steps = line.z, line.slope, state.w, state.d, line.steps_per_spacing
    mu, rate, contact = quadrature(z, slope, w, d, speed, speed, load)
    share = math.exp(-((steps * speed) ** 2))
    if share < 1e-3:
        return mu, mu, contact
    corrected = mu + share * elastic_correction(z, slope, w, d, speed, rate, steps) / load
    # Where a contact is narrower than a sample nothing is sure, but this: mu is a mean of slopes.
    steepest = float(np.abs(slope[z - w < d]).max())
    return min(max(corrected, -steepest), steepest), mu, contact


def _check(line: Line, case: Case, asked: Quantities) -> None:
    """Raise ValueError for a case without meaning, or beyond what doubles can resolve."""
    speeds = [case.speed, *(ratio * case.speed for ratio in case.ratios)]
    for name, values, (least, most) in (("load", [case.load], LOADS), ("speed", speeds, SPEEDS)):
        for value in values:
            if not least <= value <= most:
                raise ValueError(f"{name} = {value:g}: must lie between {least:g} and {most:g}")
    for ratio in case.ratios:
        if 0.0 < abs(ratio - 1.0) < 0.99 * LEAST_STEP:  # or 1e-9 itself would round out of it
            raise ValueError(f"ratio = 1 + {ratio - 1.0:g}: the step is lost in rounding")
    shortest = 1.0 / (line.steps_per_spacing * max(speeds))
    if shortest < SHORTEST:
        raise ValueError(f"speed = {max(speeds):g}: steps of {shortest:g} tau are lost in rounding")
    for kept in case.kept_steps if asked.relaxation else ():
        if not (len(kept) and kept[0] >= 1 and np.all(np.diff(kept) > 0)):
            raise ValueError("kept_steps must hold increasing step numbers from 1 on")


def run_case(line: Line, case: Case, asked: Quantities) -> Outcome:
    """Compute one case on one line.

    The relaxation curve is mu_2 plus the deviation of the marched step average from its own
    steady value, so that it ends at mu_2 exactly whatever the step. Raises ValueError for a
    case that is not supported.
    """
    _check(line, case, asked)
    n = line.z.size
    load = case.load * n
    clock = _Clock()
    one, sweeps = steady_sliding(_law(line, case, 1.0), line.z, load)
    mu_1, summed, contact = _friction(line, one, case.speed, load)
    clock.lap("steady")
    work = sweeps * n
    mu_2 = np.full(len(case.ratios), np.nan)
    jump = np.full(len(case.ratios), np.nan)
    curves = []
    for k, ratio in enumerate(case.ratios):
        speed = ratio * case.speed
        if asked.jump:
            mu_0, _, _ = quadrature(line.z, line.slope, *one, case.speed, speed, load)
            jump[k] = mu_0 - summed  # errors of the elastic part cancel
            clock.lap("jump")
        if not (asked.steady or asked.relaxation):
            continue
        law = _law(line, case, ratio)
        two, sweeps = (one, 0) if ratio == 1.0 else steady_sliding(law, line.z, load)
        mu_2[k], _, _ = _friction(line, two, speed, load)
        work += sweeps * n
        clock.lap("steady")
        if asked.relaxation:
            control = (ConstantForce if asked.indentation_rate else PrintedForce)(load)
            curve, updates = _relaxation(line, law, control, (one, two), case.kept_steps[k])
            curves.append(mu_2[k] + curve)
            work += updates
            clock.lap("marching")
    seconds = Seconds(**clock.spent)
    return Outcome(mu_1, one.d + line.datum, contact, mu_2, jump, curves, work, seconds)


def _law(line: Line, case: Case, ratio: float) -> Kelvin:
    """Return the law of the elastomer for steps of one sample at ``ratio`` times the speed."""
    return SCHEMES[case.scheme](1.0 / (line.steps_per_spacing * (ratio * case.speed)))


class _Clock:
    """Books the time since its last reading to a phase."""

    def __init__(self) -> None:
        self.spent = dict.fromkeys(Seconds._fields, 0.0)
        self.last = time.thread_time()

    def lap(self, phase: str) -> None:
        now = time.thread_time()
        self.spent[phase] += now - self.last
        self.last = now


def _relaxation(
    line: Line,
    law: Kelvin,
    control: ConstantForce | PrintedForce,
    states: tuple[State, State],
    kept_steps: np.ndarray,
) -> tuple[np.ndarray, int]:
    """Return the deviation from the steady friction at v2, and the element updates.

    states : of steady sliding at v1 and at v2.
    """
    one, two = states
    weight = lagged_slope(line.slope, law.lag)
    final = step_average(weight, line.z - two.w, two.d)
    # d stays between its steady values but for a transient. It never exceeds what one element
    # needs: the deepest sample gives d_new <= E d_old + load / K, and K (1 - E) = 1.
    work = 0
    for cap in (1.02 * max(one.d, two.d), 1.001 * max(one.d, control.load)):
        mu, _, passes, inside = march(law, control, line.z, weight, one, kept_steps, cap)
        work += passes * line.z.size
        if inside:
            break
    return mu - final, work
