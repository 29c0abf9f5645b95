"""What a wanted accuracy asks of one problem: steps per spacing, horizon, realizations.

Elements are tied to steps in these kernels: an element sits at every sample, so more steps per
spacing are more elements per spacing too.
"""

from typing import NamedTuple

import numpy as np

from ...kernels import QUARTET
from ..errors import UserError
from ..simulate import Problem
from ..study import MOST_BLOCKS, Numerics, Scene, Study, judged
from .cost import touchable_share
from .error_laws import LAWS, relaxing_share
from .problems import Numbers, viscous_pressure
from .resolution import MAX_SAMPLES_PER_LINE, check_resolution, horizon_steps, least_steps

JACKKNIFE_GROUPS = 32  # of the jackknife at most; fewer blocks are groups of their own
LEAST_BLOCKS, LEAST_FOR_RATE = 2, 8  # of a point; with fewer, b is hardly ever significant
FIRST_SHARE = 0.3  # of the predicted need: what is measured then says how many more
TRIED = 3  # steps, each twice the one before, that are fine enough; finer ones never pay
STATES = 28.0  # updates of the march that drawing and both steady states of a sample are worth


class Goal(NamedTuple):
    """How a problem, or each of many together, is to reach the accuracy."""

    steps: Numbers  # per spacing
    bias: dict[str, Numbers]  # bound of the relative discretisation error of each estimate judged
    scatter: dict[str, Numbers]  # predicted standard error of each, of one line
    realizations: Numbers  # predicted need

    def each(self, number: int) -> "list[Goal]":
        """Return the goals of so many problems that this one is of together."""
        names = list(self.bias)
        columns = (self.steps, self.realizations, *self.bias.values(), *self.scatter.values())
        steps, need, *rest = (np.broadcast_to(values, number).tolist() for values in columns)
        bias, scatter = (
            [dict(zip(names, own, strict=True)) for own in zip(*part, strict=True)]
            for part in (rest[: len(names)], rest[len(names) :])
        )
        return list(map(Goal, steps, bias, scatter, need))


def goal_of(problem: Problem, scene: Scene, numerics: Numerics) -> Goal:
    """Return the cheapest way to the accuracy, by the laws of error_laws.py and cost.py.

    Discretisation may take up to half of the accuracy; where no line that fits a worker is that
    fine, the finest that does. A number of steps given by the user stands, and its error is not
    counted: the accuracy is then that of the discretisation chosen. Nor is b counted where next to
    nothing is expected to relax.
    """
    names = judged(scene.quantities)
    wanted = numerics.accuracy or 0.0
    counted = {name: np.ones(np.shape(problem.load)) for name in names}
    if "relaxation_rate" in counted:
        counted["relaxation_rate"] = 1.0 * (relaxing_share(problem) >= numerics.negligible)
    scatter = {name: counted[name] * LAWS[name].scatter(problem) for name in names}
    if numerics.steps_per_spacing is not None:
        check_resolution(problem, numerics.steps_per_spacing, numerics)
        bias = dict.fromkeys(names, 0.0)
        return Goal(numerics.steps_per_spacing, bias, scatter, _need(wanted, bias, scatter))
    least = np.broadcast_to(least_steps(problem, scene), np.shape(problem.load))
    check_resolution(problem, least, numerics)
    # Where the search begins, to be replaced by the first steps that are tried.
    best, tried = Goal(least, dict.fromkeys(names, np.inf), scatter, np.inf), np.zeros_like(least)
    lowest, steps = np.full(least.shape, np.inf), least
    while (open_ones := (steps * problem.elements <= MAX_SAMPLES_PER_LINE) & (tried < TRIED)).any():
        bias = {name: LAWS[name].error(problem, steps) for name in names}
        goal = Goal(steps, bias, scatter, _need(wanted, bias, scatter))
        fine = np.max([counted[name] * bias[name] for name in names], axis=0) <= 0.5 * wanted
        lines = np.maximum(goal.realizations, QUARTET * least_blocks(names))
        cost = np.where(fine, lines * _updates(problem, scene, numerics, steps), np.inf)
        best = _where(open_ones & ((cost < lowest) | (tried == 0)), goal, best)
        lowest, tried = np.where(open_ones, np.minimum(cost, lowest), lowest), tried + fine
        steps = 2 * steps
    return best


def _where(chosen: np.ndarray, one: Goal, other: Goal) -> Goal:
    """Return one goal for the problems that are chosen, the other for the rest."""
    bias = {name: np.where(chosen, one.bias[name], other.bias[name]) for name in one.bias}
    realizations = np.where(chosen, one.realizations, other.realizations)
    return one._replace(
        steps=np.where(chosen, one.steps, other.steps), bias=bias, realizations=realizations
    )


def _need(wanted: float, bias: dict[str, Numbers], scatter: dict[str, Numbers]) -> Numbers:
    """Return how many realizations bring every standard error down to what the bias leaves."""
    return np.max([(scatter[name] / allowed(wanted, bias[name])) ** 2 for name in bias], axis=0)


def allowed(wanted: float, bias: Numbers) -> Numbers:
    """Return the relative standard error that is left beside a bias, at least half of all."""
    return np.maximum(wanted - bias, 0.5 * wanted)


def _updates(problem: Problem, scene: Scene, numerics: Numerics, steps: Numbers) -> Numbers:
    """Return the cost of one realization per spacing, in element updates of the march."""
    march = 0.0
    if "relaxation" in scene.quantities:
        share = touchable_share(problem.hurst, problem.load, viscous_pressure(problem))
        march = share * horizon_steps(problem, numerics, steps)
    return steps * (STATES + march)


def least_blocks(names: tuple[str, ...]) -> int:
    """Return how many blocks a point takes at least, of which these estimates are judged."""
    return LEAST_FOR_RATE if "relaxation_rate" in names else LEAST_BLOCKS


def most_blocks(study: Study, most: int) -> int:
    """Return the cap on the blocks of a point."""
    blocks = most // study.realizations_per_block
    if blocks > MOST_BLOCKS:
        raise UserError(
            f"numerics.max_realizations = {most}: up to {blocks} blocks of a problem, more than "
            f"{MOST_BLOCKS}; set study.realizations_per_block to {-(-most // MOST_BLOCKS)} or more"
        )
    least = least_blocks(judged(study.scene.quantities))
    if blocks < least:
        raise UserError(
            f"numerics.max_realizations = {most}: must be at least {least} blocks of "
            f"study.realizations_per_block = {study.realizations_per_block}"
        )
    return blocks


def whole_blocks(study: Study, realizations: Numbers, most: int) -> Numbers:
    """Return the number of blocks for at least so many realizations, within the cap."""
    blocks = np.ceil(realizations / study.realizations_per_block - 1e-9)
    least = least_blocks(judged(study.scene.quantities))
    return np.clip(blocks, least, most_blocks(study, most)).astype(np.int64)
