"""What a wanted accuracy asks of one problem: steps per spacing, horizon, realizations.

Elements are tied to steps in these kernels: an element sits at every sample, so more steps per
spacing are more elements per spacing too.
"""

from typing import NamedTuple

import numpy as np

from workflow.errors import UserError
from workflow.plan.cost import touchable_share
from workflow.plan.error_laws import LAWS
from workflow.plan.problems import Numbers, viscous_pressure
from workflow.plan.resolution import (
    MAX_SAMPLES_PER_LINE,
    check_resolution,
    horizon_steps,
    least_steps,
)
from workflow.simulate import Problem
from workflow.study import MOST_BLOCKS, Numerics, Scene, Study, judged

JACKKNIFE_GROUPS = 32  # of the jackknife; every number of blocks is a multiple of it
FIRST_SHARE = 0.3  # of the predicted need: what is measured then says how many more
TRIED = 3  # steps, each twice the one before, that are fine enough; finer ones never pay
STATES = 28.0  # updates of the march that drawing and both steady states of a sample are worth


class Goal(NamedTuple):
    """How a problem, or each of many together, is to reach the accuracy."""

    steps: Numbers  # per spacing
    bias: dict[str, Numbers]  # bound of the relative discretisation error of each estimate judged
    realizations: Numbers  # predicted need

    def each(self, number: int) -> "list[Goal]":
        """Return the goals of so many problems that this one is of together."""
        names = list(self.bias)
        columns = (self.steps, self.realizations, *self.bias.values())
        rows = zip(*(np.broadcast_to(values, number).tolist() for values in columns), strict=True)
        return [Goal(m, dict(zip(names, bias, strict=True)), need) for m, need, *bias in rows]


def goal_of(problem: Problem, scene: Scene, numerics: Numerics) -> Goal:
    """Return the cheapest way to the accuracy, by the laws of error_laws.py and cost.py.

    Discretisation may take up to half of the accuracy; where no line that fits a worker is that
    fine, the finest that does. A number of steps given by the user stands, and its error is not
    counted: the accuracy is then that of the discretisation chosen.
    """
    names = judged(scene.quantities)
    wanted = numerics.accuracy or 0.0
    scatter = {name: LAWS[name].scatter(problem) for name in names}
    if numerics.steps_per_spacing is not None:
        check_resolution(problem, numerics.steps_per_spacing, numerics)
        bias = dict.fromkeys(names, 0.0)
        return Goal(numerics.steps_per_spacing, bias, _need(wanted, bias, scatter))
    least = np.broadcast_to(least_steps(problem, scene), np.shape(problem.load))
    check_resolution(problem, least, numerics)
    best, tried = _coarsest(least, names), np.zeros_like(least)
    lowest, steps = np.full(least.shape, np.inf), least
    while (open_ones := (steps * problem.elements <= MAX_SAMPLES_PER_LINE) & (tried < TRIED)).any():
        bias = {name: LAWS[name].error(problem, steps) for name in names}
        goal = Goal(steps, bias, _need(wanted, bias, scatter))
        fine = np.max([*bias.values()], axis=0) <= 0.5 * wanted
        lines = np.maximum(goal.realizations, JACKKNIFE_GROUPS)
        cost = np.where(fine, lines * _updates(problem, scene, numerics, steps), np.inf)
        best = _where(open_ones & ((cost < lowest) | (tried == 0)), goal, best)
        lowest, tried = np.where(open_ones, np.minimum(cost, lowest), lowest), tried + fine
        steps = 2 * steps
    return best


def _coarsest(least: Numbers, names: tuple[str, ...]) -> Goal:
    """Return where the search begins, to be replaced by the first steps that are tried."""
    return Goal(least, dict.fromkeys(names, np.inf), np.inf)


def _where(chosen: np.ndarray, one: Goal, other: Goal) -> Goal:
    """Return one goal for the problems that are chosen, the other for the rest."""
    bias = {name: np.where(chosen, one.bias[name], other.bias[name]) for name in one.bias}
    realizations = np.where(chosen, one.realizations, other.realizations)
    return Goal(np.where(chosen, one.steps, other.steps), bias, realizations)


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


def most_blocks(study: Study, most: int) -> int:
    """Return the cap on the blocks of a point, a multiple of JACKKNIFE_GROUPS."""
    blocks = most // (JACKKNIFE_GROUPS * study.realizations_per_block) * JACKKNIFE_GROUPS
    if blocks > MOST_BLOCKS:
        raise UserError(
            f"numerics.max_realizations = {most}: up to {blocks} blocks of a problem, more than "
            f"{MOST_BLOCKS}; set study.realizations_per_block to {-(-most // MOST_BLOCKS)} or more"
        )
    if not blocks:
        raise UserError(
            f"numerics.max_realizations = {most}: must be at least {JACKKNIFE_GROUPS} blocks of "
            f"study.realizations_per_block = {study.realizations_per_block}"
        )
    return blocks


def whole_blocks(study: Study, realizations: Numbers, most: int) -> Numbers:
    """Return the number of blocks for at least so many realizations, within the cap."""
    layers = np.ceil(realizations / (JACKKNIFE_GROUPS * study.realizations_per_block) - 1e-9)
    blocks = np.minimum(JACKKNIFE_GROUPS * np.maximum(layers, 1), most_blocks(study, most))
    return blocks.astype(np.int64)
