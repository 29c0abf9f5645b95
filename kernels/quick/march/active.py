"""The active-set march: as kernels/model/march.py, of the listed samples alone."""

import numpy as np

from ...compile.jit import kernel
from ..contacts.pressed import weighed_side_by_side
from .bounds import first_bounds, widened
from .crossings import Steady, arrivals_of
from .lists import lists_of
from .load_balance import foresee
from .narrow import march_shortening
from .runs import classes_of
from .stepping import Stand

MARGINS = (0.05, 0.3, 2.0, 2.0)  # of the spread of d and D, one after the other


@kernel
def active_march(march, control, kept_steps, margins=MARGINS):
    """March from steady sliding at v1; return (mu, indentation, settled, work, inside).

    march : line and steady states (given.py). control : ConstantForce.
    kept_steps : increasing step numbers (first step = 1) at which mu and d are kept.
    mu, indentation : as of kernels/model/march.py. settled : mu averaged over a step of the steady
    state at v2. work : element updates. inside : whether bounds were found that d kept to.
    """
    law, start = march.law, march.start
    into = kept_steps, np.empty(kept_steps.size), np.empty(kept_steps.size)
    guess = foresee(control, march)
    bounds = first_bounds(march, guess, margins[0])
    settled, work, inside, steady = np.nan, 0, False, Steady(start.decay.once, start.d)
    stand, last = Stand(0, 0, start.d, guess, np.nan), kept_steps[-1]
    for attempt in range(1, len(margins) + 1):
        runs, met, sums = classes_of(march, bounds)
        lists = lists_of(runs, met)
        depth, moment, _ = weighed_side_by_side(met.after, None, met.weight, march.end.d)
        # Averaged over a step (model/friction.py).
        settled = (sums.moment + moment) / (sums.depth + depth)
        arrivals = arrivals_of(law, lists, runs, steady, march.z, last)
        where = runs, lists, sums, arrivals
        inside, now, _, used = march_shortening(
            march, control, where, bounds, stand, last, into, 1.0
        )
        work += used + march.z.size
        if inside or attempt == len(margins) or not np.isfinite(now.d):
            break
        bounds = widened(law, bounds, now.d, now.advanced, margins[attempt])
    return into[1], into[2], settled, work, inside
