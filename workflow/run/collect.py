"""Collect stored block means, reduce them on the workers, assemble the datasets."""

import time
from collections.abc import Iterator

import numpy as np
import xarray as xr
from distributed import Client

from kernels import amplitudes, rms_slope
from workflow.errors import UserError
from workflow.plan.plan import Plan, Variant
from workflow.plan.problems import speed_ratio
from workflow.reduce.attained import attained
from workflow.reduce.estimates import Blocks, Estimates, fit_exponents, reduce_blocks
from workflow.reduce.jackknife import grouped_means
from workflow.result.dataset import build_dataset
from workflow.run.flow import Watch, stream
from workflow.run.summary import Summary
from workflow.simulate.block_means import record_steps, record_times
from workflow.simulate.tasks import Task
from workflow.store.store import Store
from workflow.system.progress import Reporter

TASKS_PER_REDUCTION = 32
SECONDS_PER_FIT = 4e-4


class Collector:
    """Reduces stored block means on the workers."""

    def __init__(
        self, client: Client, store: Store, plan: Plan, summary: Summary, watch: Watch
    ) -> None:
        """``watch`` : tells when to give up."""
        self.client, self.store, self.plan = client, store, plan
        self.summary, self.watch = summary, watch

    def datasets(self, blocks: dict[str, int]) -> dict[str, xr.Dataset]:
        """Return label -> dataset of every variant, from ``blocks`` of each task (by key).

        Tasks that failed are marked: estimates NaN, flags -1, realizations 0. Empty if
        ``watch()`` turned true meanwhile.
        """
        datasets = {}
        for variant in self.plan.variants:
            estimates = self._variant(variant, blocks)
            if not estimates:
                return {}
            exponents = _exponents(self.plan, variant, estimates)
            datasets[variant.label] = build_dataset(self.plan, variant, estimates, exponents)
        return datasets

    def _variant(self, variant: Variant, blocks: dict[str, int]) -> Estimates:
        tasks = [task for task in variant.tasks if task.key not in self.store.failed]
        if not tasks:
            where = variant.label or "the study"
            raise UserError(f"nothing is left of {where}: every problem failed")
        sound = np.array([task.key not in self.store.failed for task in variant.tasks])
        estimates = self.estimates(variant, tasks, blocks, "fitting")
        if not estimates:
            return {}
        estimates |= accuracy_reached(variant, tasks, estimates)
        spread = {name: _spread(values, sound) for name, values in estimates.items()}
        each = self.plan.study.realizations_per_block
        counts = [blocks[task.key] * each for task in variant.tasks]
        spread["realizations"] = np.where(sound, counts, 0).astype(np.int32)
        slopes = _rms_slopes(self.plan, variant)
        spread["rms_slope"] = np.array([slopes[line_of(task)] for task in variant.tasks])
        spread["speed_ratio"] = np.array([speed_ratio(t.problem.speed) for t in variant.tasks])
        steps = [task.steps_per_spacing for task in variant.tasks]
        spread["steps_per_spacing"] = np.array(steps, np.int32)
        return spread

    def estimates(
        self, variant: Variant, tasks: list[Task], blocks: dict[str, int], what: str
    ) -> Estimates:
        """Return the estimates of some tasks from ``blocks`` of each; empty if stopped."""
        size = TASKS_PER_REDUCTION
        parts = [tasks[i : i + size] for i in range(0, len(tasks), size)]
        slopes = _rms_slopes(self.plan, variant)

        def load() -> Iterator[tuple[int, Blocks]]:
            for number, part in enumerate(parts):
                with self.summary.filing():
                    loaded = _load(self.store, self.plan, variant, part, slopes, blocks)
                yield number, loaded

        marched = "relaxation" in self.plan.study.scene.quantities
        fits = (self.plan.jackknife_groups(variant) + 1) * marched * SECONDS_PER_FIT
        found: dict[int, Estimates] = {}
        with Reporter(what, len(tasks) * fits) as reporter:
            work = stream(self.client, _reduce_part, load(), self.watch)
            for (number, _), (estimates, seconds) in work:
                found[number] = estimates
                self.summary.phases["fits"] += seconds
                reporter.advance(len(parts[number]) * fits)
        if self.watch():
            return {}
        return {n: np.concatenate([found[i][n] for i in range(len(parts))]) for n in found[0]}


def _exponents(plan: Plan, variant: Variant, estimates: Estimates) -> Estimates:
    """Take the replicates of b out of the estimates, return the exponents of eq. 13 from them."""
    rates = estimates.pop("rate_replicates", None)
    if rates is None:
        return {}
    hurst = np.array([task.problem.hurst for task in variant.tasks])
    x, status = estimates["speed_ratio"], estimates["fit_status"]
    return fit_exponents(plan.study.grid["hurst"], hurst, x, status, rates)


def accuracy_reached(variant: Variant, tasks: list[Task], estimates: Estimates) -> Estimates:
    """Return what a wanted accuracy adds to the estimates of some tasks; nothing without one."""
    if not variant.goals:
        return {}
    goals = [variant.goals[task.key] for task in tasks]
    ratios = np.array([task.problem.ratio for task in tasks])
    found = attained(estimates, goals, ratios, variant.numerics.accuracy or 0.0)
    bias = np.array([max(goal.bias.values()) for goal in goals])
    return {
        "accuracy_reached": found.reached,
        "accuracy_status": found.status,
        "bias_bound": bias,
    }


def _spread(values: np.ndarray, sound: np.ndarray) -> np.ndarray:
    """Return estimates of the sound tasks as an array over all tasks, NaN or -1 elsewhere."""
    nothing = np.nan if values.dtype.kind == "f" else -1
    spread = np.full((sound.size, *values.shape[1:]), nothing, values.dtype)
    spread[sound] = values
    return spread


def _reduce_part(part: tuple[int, Blocks]) -> tuple[Estimates, float]:
    began = time.thread_time()
    estimates = reduce_blocks(part[1])
    return estimates, time.thread_time() - began


def line_of(task: Task) -> tuple[float, int]:
    """Return what identifies the random lines of a task: (H, N)."""
    return task.problem.hurst, task.problem.elements


def _rms_slopes(plan: Plan, variant: Variant) -> dict[tuple[float, int], float]:
    lines = {line_of(task) for task in variant.tasks}
    return {
        (hurst, n): rms_slope(amplitudes(hurst, n, plan.study.normalisation), n)
        for hurst, n in lines
    }


def _load(
    store: Store,
    plan: Plan,
    variant: Variant,
    tasks: list[Task],
    slopes: dict[tuple[float, int], float],
    blocks: dict[str, int],
) -> Blocks:
    samples, groups = variant.numerics.samples - 1, plan.jackknife_groups(variant)
    records = [(task.key, block) for task in tasks for block in range(blocks[task.key])]
    ends = np.cumsum([blocks[task.key] for task in tasks])[:-1]
    read = store.read(records, samples)
    scalars, curves = (
        np.stack([grouped_means(part, groups) for part in np.split(whole, ends)]) for whole in read
    )
    time = np.full((len(tasks), samples), np.nan)
    if "relaxation" in plan.study.scene.quantities:
        for row, task in enumerate(tasks):
            steps_per_tau = task.problem.speed * task.problem.ratio * task.steps_per_spacing
            recorded = record_steps(task.march_steps, variant.numerics.samples)
            times = record_times(recorded, steps_per_tau, variant.numerics.scheme)
            time[row, : recorded.size] = times
    rms_slopes = np.array([slopes[line_of(task)] for task in tasks])
    return Blocks(scalars, curves, time, rms_slopes, plan.study.scene.quantities)
