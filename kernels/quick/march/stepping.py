"""The steps of the active-set march, of the samples that are listed, as long as the bounds hold."""

from typing import NamedTuple

from ...compile.jit import refcount_free_kernel
from ..contacts.pressed import weighed_side_by_side
from .bounds import NOTHING, are_within, including
from .crossings import arrive, depart
from .landings import beside
from .load_balance import next_indentation


class Stand(NamedTuple):
    """Where a march stands, at the end of a step."""

    step: int
    kept: int  # how many steps have been kept
    d: float  # indentation
    guess: float  # of the next one
    advanced: float  # D


@refcount_free_kernel
def march_on(march, control, where, bounds, stand, last, into):
    """March on to step ``last`` as long as the bounds hold; return (inside, stand, seen, work).

    where : runs, lists, sums, arrivals, and landings. into : kept_steps, and mu and indentation at
    them, which are filled in. seen : bounds of d and D on the way. work : element updates.
    """
    law, (_, lists, sums, arrivals, landings) = march.law, where
    kept_steps, mu, indentation = into
    _, kept, d, guess, advanced = stand
    seen, work = NOTHING, 0
    for step in range(stand.step + 1, last + 1):
        move_listed(law, lists, d)
        arrive(law, lists, arrivals, d)
        old = d
        more = beside(landings, step, old, 0)
        d, advanced, passes = next_indentation(control, law, lists, sums, more, old, guess)
        work += passes * lists.c.size + arrivals[1].at.size
        if not are_within(bounds, d, advanced):
            return False, Stand(step, kept, d, guess, advanced), seen, work
        guess = d + (d - old)
        landings.past[step] = d
        depart(lists, arrivals[1], d)
        if step == kept_steps[kept]:
            more = beside(landings, step, d, 0)[1], beside(landings, step, d, 1)[1]
            mu[kept] = average(lists, sums, more, d, advanced)
            indentation[kept] = d
            kept += 1
        seen = including(seen, d, advanced)
    return True, Stand(last, kept, d, guess, advanced), seen, work


@refcount_free_kernel
def move_listed(law, lists, d):
    """Move every element to the next sample, of those that stay in their run (motion/slide.py)."""
    c, z = lists.c, lists.z
    for i in range(c.size - 1):
        c[i] = z[i] - law.decay * (z[i + 1] - max(c[i + 1], d))


@refcount_free_kernel
def average(lists, sums, more, d, advanced):
    """Return mu averaged over a step: eq. 5, as step_average of model/friction.py has it.

    The sums over samples are those of friction.py too, and of contacts/pressure.py at an instant.
    more : overlap and moment of what touches beside both. advanced : D of the samples in sums.
    """
    depth, moment, _ = weighed_side_by_side(lists.c, None, lists.weight, d)
    over = advanced - sums.level
    moment += more[1] + (sums.moment + over * sums.weight)
    return moment / (depth + more[0] + (sums.depth + over * sums.samples))
