"""The active-set march: like the march of model/march.py, but it steps only undecided samples.

Shorter lists pay off in long marches in which d moves far (docs/speed.md). In each step, listed and
summed samples carry the load together.
"""

from typing import NamedTuple

import numpy as np

from ...compile.jit import kernel, refcount_free_kernel
from ...model.contact import excess_at, indentation_under, lowest_threshold, overlap
from .crossings import (
    SteadyFlight,
    enter_runs,
    landing_sums,
    leave_runs,
    no_landings,
    restored_landings,
    run_entries,
    saved_landings,
)
from .kinds import listed_samples, undecided_runs
from .lists import ActiveSet, present_displacements, shorten_lists
from .problem import (
    EMPTY_BOUNDS,
    Bounds,
    extended_bounds,
    indentation_advance,
    initial_bounds,
    pressure_sums,
    spread_bounds,
    within_bounds,
)

BOUND_MARGINS = (0.05, 0.3, 2.0, 2.0)  # relative to the spread of d and D, one per attempt
FIRST_MARGIN = 0.6  # of narrower bounds, over the spread; doubled at each return to longer lists
MIN_NARROWING = 0.25  # smallest relative reduction of the spread of D worth shorter lists
FIRST_SHORTENING = 6  # first step after which lists may be shortened; grows by half each time
MAX_SHORT_LIST = 128  # number of samples below which ``overlap`` is faster than ``pressure_sums``
MIN_D_SHARE = 0.1  # smallest predicted d after the first step, over the old d
RATE_FACTOR = 1.2  # predicted change of d, over the change at the rate d' just after the jump


class MarchState(NamedTuple):
    """State of a march at the end of a step."""

    step: int
    recorded: int  # number of recorded steps so far
    d: float  # indentation
    guess: float  # predicted d after the next step
    advance: float  # D


class Recorder(NamedTuple):
    """Numbers of the recorded steps, and arrays for their friction and indentation."""

    kept_steps: np.ndarray  # increasing step numbers (first step = 1)
    mu: np.ndarray  # friction averaged over the step, in h/dx
    indentation: np.ndarray  # d at the end of the step, in h


class SavedMarch(NamedTuple):
    """Longer lists to which a march can return."""

    active: ActiveSet
    bounds: Bounds
    state: MarchState


@kernel
def active_march(problem, control, kept_steps, margins=BOUND_MARGINS):
    """March from steady sliding at v1; return (mu, indentation, settled, work, inside).

    problem : JumpProblem. control : ConstantForce.
    kept_steps : increasing step numbers (first step = 1) at which mu and d are recorded.
    mu, indentation : see model/march.py. settled : mu of steady sliding at v2, averaged over a
    step. work : element updates. inside : whether d and D stayed within the last bounds.
    """
    law, start, end = problem.law, problem.start, problem.end
    recorder = Recorder(kept_steps, np.empty(kept_steps.size), np.empty(kept_steps.size))
    guess = predict_first_indentation(control, problem)
    bounds = initial_bounds(problem, guess, margins[0])
    settled, work, inside, flight = np.nan, 0, False, SteadyFlight(start.decay.sample, start.d)
    state, last = MarchState(0, 0, start.d, guess, np.nan), kept_steps[-1]
    for attempt in range(1, len(margins) + 1):
        runs, collected, sums = undecided_runs(problem, bounds)
        listed = listed_samples(runs, collected)
        depth, moment, _ = pressure_sums(collected.c_end, collected.weight, end.d)
        settled = (sums.moment + moment) / (sums.depth + depth)
        entries = run_entries(law, listed, runs, flight, problem.z, last)
        landings = no_landings(end.d, start.d, last)
        active = ActiveSet(runs, listed, sums, entries, landings)
        inside, stop, _, updates = march_with_shortening(
            problem, control, active, bounds, state, last, recorder, 1.0
        )
        work += updates + problem.z.size
        if inside or attempt == len(margins) or not np.isfinite(stop.d):
            break
        visited = extended_bounds(bounds, stop.d, stop.advance)
        bounds = spread_bounds(law, visited, margins[attempt])
    return recorder.mu, recorder.indentation, settled, work, inside


@kernel
def march_with_shortening(problem, control, active, bounds, state, last, recorder, worth):
    """March as step_until does, with shorter lists wherever they save more than they cost.

    If d or D leaves the bounds, the march restarts with the last longer lists whose bounds hold,
    from the step at which these were in use. The next narrower bounds have a larger margin.
    active : the ActiveSet at the start. worth : factor that multiplies the savings.
    """
    law, margin = problem.law, FIRST_MARGIN
    longer = _no_saved_marches(SavedMarch(active, bounds, state))
    work, due, w = 0, FIRST_SHORTENING, np.empty(problem.z.size)
    while True:
        inside, new, visited, updates = step_until(
            problem, control, active, bounds, state, min(due, last), recorder
        )
        work += updates
        if not inside:
            while len(longer) > 0 and not within_bounds(longer[-1].bounds, new.d, new.advance):
                longer.pop()
            if len(longer) == 0:
                return False, new, visited, work
            saved, bounds, state = longer.pop()
            landings = restored_landings(active.landings, saved.landings)
            active = _with_landings(saved, landings)
            due, margin = new.step, 2.0 * margin
            continue
        state, remaining = new, last - new.step
        if remaining == 0:
            return True, state, visited, work
        narrower = narrower_bounds(law, bounds, visited, problem.end.d, margin)
        crossings = active.entries.crossings
        if worth * savings_ratio(bounds, narrower, active.listed, crossings, remaining) > 1.0:
            saved = _with_landings(active, saved_landings(active.landings))
            longer.append(SavedMarch(saved, bounds, state))
            present_displacements(law, active, state.d, w, remaining)
            past = active.landings.past[: state.step + 1]
            active = shorten_lists(law, problem.z, narrower, active, past, w, remaining)
            bounds = narrower
            work += active.listed.c.size + active.entries.crossings.arrivals.size
        due += due // 2


@kernel
def _no_saved_marches(example):
    """Return an empty list; from ``example`` numba infers the type of its items."""
    saved = [example]
    saved.pop()
    return saved


@kernel
def _with_landings(active, landings):
    """Return the ActiveSet with other Landings."""
    return ActiveSet(active.runs, active.listed, active.sums, active.entries, landings)


@refcount_free_kernel
def savings_ratio(bounds, narrower, listed, crossings, steps):
    """Return the estimated ratio of the time that shorter lists save to the time to make them."""
    old_spread = bounds.advance_max - bounds.advance_min
    saved = 1.0 - (narrower.advance_max - narrower.advance_min) / old_spread
    step_cost = 2.0 * listed.c.size + 16.0 * crossings.slot.size
    cost = 30.0 * crossings.arrivals.size + 100.0 * listed.c.size
    return steps * step_cost * saved / cost if saved > MIN_NARROWING and cost > 0.0 else 0.0


@kernel
def narrower_bounds(law, bounds, visited, d_end, margin):
    """Return Bounds inside ``bounds`` for the visited range of d, extended to its final value.

    margin : extra width on each side, relative to the spread of d and of D.
    """
    d_min, d_max = min(visited.d_min, d_end), max(visited.d_max, d_end)
    ahead = Bounds(d_min, d_max, visited.advance_min, visited.advance_max)
    new = spread_bounds(law, ahead, margin)
    return Bounds(
        max(new.d_min, bounds.d_min),
        min(new.d_max, bounds.d_max),
        max(new.advance_min, bounds.advance_min),
        min(new.advance_max, bounds.advance_max),
    )


@refcount_free_kernel
def step_until(problem, control, active, bounds, state, last, recorder):
    """March to step ``last`` while the bounds hold; return (inside, state, visited, work).

    active : ActiveSet. recorder : Recorder to fill. visited : range of d and D in these steps.
    work : element updates.
    """
    law, (_, listed, sums, entries, landings) = problem.law, active
    kept_steps, mu, indentation = recorder
    _, recorded, d, guess, advance = state
    visited, work = EMPTY_BOUNDS, 0
    for step in range(state.step + 1, last + 1):
        move_listed(law, listed, d)
        enter_runs(law, listed, entries, d)
        old = d
        landing = landing_sums(landings, step, old, 0)
        d, advance, passes = next_indentation(control, law, listed, sums, landing, old, guess)
        work += passes * listed.c.size + entries.crossings.slot.size
        if not within_bounds(bounds, d, advance):
            return False, MarchState(step, recorded, d, guess, advance), visited, work
        guess = d + (d - old)
        landings.past[step] = d
        leave_runs(listed, entries.crossings, d)
        if step == kept_steps[recorded]:
            _, depth = landing_sums(landings, step, d, 0)
            _, moment = landing_sums(landings, step, d, 1)
            mu[recorded] = average_friction(listed, sums, depth, moment, d, advance)
            indentation[recorded] = d
            recorded += 1
        visited = extended_bounds(visited, d, advance)
    return True, MarchState(last, recorded, d, guess, advance), visited, work


@refcount_free_kernel
def move_listed(law, listed, d):
    """Move every element that stays in its run to the next sample (motion/slide.py)."""
    c, z = listed.c, listed.z
    for i in range(c.size - 1):
        c[i] = z[i] - law.decay * (z[i + 1] - max(c[i + 1], d))


@refcount_free_kernel
def average_friction(listed, sums, landing_depth, landing_moment, d, advance):
    """Return mu averaged over a step by eq. 5, as step_average in model/friction.py does.

    landing_depth, landing_moment : rows 0 and 1 of landing_sums. advance : D of this step.
    """
    depth, moment, _ = pressure_sums(listed.c, listed.weight, d)
    excess = advance - sums.level
    moment += landing_moment + (sums.moment + excess * sums.weight)
    return moment / (depth + landing_depth + (sums.depth + excess * sums.samples))


@refcount_free_kernel
def predict_first_indentation(control, problem):
    """Return an estimate of d after the first step; it tends to overestimate the change of d.

    In a step d changes by about d' (1 - E) = d' / K. At almost zero load d' is mere rounding
    error, so the estimate is limited to the d at which a single element carries the load.
    """
    law, d = problem.law, problem.start.d
    new = max(d + RATE_FACTOR * problem.rate / law.stiffness, MIN_D_SHARE * d)
    return min(new, law.decay * d + control.load / law.stiffness)


class PartlyListed(NamedTuple):
    """The contact in a step: thresholds of listed samples, and sums over all others.

    Forces are divided by the stiffness of the law.
    """

    c: np.ndarray  # thresholds of the listed samples
    d_old: float  # indentation before the step
    carried: float  # force of summed samples at ``d_old``
    samples: float  # number of summed samples


@excess_at.register(PartlyListed)
def _excess_of_partly_listed(contact, load, d):
    if contact.c.size < MAX_SHORT_LIST:
        force, count = overlap(contact.c, d)
    else:
        force, _, count = pressure_sums(contact.c, None, d)
    more = contact.samples * (d - contact.d_old)
    slope = count + contact.samples
    return force + more + (contact.carried - load), slope, slope


@lowest_threshold.register(PartlyListed)
def _lowest_of_partly_listed(contact, load):
    lowest = contact.c.min() if contact.c.size > 0 else np.inf
    return lowest, lowest + load


@refcount_free_kernel
def next_indentation(control, law, listed, sums, landings, d, guess):
    """Return (d, D, number of passes over the listed samples) of a step.

    Solves n (D - level) + sum (level - a) + landings + sum max(0, d - c) = load / K (eq. 4).
    landings : number of certain landings, and their overlap at the old d (crossings.py).
    d, guess : old d, guess of the new d. The new d is inf if nothing can carry the load.
    """
    load = control.load / law.stiffness - landings[1]
    carried = sums.samples * (d / law.stiffness - sums.level) + sums.depth
    contact = PartlyListed(listed.c, d, carried, sums.samples + landings[0])
    new, passes = indentation_under(contact, load, guess)
    return new, indentation_advance(law, new, d), passes
