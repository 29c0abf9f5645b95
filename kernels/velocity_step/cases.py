"""One realization: a line, its steady states, the velocity jumps and the relaxations.

Only requested quantities are computed. Cases share intermediate results: one line serves all loads
and speeds, its thresholds at one speed serve all loads, and one steady state at v1 serves all
velocity jumps.
"""

from collections.abc import Sequence

import numpy as np

from ..control.printed_eq3 import PrintedForce
from ..lines.line import Line
from ..model.force import ConstantForce
from ..quick.contacts.steady_friction import (
    LineSet,
    SteadySliding,
    follow_contacts,
    steady_friction,
)
from ..quick.march.active import active_march
from ..quick.march.problem import JumpProblem, SteadyState
from ..quick.relaxation import SteadyEnds, plain_relaxations, steady_step_frictions
from ..quick.steady.spans import single_line
from .case import FIRST_STEP, JUMP, MARCHING, Case, Outcome, PhaseClocks, Quantities, Seconds
from .memory_case import run_memory_case
from .prepared import Prepared, SharedCases, prepare

MAX_PLAIN_UPDATES = 4000  # element steps up to which the plain march beats the active-set march
JUMP_WORK_SHARE = 0.3  # work of one jump relative to that of following contacts (measured)


def run_case(line: Line, case: Case, requested: Quantities) -> Outcome:
    """Compute one case on one line; see run_cases."""
    return run_cases(line, [case], requested)[0]


def run_cases(line: Line, cases: Sequence[Case], requested: Quantities) -> list[Outcome]:
    """Compute cases on one line. No outcome depends on the other cases, to the bit.

    Raises ValueError for a case that is not supported.
    """
    return run_prepared([line], prepare(cases, line.steps_per_spacing, requested))[0]


def run_prepared(lines: Sequence[Line], prepared: Prepared) -> list[list[Outcome]]:
    """Compute prepared cases on lines with equally many samples; return one list per line.

    Plain cases (Case.plain) that differ only in load and recorded steps are computed together.
    No outcome depends on the other lines, to the bit. The relaxation curve is mu_2 plus the
    difference between the step averages of mu in the march and in steady sliding at v2. It thus
    tends to mu_2 exactly, whatever the step. Raises ValueError if lines differ in the number of
    samples or in band limit, or if their steps per spacing are not those of ``prepared``.
    """
    kinds = {(line.z.size, line.steps_per_spacing, line.band_limited) for line in lines}
    if len(kinds) != 1 or lines[0].steps_per_spacing != prepared.steps_per_spacing:
        raise ValueError(f"lines must be alike, of {prepared.steps_per_spacing} steps per spacing")
    requested, cases = prepared.requested, prepared.cases
    outcomes: list[dict[int, Outcome]] = [
        {i: run_memory_case(line, cases[i], requested) for i in prepared.separate} for line in lines
    ]
    if prepared.shared:
        line_set = LineSet.of(lines, marched=requested.relaxation)
        for shared in prepared.shared:
            results = _run_shared(line_set, shared, requested)
            for row, on_lines in zip(shared.rows, results, strict=True):
                for by_case, outcome in zip(outcomes, on_lines, strict=True):
                    by_case[row] = outcome
    return [[by_case[i] for i in range(len(cases))] for by_case in outcomes]


def _run_shared(
    line_set: LineSet, shared: SharedCases, requested: Quantities
) -> list[list[Outcome]]:
    """Compute SharedCases; return one list per case, with the outcome on each line."""
    lines, n = line_set.stack.z.shape
    loads, clocks = shared.loads * n, PhaseClocks(len(shared.cases))
    stepped = shared.cases[0].stepped
    follow = shared.cases[0].refine and line_set.smooth and not stepped
    one = steady_friction(line_set, shared.constants, loads, follow)
    if stepped:
        _average_over_steps(one)
    jumps = len(shared.constants.others)
    clocks.lap(_work(one), 0.0 if follow else jumps * n * lines)
    if follow:
        events = follow_contacts(one)
        clocks.lap(events, JUMP_WORK_SHARE * jumps * events)
    twos = []
    for constants in shared.following:
        two = one
        if constants.speed != shared.constants.speed:
            two = steady_friction(line_set, constants, loads, follow)
            if stepped:
                _average_over_steps(two)
            clocks.lap(_work(two))
            if follow:
                clocks.lap(follow_contacts(two, one))
        twos.append(two)
    return [
        _outcomes_under_load(one, twos, i, shared, requested, clocks)
        for i in range(len(shared.cases))
    ]


def _average_over_steps(sliding: SteadySliding) -> None:
    """Replace friction in steady sliding by its average over a step."""
    stack, law = sliding.line_set.stack, sliding.constants.law
    for i in range(sliding.loads.size):
        sliding.mu[:, i] = steady_step_frictions(stack, law, _ends_under_load(sliding, i))


def _ends_under_load(sliding: SteadySliding, i: int) -> SteadyEnds:
    """Return the steady states under load i on all lines."""
    return SteadyEnds(sliding.decay, sliding.thresholds, sliding.d[:, i].copy())


def _work(sliding: SteadySliding) -> np.ndarray:
    """Return the work for each load, in element updates, summed over all lines."""
    return (sliding.updates + sliding.line_set.stack.z.shape[1]).sum(axis=0)


def _outcomes_under_load(
    one: SteadySliding,
    twos: list[SteadySliding],
    i: int,
    shared: SharedCases,
    requested: Quantities,
    clocks: PhaseClocks,
) -> list[Outcome]:
    """Return the outcomes of case i on all lines.

    one : steady sliding at v1. twos : steady sliding at each v2; empty if no v2 is requested.
    """
    case, (lines, _) = shared.cases[i], one.line_set.stack.z.shape
    work = one.updates[:, i].copy()
    mu_2 = np.full((lines, len(case.ratios)), np.nan)
    curves: list[list[np.ndarray]] = [[] for _ in range(lines)]
    for k, two in enumerate(twos):
        if two is not one:
            work += two.updates[:, i]
        mu_2[:, k] = two.mu[:, i]
        if requested.relaxation:
            deviations, updates = relaxations_under_load(
                one, two, i, k, case.kept_steps[k], requested
            )
            deviations += two.mu[:, i : i + 1]
            for line_curves, curve in zip(curves, deviations, strict=True):
                line_curves.append(curve)
            work += updates
            clocks.lap_phase(MARCHING, i)
    jumps = one.results.jumps[:, i] if requested.jump else np.full(mu_2.shape, np.nan)
    if case.stepped and requested.jump:
        for k, two in enumerate(twos):
            jumps[:, k] = _first_steps(one, two, i, requested) - one.mu[:, i]
        clocks.lap_phase(JUMP, i)
    seconds = Seconds(*(spent / lines for spent in clocks.seconds(i)))
    return [
        Outcome(
            float(one.mu[j, i]),
            float(one.indentation[j, i]),
            float(one.contact[j, i]),
            float(one.samples[j, i]) if requested.relaxation else one.effective_samples(j, i),
            mu_2[j],
            jumps[j].copy(),
            curves[j],
            int(work[j]),
            seconds,
            shared.no_rates,
        )
        for j in range(lines)
    ]


def _first_steps(
    one: SteadySliding, two: SteadySliding, i: int, requested: Quantities
) -> np.ndarray:
    """Return mu of the first step at v2 under load i, shape (lines,)."""
    ends = _ends_under_load(one, i), _ends_under_load(two, i)
    control = _control(one, i, requested)
    stack, law = one.line_set.stack, two.constants.law
    deviations, _ = plain_relaxations(stack, law, *ends, control, FIRST_STEP)
    return two.mu[:, i] + deviations[:, 0]


def _control(sliding: SteadySliding, i: int, requested: Quantities) -> ConstantForce | PrintedForce:
    """Return the control that keeps load i."""
    control = ConstantForce if requested.indentation_rate else PrintedForce
    return control(float(sliding.loads[i]))


def relaxations_under_load(
    one: SteadySliding,
    two: SteadySliding,
    i: int,
    k: int,
    kept_steps: np.ndarray,
    requested: Quantities,
) -> tuple[np.ndarray, np.ndarray]:
    """Return mu - mu_2 at the kept steps under load i after jump k, and the element updates.

    Their shapes are (lines, kept) and (lines,). If the whole line touches at both speeds, d does
    not change, every step begins and ends with u = z - d, and mu equals mu_2 at once.
    """
    stack, law = one.line_set.stack, two.constants.law
    lines, n = stack.z.shape
    control = _control(one, i, requested)
    curves, updates = np.zeros((lines, kept_steps.size)), np.zeros(lines)
    marched = ~(one.full[:, i] & two.full[:, i])
    ends = _ends_under_load(one, i), _ends_under_load(two, i)
    if not requested.indentation_rate or kept_steps[-1] * n <= MAX_PLAIN_UPDATES:
        if marched.any():
            plain, work = plain_relaxations(stack, law, *ends, control, kept_steps)
            curves[marched], updates[marched] = plain[marched], work[marched]
        return curves, updates
    for j in np.flatnonzero(marched).tolist():
        problem = _jump_problem(one, two, i, j, k)
        mu, _, settled, updates[j], inside = active_march(problem, control, kept_steps)
        curves[j] = mu - settled
        if not inside:
            row = slice(j, j + 1)
            line_ends = (end._replace(thresholds=end.thresholds[row], d=end.d[row]) for end in ends)
            single = single_line(stack, j)
            plain, work = plain_relaxations(single, law, *line_ends, control, kept_steps)
            curves[j], updates[j] = plain[0], updates[j] + work[0]
    return curves, updates


def _jump_problem(one: SteadySliding, two: SteadySliding, i: int, j: int, k: int) -> JumpProblem:
    """Return the JumpProblem under load i on line j after jump k."""
    data = one.line_set.lines[j]
    start, end = (
        SteadyState(at.decay, at.thresholds[j], at.results.entered[j, i], float(at.d[j, i]))
        for at in (one, two)
    )
    laws = one.constants.law, two.constants.law
    rate = float(one.results.rates[j, i, k])
    return JumpProblem(data.line.z, data.line.slope, data.spans, *laws, start, end, rate)
