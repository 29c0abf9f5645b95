"""Steps per spacing and horizon of each problem, or of many together (problems.py)."""

import numpy as np

from ...kernels import KELVIN
from ...kernels.model.limits import SPEEDS
from ...kernels.quick.contacts.refined import LEAST_STEPS
from ...kernels.rheology.spectrum import shortest_step
from ..errors import UserError
from ..simulate import Problem
from ..study import Numerics, Scene
from .error_laws import allowed_share, contact_width, rate_error, window_rate
from .problems import Numbers, expected_rate

MAX_SAMPLES_PER_LINE = 6_000_000  # keeps a worker below 1 GiB
MIN_STEPS = 8  # of a march
BIAS = 0.02  # relative discretisation error that "auto" keeps
GENERAL_STEPS = 8  # where elements have internal variables, or a programme is marched
RENEWAL = 0.04  # of the line, slid until contacts are others
FIRST_ORDER = 8  # times the steps, that a scheme of first order takes
MOST_FOR_CONTACTS = 64


def rung(need: Numbers) -> Numbers:
    """Return the least of 1, 2, 3, 4, 6, 8, 12 ... that is not below ``need``."""
    below = 1 << (np.frexp(np.maximum(need, 1.0))[1] - 1).astype(np.int64)
    between, least = 3 * below // 2, need * (1.0 - 1e-9)
    return np.where(below >= least, below, np.where(between >= least, between, 2 * below))


def least_steps(problem: Problem, scene: Scene) -> Numbers:
    """Return the least m for what is asked: a step must be short enough for the relaxation."""
    if "relaxation" not in scene.quantities:
        return 1
    slowest = np.maximum(problem.speed * np.minimum(1.0, problem.ratio), SPEEDS[0])
    return rung(expected_rate(problem) / slowest / allowed_share(problem))


def steps_per_spacing(problem: Problem, scene: Scene, numerics: Numerics) -> Numbers:
    """Return m: the given number, or for "auto" the least that keeps BIAS of all that is asked.

    Steady friction and jumps do so with 4 (quick/contacts/refined.py), a relaxation where steps
    and contacts are resolved (error_laws.py). For contacts alone m goes up to MOST_FOR_CONTACTS and
    as far as a line fits into a worker; what is coarse then is marked in the result. First order
    schemes take FIRST_ORDER times as many.
    """
    steps: Numbers = numerics.steps_per_spacing
    if steps is None and problem.surface.measured:
        steps = LEAST_STEPS  # no law tells more of lines whose spectrum is their own
    elif steps is None and (problem.programme or problem.spectrum != KELVIN):
        steps = GENERAL_STEPS
    elif steps is None:
        steps = np.maximum(LEAST_STEPS, least_steps(problem, scene))
        if "relaxation" in scene.quantities:
            steps = _for_contacts(problem, steps)
        if numerics.scheme == "implicit-euler":
            steps = steps * FIRST_ORDER
    check_resolution(problem, steps, numerics)
    return steps


def _for_contacts(problem: Problem, steps: Numbers) -> Numbers:
    """Return m, from ``steps`` on, for which the law of b keeps BIAS, as far as m may go."""
    most = np.minimum(MOST_FOR_CONTACTS, MAX_SAMPLES_PER_LINE // problem.elements)
    width, rate = contact_width(problem), expected_rate(problem)
    while True:
        finer, wide = rung(steps + 1), width * steps
        coarse = (rate_error(problem, steps, wide, rate) > BIAS) & (finer <= most)
        if not coarse.any():
            return steps
        steps = np.where(coarse, finer, steps)


def check_resolution(problem: Problem, steps: Numbers, numerics: Numerics) -> None:
    """Raise UserError where a line does not fit into a worker, or rounding would show.

    The kernels refuse the same speeds (kernels/quick/cases.py).
    """
    elements, _, speed, ratio, steps = np.broadcast_arrays(*problem[1:5], steps)
    long = elements * steps > MAX_SAMPLES_PER_LINE
    if long.any():
        raise UserError(
            f"numerics.steps_per_spacing = {numerics.steps_per_spacing or 'auto'}: "
            f"{elements[long][0]} elements at v tau/dx = {speed[long][0]:.3g} need "
            f"{steps[long][0]} steps per spacing, more than {MAX_SAMPLES_PER_LINE} samples per "
            "line; set a smaller number, a higher velocity or a larger spacing"
        )
    speeds = np.sort(np.abs([speed, speed * ratio]), axis=0)
    most = np.minimum(SPEEDS[1], 1.0 / shortest_step(problem.spectrum) / steps)
    odd = ~((speeds[0] >= SPEEDS[0]) & (speeds[1] <= most))
    if odd.any():
        raise UserError(
            f"grid.velocity: v tau/dx runs from {speeds[0][odd][0]:.3g} to "
            f"{speeds[1][odd][0]:.3g}, but must lie between {SPEEDS[0]:g} and {most[odd][0]:.3g}, "
            "where rounding shows"
        )


def horizon_steps(problem: Problem, numerics: Numerics, steps: Numbers) -> Numbers:
    """Return the number of steps to march: ``horizon`` expected relaxation times, at least 8.

    Where there are internal variables, at least ``horizon`` times the distance over which contacts
    are renewed.
    """
    time = numerics.horizon / window_rate(problem)
    need = time * steps * abs(problem.speed) * abs(problem.ratio)
    if problem.spectrum != KELVIN:
        need = np.maximum(need, numerics.horizon * RENEWAL * problem.elements * steps)
    return np.maximum(MIN_STEPS, np.ceil(need)).astype(np.int64)
