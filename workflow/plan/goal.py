"""Settings that reach an accuracy: steps per spacing, horizon and realizations of a problem.

The kernels have an element at every sample, so that more steps per spacing also mean more elements
per spacing.
"""

from typing import NamedTuple

import numpy as np

from ...kernels import KELVIN, QUARTET
from ...kernels.model.limits import SPEED_LIMITS
from ...kernels.quick.contacts.between_samples import MIN_SMOOTH_STEPS
from ...kernels.rheology.spectrum import min_step
from ..ground import UserError
from ..simulate import Problem
from ..study import HALF_SPACE, MAX_BLOCKS, Numerics, Scene, Study, accuracy_estimates
from .error_laws import (
    allowed_share,
    contact_width,
    rate_error,
    relaxing_share,
    touchable_share,
    window_rate,
)
from .half_space import LEAST_OF_MAPS, MAX_MAP_SAMPLES, laws_of, map_fits_worker, steps_for
from .problems import Numbers, expected_rate, viscous_pressure

JACKKNIFE_GROUPS = 32  # at most; with fewer blocks, each block is a group
MIN_BLOCKS, MIN_RATE_BLOCKS = 2, 8  # minimum per point, without and with b
FIRST_SHARE = 0.3  # of the predicted realizations, run first; their errors determine the rest
COMPARED_STEPS = 3  # the smallest m with a small enough error, and its doublings
STATES_UPDATES = 28.0  # cost of drawing and steady states per sample, in updates of a march


class Goal(NamedTuple):
    """Settings with which a problem, or each problem of a stack, reaches the accuracy."""

    steps: Numbers  # per spacing
    bias: dict[str, Numbers]  # bound of the relative discretisation error, by estimate
    scatter: dict[str, Numbers]  # predicted standard error for one line, by estimate
    realizations: Numbers  # predicted to be needed

    def split(self, number: int) -> "list[Goal]":
        """Return the goals of the single problems of a stack."""
        names = list(self.bias)
        columns = (self.steps, self.realizations, *self.bias.values(), *self.scatter.values())
        steps, need, *rest = (np.broadcast_to(values, number).tolist() for values in columns)
        bias, scatter = (
            [dict(zip(names, values, strict=True)) for values in zip(*part, strict=True)]
            for part in (rest[: len(names)], rest[len(names) :])
        )
        return list(map(Goal, steps, bias, scatter, need))


def goal_of(problem: Problem, scene: Scene, numerics: Numerics) -> Goal:
    """Return the cheapest settings for the accuracy, by the laws of error_laws.py or half_space.py.

    Discretisation may use up to half of the accuracy. If no line that fits into a worker is fine
    enough, the finest one that fits is used. A number of steps given by the user is kept, and its
    discretisation error does not count. b does not count if almost nothing is expected to relax.
    """
    names = accuracy_estimates(scene.quantities)
    wanted, laws = numerics.accuracy or 0.0, laws_of(problem)
    counted = {name: np.ones(np.shape(problem.load)) for name in names}
    if "relaxation_rate" in counted:
        counted["relaxation_rate"] = 1.0 * (relaxing_share(problem) >= numerics.negligible)
    scatter = {name: counted[name] * laws[name].scatter(problem) for name in names}
    if numerics.steps_per_spacing is not None:
        check_resolution(problem, numerics.steps_per_spacing, numerics)
        bias = dict.fromkeys(names, 0.0)
        return Goal(numerics.steps_per_spacing, bias, scatter, _need(wanted, bias, scatter))
    on_map = problem.surface.body == HALF_SPACE
    first = LEAST_OF_MAPS if on_map else least_steps(problem, scene)
    least = np.broadcast_to(first, np.shape(problem.load))
    check_resolution(problem, least, numerics)
    # The first pass of the loop replaces these settings.
    best, tried = Goal(least, dict.fromkeys(names, np.inf), scatter, np.inf), np.zeros_like(least)
    lowest, steps = np.full(least.shape, np.inf), least
    share = touchable_share(problem.hurst, problem.load, viscous_pressure(problem))
    fits = map_fits_worker if on_map else line_fits_worker
    while (unfinished := fits(problem, steps) & (tried < COMPARED_STEPS)).any():
        bias = {name: laws[name].error(problem, steps) for name in names}
        goal = Goal(steps, bias, scatter, _need(wanted, bias, scatter))
        fine = np.max([counted[name] * bias[name] for name in names], axis=0) <= 0.5 * wanted
        lines = np.maximum(goal.realizations, QUARTET * least_blocks(names))
        marched = 0.0
        if "relaxation" in scene.quantities:
            marched = share * horizon_steps(problem, numerics, steps)
        updates = steps * (STATES_UPDATES + marched)  # of elements, per spacing
        if on_map:
            updates = steps**3  # of a map: m^2 samples times m steps, per spacing
        cost = np.where(fine, lines * updates, np.inf)
        better = unfinished & ((cost < lowest) | (tried == 0))
        best = Goal(
            np.where(better, steps, best.steps),
            {name: np.where(better, bias[name], best.bias[name]) for name in names},
            scatter,
            np.where(better, goal.realizations, best.realizations),
        )
        lowest, tried = np.where(unfinished, np.minimum(cost, lowest), lowest), tried + fine
        steps = 2 * steps
    return best


def _need(wanted: float, bias: dict[str, Numbers], scatter: dict[str, Numbers]) -> Numbers:
    """Return the realizations that reduce every standard error to ``allowed``."""
    return np.max([(scatter[name] / allowed(wanted, bias[name])) ** 2 for name in bias], axis=0)


def allowed(wanted: float, bias: Numbers) -> Numbers:
    """Return the relative standard error allowed: wanted - bias, at least 0.5 wanted."""
    return np.maximum(wanted - bias, 0.5 * wanted)


def least_blocks(names: tuple[str, ...]) -> int:
    """Return the smallest number of blocks of a point for these estimates."""
    return MIN_RATE_BLOCKS if "relaxation_rate" in names else MIN_BLOCKS


def most_blocks(study: Study, most: int) -> int:
    """Return the number of blocks in ``most`` realizations. Raises UserError if out of range."""
    blocks = most // study.realizations_per_block
    if blocks > MAX_BLOCKS:
        raise UserError(
            f"numerics.max_realizations = {most}: up to {blocks} blocks of a problem, more than "
            f"{MAX_BLOCKS}; set study.realizations_per_block to {-(-most // MAX_BLOCKS)} or more"
        )
    least = least_blocks(accuracy_estimates(study.scene.quantities))
    if blocks < least:
        raise UserError(
            f"numerics.max_realizations = {most}: must be at least {least} blocks of "
            f"study.realizations_per_block = {study.realizations_per_block}"
        )
    return blocks


def whole_blocks(study: Study, realizations: Numbers, most: int) -> Numbers:
    """Return the number of blocks for at least ``realizations``, within the limits."""
    blocks = np.ceil(realizations / study.realizations_per_block - 1e-9)
    least = least_blocks(accuracy_estimates(study.scene.quantities))
    return np.clip(blocks, least, most_blocks(study, most)).astype(np.int64)


MAX_SAMPLES_PER_LINE = 6_000_000  # keeps a worker below 1 GiB
MIN_STEPS = 8  # of a march
BIAS = 0.02  # relative discretisation error that "auto" aims for
GENERAL_STEPS = 8  # m for elements with internal variables, or for a programme
RENEWAL = 0.04  # distance that renews all contacts, as a share of the line
FIRST_ORDER = 8  # factor on the steps for a first-order scheme
MOST_FOR_CONTACTS = 64  # largest m chosen to resolve contacts


def rung(need: Numbers) -> Numbers:
    """Return the smallest of 1, 2, 3, 4, 6, 8, 12 ... that is not below ``need``."""
    below = 1 << (np.frexp(np.maximum(need, 1.0))[1] - 1).astype(np.int64)
    between, least = 3 * below // 2, need * (1.0 - 1e-9)
    return np.where(below >= least, below, np.where(between >= least, between, 2 * below))


def least_steps(problem: Problem, scene: Scene) -> Numbers:
    """Return the smallest m that resolves the relaxation in time; 1 if none is requested."""
    if "relaxation" not in scene.quantities:
        return 1
    slowest = np.maximum(problem.speed * np.minimum(1.0, problem.ratio), SPEED_LIMITS[0])
    return rung(expected_rate(problem) / slowest / allowed_share(problem))


def steps_per_spacing(problem: Problem, scene: Scene, numerics: Numerics) -> Numbers:
    """Return m: the given number, or for "auto" the smallest with a bias of at most BIAS.

    For steady friction and jumps it is 4 (quick/contacts/between_samples.py). A relaxation needs
    small steps in time and in space (error_laws.py). To resolve contacts, m grows up to
    MOST_FOR_CONTACTS if the line fits into a worker; the result marks points that remain coarse.
    Where these laws hold, first-order schemes take FIRST_ORDER times m.
    """
    steps: Numbers = numerics.steps_per_spacing
    if steps is None and problem.surface.body == HALF_SPACE:
        steps = steps_for(problem, scene.quantities, BIAS)
    elif steps is None and problem.surface.given:
        steps = MIN_SMOOTH_STEPS  # no law covers measured spectra
    elif steps is None and (problem.programme or problem.spectrum != KELVIN):
        steps = GENERAL_STEPS
    elif steps is None:
        steps = np.maximum(MIN_SMOOTH_STEPS, least_steps(problem, scene))
        if "relaxation" in scene.quantities:
            most = np.minimum(MOST_FOR_CONTACTS, MAX_SAMPLES_PER_LINE // problem.elements)
            width, rate = contact_width(problem), expected_rate(problem)
            coarse = np.array(True)
            while coarse.any():  # until the law of b is met or m reaches its limit
                finer = rung(steps + 1)
                coarse = rate_error(problem, steps, width * steps, rate) > BIAS
                coarse = coarse & (finer <= most)
                steps = np.where(coarse, finer, steps)
        if numerics.scheme == "implicit-euler":
            steps = steps * FIRST_ORDER
    check_resolution(problem, steps, numerics)
    return steps


def line_fits_worker(problem: Problem, steps: Numbers) -> Numbers:
    """Return whether a line with these steps per spacing fits into a worker."""
    return problem.elements * steps <= MAX_SAMPLES_PER_LINE


def fits_worker(problem: Problem, steps: int) -> bool:
    """Return whether a line with this m fits into a worker, without steps lost in rounding."""
    fastest = max(abs(problem.speed), abs(problem.speed * problem.ratio))
    lost = steps * fastest * min_step(problem.spectrum) > 1.0
    return line_fits_worker(problem, steps) and not lost


def check_resolution(problem: Problem, steps: Numbers, numerics: Numerics) -> None:
    """Raise UserError for a line too long for a worker, and for speeds lost in rounding.

    The kernels refuse these speeds too (kernels/velocity_step/cases.py).
    """
    elements, _, speed, ratio, steps = np.broadcast_arrays(*problem[1:5], steps)
    if problem.surface.body == HALF_SPACE:
        _check_map(problem, steps, numerics)
    long = elements * steps > MAX_SAMPLES_PER_LINE
    if long.any():
        raise UserError(
            f"numerics.steps_per_spacing = {numerics.steps_per_spacing or 'auto'}: "
            f"{elements[long][0]} elements at v tau/dx = {speed[long][0]:.3g} need "
            f"{steps[long][0]} steps per spacing, more than {MAX_SAMPLES_PER_LINE} samples per "
            f"line; {_shorter(problem, int(elements[long][0]))}"
        )
    speeds = np.sort(np.abs([speed, speed * ratio]), axis=0)
    most = np.minimum(SPEED_LIMITS[1], 1.0 / min_step(problem.spectrum) / steps)
    outside = ~((speeds[0] >= SPEED_LIMITS[0]) & (speeds[1] <= most))
    outside &= speeds[1] != 0.0  # zero in a programme of holds alone
    if outside.any():
        raise UserError(
            f"grid.velocity: v tau/dx runs from {speeds[0][outside][0]:.3g} to "
            f"{speeds[1][outside][0]:.3g}, but must lie between {SPEED_LIMITS[0]:g} and "
            f"{most[outside][0]:.3g}, "
            "where rounding shows"
        )


def _shorter(problem: Problem, elements: int) -> str:
    """Return advice on how to reduce the samples of a line."""
    if not problem.surface.measured:
        return "set a smaller number, a higher velocity or a larger spacing"
    most = MAX_SAMPLES_PER_LINE // elements
    fewer = f"set numerics.steps_per_spacing = {most} or less, " if most else ""
    return (
        f'{fewer}surface.periodic = "taper", which has half as many elements as "mirror", or thin '
        "the measured line"
    )


def _check_map(problem: Problem, steps: np.ndarray, numerics: Numerics) -> None:
    """Raise UserError for a map too large for a worker, and name an m that fits."""
    if np.any(problem.samples(steps) > MAX_MAP_SAMPLES):
        side, most = int(np.max(problem.elements)), int(MAX_MAP_SAMPLES**0.5)
        smaller = "a larger grid.spacing or a shorter surface.length"
        if problem.surface.measured:
            smaller = "a map that is cropped, or thinned"
        fits = f"set it to {most // side}, or " if side <= most else ""
        raise UserError(
            f"numerics.steps_per_spacing = {numerics.steps_per_spacing or 'auto'}: on a half-space "
            f"of {side} x {side} elements it needs a map of more than {most} x {most} samples; "
            f"{fits}take {smaller}"
        )


def horizon_steps(problem: Problem, numerics: Numerics, steps: Numbers) -> Numbers:
    """Return the number of steps to march: for the time ``horizon``/window_rate, at least 8.

    With internal variables the march also covers at least ``horizon`` times the distance that
    renews all contacts.
    """
    time = numerics.horizon / window_rate(problem)
    need = time * steps * abs(problem.speed) * abs(problem.ratio)
    if problem.spectrum != KELVIN:
        need = np.maximum(need, numerics.horizon * RENEWAL * problem.elements * steps)
    return np.maximum(MIN_STEPS, np.ceil(need)).astype(np.int64)
