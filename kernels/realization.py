"""One realization: a line, its steady states, the jumps from them and the relaxations.

Only what is asked for is computed. Points share what they can: one line serves all loads and
speeds, its thresholds at one speed serve all loads, one steady state at v1 all velocity jumps.
"""

from collections.abc import Sequence

import numpy as np

from kernels.active.march import active_march
from kernels.active.setting import Passing, Setting
from kernels.case import Case, Clocks, Outcome, Quantities
from kernels.control.force import ConstantForce
from kernels.control.printed_eq3 import PrintedForce
from kernels.friction import lagged_slope, step_average
from kernels.limits import LOADS, SPEEDS, check_between
from kernels.march import march
from kernels.memory_case import run_memory_case
from kernels.patches.steady_friction import Ground, Sliding, refine, steady_friction
from kernels.rheology.kelvin import Kelvin
from kernels.rheology.law import State
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
            alike = case.speed, case.scheme, case.ratios, case.refine
            together.setdefault(alike, []).append(i)
        else:
            outcomes[i] = run_memory_case(line, case, asked)
    finer = any(case.refine for case in cases)
    ground = Ground.of(line, finer, asked.relaxation) if together else None
    for rows in together.values():
        assert ground is not None
        own = ground if cases[rows[0]].refine else ground._replace(curvature=None)
        found = _run_loads(own, [cases[i] for i in rows], asked)
        outcomes.update(zip(rows, found, strict=True))
    return [outcomes[i] for i in range(len(cases))]


def _run_loads(ground: Ground, cases: list[Case], asked: Quantities) -> list[Outcome]:
    """Compute cases of Kelvin elements that differ in their loads, and in what is kept."""
    speed, ratios, scheme = cases[0].speed, cases[0].ratios, cases[0].scheme
    n = ground.line.z.size
    loads = np.array([case.load for case in cases]) * n
    clocks = Clocks(len(cases))
    after = tuple(ratio * speed for ratio in ratios)
    to = after if asked.jump or asked.relaxation else ()
    following = after if asked.steady or asked.relaxation else ()
    one = steady_friction(ground, speed, scheme, loads, None, to, following)
    clocks.lap(steady=one.updates + n, jump=len(to) * n)
    twos: list[Sliding] = []
    for k, later in enumerate(following):
        two = one
        if later != speed:
            two = steady_friction(ground, later, scheme, loads, one.ahead[:, k])
            clocks.lap(steady=two.updates + n)
        twos.append(two)
    return [_under_load(one, twos, i, case, asked, clocks) for i, case in enumerate(cases)]


def _under_load(
    one: Sliding,
    twos: list[Sliding],
    i: int,
    case: Case,
    asked: Quantities,
    clocks: Clocks,
) -> Outcome:
    """Return what is found under load i: at v1, and for each velocity step at v2 and between.

    twos : steady sliding at each v2, or nothing.
    """
    n, others = one.ground.line.z.size, len(case.ratios) if asked.jump else 0
    refine(one, i, tuple(ratio * case.speed for ratio in case.ratios[:others]))
    clocks.lap_alone(i, steady=one.updates[i] + n, jump=others * n)
    none, curves, work = np.full(len(case.ratios), np.nan), [], float(one.updates[i])
    mu_2 = none.copy()
    for k, two in enumerate(twos):
        if two is not one:
            refine(two, i)
            work += two.updates[i]
        mu_2[k] = two.mu[i]
        clocks.lap_alone(i, steady=1.0)
        if asked.relaxation:
            curve, updates = _curve(one, two, i, k, case.kept_steps[k], asked)
            curves.append(mu_2[k] + curve)
            work += updates
            clocks.lap_alone(i, marching=1.0)
        if two is not one:
            two.known.clear()  # of several velocity steps one at a time is in memory
    samples = float(one.samples[i]) if asked.relaxation else one.samples_seen(i)
    return Outcome(
        float(one.mu[i]),
        float(one.indentation[i]),
        float(one.contact[i]),
        samples,
        mu_2,
        one.jumps[i].copy() if asked.jump else none,
        curves,
        int(work),
        clocks.seconds(i),
        none,
    )


def _curve(
    one: Sliding,
    two: Sliding,
    i: int,
    k: int,
    kept_steps: np.ndarray,
    asked: Quantities,
) -> tuple[np.ndarray, int]:
    """Return the deviation of mu from mu_2 under load i after step k, and element updates.

    Where the whole line touches at both speeds, d is the same at both, every step begins with
    u = z - d and ends with it, and mu is mu_2 at once.
    """
    if one.full[i] and two.full[i]:
        return np.zeros(kept_steps.size), 0
    line, spans, _ = one.ground
    control = ConstantForce if asked.indentation_rate else PrintedForce
    load, work = control(float(one.loads[i])), 0
    if kept_steps[-1] * line.z.size > FEW:
        start, end = (
            Passing(at.decay, at.own.stay, at.entered[i], float(at.d[i])) for at in (one, two)
        )
        rate = float(one.rates[i, k])
        setting = Setting(line.z, line.slope, spans, one.law, two.law, start, end, rate)
        mu, _, settled, work, inside = active_march(setting, load, kept_steps)
        if inside:
            return mu - settled, work
    law, states = two.law, (one.state(i), two.state(i))
    curve, more = plain_relaxation(line.z, line.slope, law, states, load, kept_steps)
    return curve, work + more


def plain_relaxation(
    z: np.ndarray,
    slope: np.ndarray,
    law: Kelvin,
    states: tuple[State, State],
    control: ConstantForce | PrintedForce,
    kept_steps: np.ndarray,
) -> tuple[np.ndarray, int]:
    """Return the deviation from the steady friction at v2, and the element updates.

    law : at v2. states : of steady sliding at v1 and at v2.
    """
    work, (one, two) = 0, states
    weight = lagged_slope(slope, law.lag)
    # d stays between its steady values but for a transient. It never exceeds what one element
    # needs: the deepest sample gives d_new <= E d_old + load / K, and K (1 - E) = 1.
    for cap in (1.02 * max(one.d, two.d), 1.001 * max(one.d, control.load)):
        mu, _, passes, inside = march(law, control, z, weight, one, kept_steps, cap)
        work += passes * z.size
        if inside:
            break
    return mu - step_average(weight, z - two.w, two.d), work
