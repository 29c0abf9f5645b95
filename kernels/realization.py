"""One realization: a line, its steady states, the jumps from them and the relaxations.

Only what is asked for is computed. Points share what they can: one line serves all loads and
speeds, its thresholds at one speed serve all loads, one steady state at v1 all velocity jumps.
"""

from collections.abc import Sequence

import numpy as np

from kernels.active.march import active_march
from kernels.active.setting import Setting
from kernels.case import Case, Clocks, Outcome, Quantities
from kernels.control.force import ConstantForce
from kernels.control.printed_eq3 import PrintedForce
from kernels.friction import lagged_slope, step_average
from kernels.limits import LOADS, SPEEDS, check_between
from kernels.march import march
from kernels.memory_case import run_memory_case
from kernels.patches.steady_friction import Ground, Sliding, steady_friction
from kernels.rheology.spectrum import shortest_step
from kernels.surfaces.line import Line

FEW = 4000  # steps of elements: so few are stepped sooner than lists are made
LEAST_STEP = 1e-9  # |r - 1|, or zero; r is then known to 1e-7 of it, the jump to 1e-5


def _check(line: Line, case: Case, asked: Quantities) -> None:
    """Raise ValueError for a case without meaning, or beyond what doubles can resolve."""
    speeds = [abs(speed) for speed in (case.speed, *(r * case.speed for r in case.ratios))]
    check_between("load", case.load, LOADS)
    for speed in speeds:
        check_between("speed", speed, SPEEDS)
    for ratio in case.ratios:
        if 0.0 < abs(ratio - 1.0) < 0.99 * LEAST_STEP:  # or 1e-9 itself would round out of it
            raise ValueError(f"ratio = 1 + {ratio - 1.0:g}: the step is lost in rounding")
    shortest = 1.0 / (line.steps_per_spacing * max(speeds))
    if shortest < shortest_step(case.spectrum):
        raise ValueError(f"speed = {max(speeds):g}: steps of {shortest:g} tau are lost in rounding")
    for kept in case.kept_steps if asked.relaxation else ():
        if not (len(kept) and kept[0] >= 1 and (kept[1:] > kept[:-1]).all()):
            raise ValueError("kept_steps must hold increasing step numbers from 1 on")


def run_case(line: Line, case: Case, asked: Quantities) -> Outcome:
    """Compute one case on one line, as run_cases does."""
    return run_cases(line, [case], asked)[0]


def run_cases(line: Line, cases: Sequence[Case], asked: Quantities) -> list[Outcome]:
    """Compute cases on one line. What one gives does not depend on the others, to the bit.

    Kelvin elements that slide one way share what they can: those of one speed are found together.
    The relaxation curve is mu_2 plus the deviation of the marched step average from its own
    steady value, so that it ends at mu_2 exactly whatever the step. Raises ValueError for a
    case that is not supported.
    """
    for case in cases:
        _check(line, case, asked)
    outcomes: dict[int, Outcome] = {}
    together: dict[tuple, list[int]] = {}
    for i, case in enumerate(cases):
        if case.plain:
            together.setdefault((case.speed, case.scheme, case.ratios), []).append(i)
        else:
            outcomes[i] = run_memory_case(line, case, asked)
    ground = Ground.of(line) if together else None
    for rows in together.values():
        assert ground is not None
        found = _run_loads(ground, [cases[i] for i in rows], asked)
        outcomes.update(zip(rows, found, strict=True))
    return [outcomes[i] for i in range(len(cases))]


def _run_loads(ground: Ground, cases: list[Case], asked: Quantities) -> list[Outcome]:
    """Compute cases of Kelvin elements that differ in their loads, and in what is kept."""
    speed, ratios, scheme = cases[0].speed, cases[0].ratios, cases[0].scheme
    n = ground.line.z.size
    loads = np.array([case.load for case in cases]) * n
    clocks = Clocks(len(cases))
    to = tuple(ratio * speed for ratio in ratios)
    one = steady_friction(ground, speed, scheme, loads, None, to if asked.jump else ())
    clocks.lap(steady=one.updates + n, jump=one.jumps.shape[1] * n)
    shape = len(cases), len(ratios)
    mu_2 = np.full(shape, np.nan)
    jump = one.jumps if asked.jump else np.full(shape, np.nan)
    curves: list[list[np.ndarray]] = [[] for _ in cases]
    work = one.updates.copy()
    for k, ratio in enumerate(ratios):
        if not (asked.steady or asked.relaxation):
            continue
        two = one
        if ratio != 1.0:
            two = steady_friction(ground, to[k], scheme, loads, one.d)
            work += two.updates
        mu_2[:, k] = two.mu
        clocks.lap(steady=two.updates + n)
        if asked.relaxation:
            marched = np.empty(len(cases))
            for i, case in enumerate(cases):
                curve, updates = _curve(one, two, i, case.kept_steps[k], asked)
                curves[i].append(mu_2[i, k] + curve)
                marched[i] = updates
            work += marched
            clocks.lap(marching=marched + n)
    samples = one.samples if asked.relaxation else one.samples_seen
    rate = np.full(len(ratios), np.nan)
    return [
        Outcome(
            float(one.mu[i]),
            float(one.indentation[i]),
            float(one.contact[i]),
            float(samples[i]),
            mu_2[i],
            jump[i],
            curves[i],
            int(work[i]),
            clocks.seconds(i),
            rate,
        )
        for i in range(len(cases))
    ]


def _curve(
    one: Sliding, two: Sliding, i: int, kept_steps: np.ndarray, asked: Quantities
) -> tuple[np.ndarray, int]:
    """Return the deviation of mu from mu_2 under load i after the step, and element updates.

    Where the whole line touches at both speeds, d is the same at both, every step begins with
    u = z - d and ends with it, and mu is mu_2 at once.
    """
    if one.full[i] and two.full[i]:
        return np.zeros(kept_steps.size), 0
    line, control = one.ground.line, ConstantForce if asked.indentation_rate else PrintedForce
    setting = Setting(line.z, line.slope, one.law, two.law, one.state(i), two.state(i))
    return _relaxation(setting, control(float(one.loads[i])), kept_steps)


def _relaxation(
    setting: Setting, control: ConstantForce | PrintedForce, kept_steps: np.ndarray
) -> tuple[np.ndarray, int]:
    """Return the deviation from the steady friction at v2, and the element updates."""
    work = 0
    if kept_steps[-1] * setting.z.size > FEW:
        mu, _, settled, work, inside = active_march(setting, control, kept_steps)
        if inside:
            return mu - settled, work
    z, slope, _, law, one, two = setting
    weight = lagged_slope(slope, law.lag)
    # d stays between its steady values but for a transient. It never exceeds what one element
    # needs: the deepest sample gives d_new <= E d_old + load / K, and K (1 - E) = 1.
    for cap in (1.02 * max(one.d, two.d), 1.001 * max(one.d, control.load)):
        mu, _, passes, inside = march(law, control, z, weight, one, kept_steps, cap)
        work += passes * z.size
        if inside:
            break
    return mu - step_average(weight, z - two.w, two.d), work
