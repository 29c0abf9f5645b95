"""The active-set march: as kernels/model/march.py, of the listed samples alone."""

import numpy as np

from ...compile.jit import kernel
from ...rheology.law import State
from ..contacts.pressed import moments
from .balance import foresee, settle
from .bounds import NOTHING, closer_bounds, first_bounds, holds, including, widened
from .flights import Steady, arrivals_of, arrive, depart
from .landings import landing, no_landings
from .lists import lists_of
from .narrow import elements_aloft, narrowed
from .runs import classes_of
from .setting import advance

MARGINS = (0.05, 0.3, 2.0, 2.0)  # of the spread of d and D, one after the other
# What shorter lists leave to d and to D, of their spread at first; in the end none are made.
ROOM = (0.0, 0.5, 1.0, 100.0)
ROOM_OF_RATE = (0.0, 0.1, 0.2, 100.0)
LEAST_SAVED = 0.25  # of the spread of D
FIRST_DUE = 6  # step after which lists may be shortened; then after half as many again


@kernel
def active_march(setting, control, kept_steps, margins=MARGINS):
    """March from steady sliding at v1; return (mu, indentation, settled, work, inside).

    setting : line and steady states (setting.py). control : ConstantForce.
    kept_steps : increasing step numbers (first step = 1) at which mu and d are kept.
    mu, indentation : as of kernels/model/march.py. settled : mu averaged over a step of the steady
    state at v2. work : element updates. inside : whether bounds were found that d kept to.
    """
    law, start = setting.law, setting.start
    mu, indentation = np.empty(kept_steps.size), np.empty(kept_steps.size)
    guess = foresee(control, setting)
    bounds = first_bounds(setting, guess, margins[0])
    spread = bounds.high - bounds.low, bounds.most - bounds.least
    settled, work, inside, steady = np.nan, 0, False, Steady(start.decay.once, start.d)
    for attempt in range(1, len(margins) + 1):
        runs, met, sums = classes_of(setting, bounds)
        lists = lists_of(runs, met)
        depth, moment, _ = moments(met.after, None, met.weight, setting.end.d)
        settled = (sums.moment + moment) / (
            sums.depth + depth
        )  # averaged over a step (friction.py)
        arrivals = arrivals_of(law, lists, runs, steady, setting.z, kept_steps[-1])
        inside, d, push, used = follow(
            setting,
            control,
            (runs, lists, sums, arrivals),
            bounds,
            guess,
            kept_steps,
            mu,
            indentation,
            (1.0, ROOM[attempt - 1] * spread[0], ROOM_OF_RATE[attempt - 1] * spread[1]),
        )
        work += used + setting.z.size
        if inside or attempt == len(margins) or not np.isfinite(d):
            break
        bounds = widened(law, bounds, d, push, margins[attempt])
    return mu, indentation, settled, work, inside


@kernel
def follow(setting, control, where, bounds, guess, kept_steps, mu, indentation, narrowing):
    """March as long as the bounds hold; return (inside, d, push, work).

    where : runs, lists, sums and arrivals. mu, indentation : filled in. narrowing : (worth,
    room for d, room for D). Shorter lists are made where what they save, times worth, exceeds what
    it costs to make them; they leave so much room to d and D beyond what was seen of these.
    """
    law, d, last = setting.law, setting.start.d, kept_steps[-1]
    worth, room = narrowing[0], narrowing[1:]
    runs, lists, sums, arrivals = where
    landings, past, push = no_landings(setting.end.d, last), np.empty(last + 1), np.nan
    past[0] = d
    work = kept = 0
    due, seen = FIRST_DUE, NOTHING
    w = np.empty(setting.z.size)
    for step in range(1, last + 1):
        shift(law, lists, d)
        arrive(law, lists, arrivals, d)
        old = d
        others = landings.tally[0], landing(landings, past, step, old, 0)
        d, push, passes = settle(control, law, lists, sums, others, old, guess)
        work += passes * lists.c.size + arrivals[1].at.size
        real = advance(law, d, old)
        if not holds(bounds, d, real):
            return False, d, real, work
        guess, past[step] = d + (d - old), d
        depart(lists, arrivals[1], d)
        if step == kept_steps[kept]:
            others = landing(landings, past, step, d, 0), landing(landings, past, step, d, 1)
            mu[kept] = average(lists, sums, others, d, push)
            indentation[kept] = d
            kept += 1
        seen = including(seen, d, real)
        left = last - step
        if step == due and left > 0:
            closer = closer_bounds(law, bounds, seen, setting.end.d, room)
            if worth * gain(bounds, closer, lists, arrivals[1], left) > 1.0:
                elements_aloft(law, lists, runs, arrivals[1], d, w, left)
                everything = runs, lists, sums, arrivals, landings
                runs, lists, sums, landings = narrowed(
                    law, setting.z, closer, everything, past[: step + 1], w, left
                )
                arrivals = arrivals_of(law, lists, runs, State(w, d), setting.z, left)
                bounds = closer
                work += lists.c.size + arrivals[1].values.size
            due, seen = due + due // 2, NOTHING
    return True, d, push, work


@kernel
def shift(law, lists, d):
    """Move every element to the next sample, of those that stay in their run (motion/slide.py)."""
    c, z = lists.c, lists.z
    for i in range(c.size - 1):
        c[i] = z[i] - law.decay * (z[i + 1] - max(c[i + 1], d))


@kernel
def average(lists, sums, others, d, push):
    """Return mu averaged over a step: eq. 5, as step_average of model/friction.py has it.

    The sums over samples are those of friction.py too, and of contacts/pressure.py at an instant.
    others : overlap and moment of the landings. push : D of the samples in sums.
    """
    depth, moment, _ = moments(lists.c, None, lists.weight, d)
    more = push - sums.level
    moment += others[1] + (sums.moment + more * sums.weight)
    return moment / (depth + others[0] + (sums.depth + more * sums.samples))


@kernel
def gain(bounds, closer, lists, flights, steps):
    """Return what shorter lists save over what it costs to make them, by numbers alone."""
    saved = 1.0 - (closer.most - closer.least) / (bounds.most - bounds.least)
    each = 2.0 * lists.c.size + 16.0 * flights.at.size
    cost = 30.0 * flights.values.size + 100.0 * lists.c.size
    return steps * each * saved / cost if saved > LEAST_SAVED and cost > 0.0 else 0.0
