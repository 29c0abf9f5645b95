"""Steps of the active-set march with one set of lists, as long as the bounds hold."""

from typing import NamedTuple

import numpy as np

from ...compile.jit import refcount_free_kernel
from ..contacts.pressed_samples import pressure_sums
from .bounds import EMPTY_BOUNDS, extended_bounds, within_bounds
from .certain_landings import Landings, landing_sums
from .gap_crossings import Entries, enter_runs, leave_runs
from .listed_samples import ListedSamples, SummedContact
from .step_indentation import next_indentation
from .undecided_runs import Runs


class MarchState(NamedTuple):
    """State of a march at the end of a step."""

    step: int
    recorded: int  # number of recorded steps so far
    d: float  # indentation
    guess: float  # predicted d after the next step
    advance: float  # D


class ActiveSet(NamedTuple):
    """Lists of the samples that a march steps, and sums over the others that touch."""

    runs: Runs
    listed: ListedSamples
    sums: SummedContact
    entries: Entries
    landings: Landings


class Recorder(NamedTuple):
    """Numbers of the recorded steps, and arrays that a march fills at these."""

    kept_steps: np.ndarray  # increasing step numbers (first step = 1)
    mu: np.ndarray  # friction averaged over the step, in h/dx
    indentation: np.ndarray  # d at the end of the step, in h


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

    contacts/pressure.py has the same sums at an instant.
    landing_depth, landing_moment : rows 0 and 1 of landing_sums. advance : D of this step.
    """
    depth, moment, _ = pressure_sums(listed.c, None, listed.weight, d)
    excess = advance - sums.level
    moment += landing_moment + (sums.moment + excess * sums.weight)
    return moment / (depth + landing_depth + (sums.depth + excess * sums.samples))
