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
from kernels.march import march
from kernels.memory_case import run_memory_case
from kernels.patches.steady_friction import Grounds, Sliding, refine, steady_friction
from kernels.prepare import Prepared, Together, prepare
from kernels.rheology.kelvin import Kelvin
from kernels.rheology.law import State
from kernels.surfaces.line import Line

FEW = 4000  # steps of elements: so few are stepped sooner than lists are made


def run_case(line: Line, case: Case, asked: Quantities) -> Outcome:
    """Compute one case on one line, as run_cases does."""
    return run_cases(line, [case], asked)[0]


def run_cases(line: Line, cases: Sequence[Case], asked: Quantities) -> list[Outcome]:
    """Compute cases on one line. What one gives does not depend on the others, to the bit.

    Raises ValueError for a case that is not supported.
    """
    return run_prepared([line], prepare(cases, line.steps_per_spacing, asked))[0]


def run_prepared(lines: Sequence[Line], prepared: Prepared) -> list[list[Outcome]]:
    """Compute cases that are prepared for many lines on some of as many samples; one list each.

    Kelvin elements that slide one way share what they can: those of one speed are found together,
    on all the lines. What a line gives does not depend on the others, to the bit.
    The relaxation curve is mu_2 plus the deviation of the marched step average from its own
    steady value, so that it ends at mu_2 exactly whatever the step. Raises ValueError for
    lines that differ in their samples, or of other steps than the cases are prepared for.
    """
    kinds = {(line.z.size, line.steps_per_spacing, line.band_limited) for line in lines}
    if len(kinds) != 1 or lines[0].steps_per_spacing != prepared.steps_per_spacing:
        raise ValueError(f"lines must be alike, of {prepared.steps_per_spacing} steps per spacing")
    asked, cases = prepared.asked, prepared.cases
    found: list[dict[int, Outcome]] = [
        {i: run_memory_case(line, cases[i], asked) for i in prepared.alone} for line in lines
    ]
    if prepared.together:
        grounds = Grounds.of(lines, marched=asked.relaxation)
        for some in prepared.together:
            for own, outcomes in zip(found, _run_loads(grounds, some, asked), strict=True):
                own.update(zip(some.rows, outcomes, strict=True))
    return [[own[i] for i in range(len(cases))] for own in found]


def _run_loads(grounds: Grounds, some: Together, asked: Quantities) -> list[list[Outcome]]:
    """Compute cases of Kelvin elements that differ in their loads, and in what is kept."""
    n, pace, count = grounds.each[0].line.z.size, some.pace, len(some.cases)
    loads = some.loads * n
    clocks = Clocks(len(grounds.each) * count)
    ones = steady_friction(grounds, pace, loads)
    clocks.lap(_work(ones), jump=len(pace.others) * n)
    twos: list[list[Sliding]] = [[] for _ in ones]
    for k, later in enumerate(some.following):
        found = ones
        if later.speed != pace.speed:
            guesses = np.array([one.found.ahead[:, k] for one in ones])
            found = steady_friction(grounds, later, loads, guesses)
            clocks.lap(_work(found))
        for own, two in zip(twos, found, strict=True):
            own.append(two)
    return [
        [_under_load(one, own, i, some, asked, clocks, j * count + i) for i in range(count)]
        for j, (one, own) in enumerate(zip(ones, twos, strict=True))
    ]


def _work(found: list[Sliding]) -> list[float]:
    """Return the work of every line and load, in samples."""
    return [done + own.ground.line.z.size for own in found for done in own.updates.tolist()]


def _under_load(
    one: Sliding,
    twos: list[Sliding],
    i: int,
    some: Together,
    asked: Quantities,
    clocks: Clocks,
    place: int,
) -> Outcome:
    """Return what is found under load i: at v1, and for each velocity step at v2 and between.

    twos : steady sliding at each v2, or nothing. place : of this line and load on the clocks.
    """
    case, n = some.cases[i], one.ground.line.z.size
    if case.refine and refine(one, i):
        jumping = float(len(one.pace.others) * n)
        clocks.lap_alone(place, steady=one.updates[i] + n, jump=jumping)
    work, mu_2, curves = float(one.updates[i]), some.nothing.copy(), []
    for k, two in enumerate(twos):
        if two is not one:
            if case.refine and refine(two, i):
                clocks.lap_alone(place, steady=1.0)
            work += two.updates[i]
        mu_2[k] = two.mu[i]
        if asked.relaxation:
            curve, updates = _curve(one, two, i, k, case.kept_steps[k], asked)
            curves.append(mu_2[k] + curve)
            work += updates
            clocks.lap_alone(place, marching=1.0)
        if two is not one:
            two.known.clear()  # of several velocity steps one at a time is in memory
    samples = float(one.samples[i]) if asked.relaxation else one.samples_seen(i)
    return Outcome(
        float(one.mu[i]),
        float(one.indentation[i]),
        float(one.contact[i]),
        samples,
        mu_2,
        one.found.jumps[i].copy() if asked.jump else some.nothing,
        curves,
        int(work),
        clocks.seconds(place),
        some.nothing,
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
    line, law = one.ground.line, two.pace.law
    control = ConstantForce if asked.indentation_rate else PrintedForce
    load, work = control(float(one.loads[i])), 0
    if kept_steps[-1] * line.z.size > FEW:
        start, end = (
            Passing(at.decay, at.stay, at.found.entered[i], float(at.d[i])) for at in (one, two)
        )
        rate = float(one.found.rates[i, k])
        setting = Setting(line.z, line.slope, one.ground.spans, one.pace.law, law, start, end, rate)
        mu, _, settled, work, inside = active_march(setting, load, kept_steps)
        if inside:
            return mu - settled, work
    states = one.state(i), two.state(i)
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
