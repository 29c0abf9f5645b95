"""What the result says of every task beside its estimates, and of all tasks together."""

import numpy as np

from ..plan import Plan, Variant, line_slope, speed_ratio
from ..study import judged
from .blocks import Estimates
from .exponents import fit_exponents
from .resolution import resolution


def completed(
    plan: Plan, variant: Variant, estimates: Estimates, sound: np.ndarray, counts: np.ndarray
) -> Estimates:
    """Return name -> array over all tasks of a variant.

    estimates : of the tasks at the rows ``sound``; the others are marked, NaN or -1. counts :
    realizations of each task, shape (tasks,).
    """
    tasks = variant.tasks
    names = judged(plan.study.scene.quantities)
    done = [tasks[row] for row in sound]
    estimates = estimates | resolution(done, estimates, names, variant.numerics)
    spread = {name: _spread(v, sound, len(tasks)) for name, v in estimates.items()}
    slopes = [line_slope(task.problem, variant.lines.normalisation) for task in tasks]
    return spread | {
        "realizations": counts,
        "rms_slope": np.array(slopes),
        "speed_ratio": np.array([speed_ratio(task.problem) for task in tasks]),
        "steps_per_spacing": np.array([t.steps_per_spacing for t in tasks], np.int32),
    }


def exponents_of(plan: Plan, variant: Variant, estimates: Estimates) -> Estimates:
    """Take the replicates of b out of the estimates, return the exponents of eq. 13 from them."""
    rates = estimates.pop("rate_replicates", None)
    if rates is None:
        return {}
    hurst = np.array([task.problem.hurst for task in variant.tasks])
    return fit_exponents(plan.study.grid["hurst"], hurst, estimates, rates)


def _spread(values: np.ndarray, sound: np.ndarray, count: int) -> np.ndarray:
    """Return estimates of the sound tasks as an array over all tasks, NaN or -1 elsewhere."""
    if sound.size == count:
        return values
    nothing = np.nan if values.dtype.kind == "f" else -1
    spread = np.full((count, *values.shape[1:]), nothing, values.dtype)
    spread[sound] = values
    return spread
