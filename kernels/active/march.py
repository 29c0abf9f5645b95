"""The active-set march: as kernels/march.py, of the listed samples alone."""

import numpy as np

from kernels.active.balance import amend, note, settle
from kernels.active.bounds import first_bounds, first_indentation, holds, widened
from kernels.active.flights import arrivals_of, arrive, depart
from kernels.active.lists import lists_of, sums_of, weighed
from kernels.active.runs import classes_of
from kernels.active.setting import advance
from kernels.jit import kernel

MARGINS = (0.05, 0.3, 2.0)  # of the spread of d and D, one after the other


@kernel
def active_march(setting, control, kept_steps, margins=MARGINS):
    """March from steady sliding at v1; return (mu, indentation, settled, work, inside).

    setting : line and steady states (setting.py). control : ConstantForce or PrintedForce.
    kept_steps : increasing step numbers (first step = 1) at which mu and d are kept.
    mu, indentation : as of kernels/march.py. settled : mu averaged over a step of the steady
    state at v2. work : element updates. inside : whether bounds were found that d kept to.
    """
    law, start = setting.law, setting.start
    mu, indentation = np.empty((2, kept_steps.size))
    guess = first_indentation(setting, control.load)
    bounds = first_bounds(setting, guess, margins[0])
    settled, work, inside = np.nan, 0, False
    for attempt in range(1, len(margins) + 1):
        runs, stretches = classes_of(setting, bounds)
        lists = lists_of(setting, runs)
        sums = sums_of(setting, stretches)
        settled = steady_average(setting, runs, lists, sums)
        arrivals = arrivals_of(law, lists, runs, start, setting.z, kept_steps[-1])
        where = lists, sums, arrivals
        inside, d, push, used = follow(
            law, control, where, bounds, start.d, guess, kept_steps, mu, indentation
        )
        work += used + setting.z.size
        if inside or attempt == len(margins) or not np.isfinite(d):
            break
        bounds = widened(law, bounds, d, push, margins[attempt])
    return mu, indentation, settled, work, inside


@kernel
def steady_average(setting, runs, lists, sums):
    """Return mu averaged over a step of steady sliding at v2 (friction.py)."""
    c, i = np.empty(lists.c.size), 0
    for r in range(runs.top.size):
        for j in range(runs.bottom[r], runs.top[r] + 1):
            c[i] = setting.z[j] - setting.end.w[j]
            i += 1
    depth, moment = weighed(c, lists.weight, setting.end.d)
    return (sums.moment + moment) / (sums.depth + depth)


@kernel
def follow(law, control, where, bounds, d, guess, kept_steps, mu, indentation):
    """March as long as the bounds hold; return (inside, d, push, work)."""
    lists, sums, arrivals = where
    neighbours, flights = arrivals
    c, z = lists.c, lists.z
    push = np.nan
    work = kept = 0
    for step in range(1, kept_steps[-1] + 1):
        noted = note(control, lists, arrivals, d)
        for i in range(c.size - 1):
            c[i] = z[i] - law.decay * (z[i + 1] - max(c[i + 1], d))
        arrive(law, lists, neighbours, flights, d)
        old = d
        d, push, passes = settle(control, law, lists, arrivals, noted, sums, old, guess)
        work += passes * c.size + flights.at.size
        if not holds(bounds, d, advance(law, d, old)):
            return False, d, advance(law, d, old), work
        amend(control, noted, flights, d)
        guess = d + (d - old)
        depart(lists, flights, d)
        if step == kept_steps[kept]:
            depth, moment = weighed(c, lists.weight, d)
            more = push - sums.level
            moment += sums.moment + more * sums.weight
            mu[kept] = moment / (depth + sums.depth + more * sums.samples)
            indentation[kept] = d
            kept += 1
    return True, d, push, work
