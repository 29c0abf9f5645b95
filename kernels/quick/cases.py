"""One realization: a line, its steady states, the jumps from them and the relaxations.

Only what is asked for is computed. Points share what they can: one line serves all loads and
speeds, its thresholds at one speed serve all loads, one steady state at v1 all velocity jumps.
"""

from collections.abc import Sequence

import numpy as np

from ..control.printed_eq3 import PrintedForce
from ..lines.line import Line
from ..model.force import ConstantForce
from .case import MARCHING, Case, Outcome, PhaseClocks, Quantities, Seconds
from .contacts.steady_friction import Grounds, Sliding, follow_contacts, steady_friction
from .march.active import active_march
from .march.given import March, SteadyState
from .memory_case import run_memory_case
from .prepared import Prepared, Together, prepare
from .relaxation import Ends, plain_relaxations
from .steady.stack import alone

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
            for row, outcomes in zip(some.rows, _run_loads(grounds, some, asked), strict=True):
                for own, outcome in zip(found, outcomes, strict=True):
                    own[row] = outcome
    return [[own[i] for i in range(len(cases))] for own in found]


def _run_loads(grounds: Grounds, some: Together, asked: Quantities) -> list[list[Outcome]]:
    """Compute cases of Kelvin elements that differ in their loads, and in what is kept.

    Return the outcomes of each case, on all the lines.
    """
    lines, n = grounds.stack.z.shape
    loads, clocks = some.loads * n, PhaseClocks(len(some.cases))
    follow = some.cases[0].refine and grounds.known_between
    one = steady_friction(grounds, some.at_speed, loads, follow)
    jumping = len(some.at_speed.others)
    clocks.lap(_work(one), 0.0 if follow else jumping * n * lines)
    if follow:
        events = follow_contacts(one)
        clocks.lap(events, 0.3 * jumping * events)  # as measured
    twos = []
    for later in some.following:
        two = one
        if later.speed != some.at_speed.speed:
            two = steady_friction(grounds, later, loads, follow)
            clocks.lap(_work(two))
            if follow:
                clocks.lap(follow_contacts(two, one))
        twos.append(two)
    return [_under_load(one, twos, i, some, asked, clocks) for i in range(len(some.cases))]


def _work(found: Sliding) -> np.ndarray:
    """Return the work under every load on all the lines, in samples."""
    return (found.updates + found.grounds.stack.z.shape[1]).sum(axis=0)


def _under_load(
    one: Sliding,
    twos: list[Sliding],
    i: int,
    some: Together,
    asked: Quantities,
    clocks: PhaseClocks,
) -> list[Outcome]:
    """Return what is found under load i on all the lines: at v1, at each v2 and between.

    twos : steady sliding at each v2, or nothing.
    """
    case, (lines, _) = some.cases[i], one.grounds.stack.z.shape
    work = one.updates[:, i].copy()
    mu_2 = np.full((lines, len(case.ratios)), np.nan)
    curves: list[list[np.ndarray]] = [[] for _ in range(lines)]
    for k, two in enumerate(twos):
        if two is not one:
            work += two.updates[:, i]
        mu_2[:, k] = two.mu[:, i]
        if asked.relaxation:
            found, updates = _curves(one, two, i, k, case.kept_steps[k], asked)
            found += two.mu[:, i : i + 1]
            for own, curve in zip(curves, found, strict=True):
                own.append(curve)
            work += updates
            clocks.lap_phase(MARCHING, i)
    jumps = one.found.jumps[:, i] if asked.jump else np.full(mu_2.shape, np.nan)
    seconds = Seconds(*(spent / lines for spent in clocks.seconds(i)))
    nothing = some.nothing
    return [
        Outcome(
            float(one.mu[j, i]),
            float(one.indentation[j, i]),
            float(one.contact[j, i]),
            float(one.samples[j, i]) if asked.relaxation else one.samples_seen(j, i),
            mu_2[j],
            jumps[j].copy(),
            curves[j],
            int(work[j]),
            seconds,
            nothing,
        )
        for j in range(lines)
    ]


def _curves(
    one: Sliding, two: Sliding, i: int, k: int, kept_steps: np.ndarray, asked: Quantities
) -> tuple[np.ndarray, np.ndarray]:
    """Return the deviation of mu from mu_2 under load i after step k, and element updates.

    On all the lines: shapes (lines, kept) and (lines,). Where the whole line touches at both
    speeds, d is the same at both, every step begins with u = z - d and ends with it, and mu is
    mu_2 at once.
    """
    stack, law = one.grounds.stack, two.at_speed.law
    lines, n = stack.z.shape
    control = (ConstantForce if asked.indentation_rate else PrintedForce)(float(one.loads[i]))
    curves, updates = np.zeros((lines, kept_steps.size)), np.zeros(lines)
    marched = ~(one.full[:, i] & two.full[:, i])
    ends = [Ends(at.decay, at.stay, at.d[:, i].copy()) for at in (one, two)]
    if not asked.indentation_rate or kept_steps[-1] * n <= FEW:
        if marched.any():
            found, work = plain_relaxations(stack, law, *ends, control, kept_steps)
            curves[marched], updates[marched] = found[marched], work[marched]
        return curves, updates
    for j in np.flatnonzero(marched).tolist():
        ground = one.grounds.each[j]
        start, end = (
            SteadyState(at.decay, at.stay[j], at.found.entered[j, i], float(at.d[j, i]))
            for at in (one, two)
        )
        rate, line = float(one.found.rates[j, i, k]), ground.line
        march = March(line.z, line.slope, ground.spans, one.at_speed.law, law, start, end, rate)
        mu, _, settled, updates[j], inside = active_march(march, control, kept_steps)
        curves[j] = mu - settled
        if not inside:
            own = (at._replace(stay=at.stay[j : j + 1], d=at.d[j : j + 1]) for at in ends)
            found, work = plain_relaxations(alone(stack, j), law, *own, control, kept_steps)
            curves[j], updates[j] = found[0], updates[j] + work[0]
    return curves, updates
