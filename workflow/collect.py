"""Collect stored block means, reduce them on the workers, assemble the datasets."""

import time
from collections.abc import Iterator

import numpy as np
import xarray as xr
from distributed import Client

from kernels import amplitudes, rms_slope
from workflow.batch import Task
from workflow.dataset import build_dataset
from workflow.errors import UserError
from workflow.flow import stream
from workflow.plan import Plan, Variant
from workflow.progress import Reporter
from workflow.reduction import Blocks, Estimates, reduce_blocks
from workflow.resolution import record_steps, record_times
from workflow.store import Store
from workflow.summary import Summary
from workflow.watch import Watch

TASKS_PER_REDUCTION = 32
SECONDS_PER_FIT = 4e-4


def collect(
    client: Client, store: Store, plan: Plan, summary: Summary, watch: Watch
) -> dict[str, xr.Dataset]:
    """Return label -> dataset of every variant of a plan whose records are all stored.

    Tasks that failed are marked: estimates NaN, fit_status -1, realizations 0. Empty if
    ``watch()`` turned true meanwhile.
    """
    marching = "relaxation" in plan.study.scene.quantities
    fits = sum(len(v.tasks) for v in plan.variants) * (plan.study.blocks + 1) * marching
    datasets = {}
    with Reporter("fitting", fits * SECONDS_PER_FIT) as reporter:
        for variant in plan.variants:
            estimates = _reduce_variant(client, store, plan, variant, summary, watch, reporter)
            if watch():
                return {}
            datasets[variant.label] = build_dataset(plan, variant, estimates)
    return datasets


def _reduce_variant(
    client: Client,
    store: Store,
    plan: Plan,
    variant: Variant,
    summary: Summary,
    watch: Watch,
    reporter: Reporter,
) -> Estimates:
    size = TASKS_PER_REDUCTION
    sound = np.array([task.key not in store.failed for task in variant.tasks])
    tasks = [task for task in variant.tasks if task.key not in store.failed]
    if not tasks:
        raise UserError(f"nothing is left of {variant.label or 'the study'}: every problem failed")
    parts = [tasks[i : i + size] for i in range(0, len(tasks), size)]
    slopes = _rms_slopes(plan, variant)

    def load() -> Iterator[tuple[int, Blocks]]:
        for number, part in enumerate(parts):
            with summary.filing():
                blocks = _load(store, plan, variant, part, slopes)
            yield number, blocks

    found: dict[int, Estimates] = {}
    for (number, _), (estimates, seconds) in stream(client, _reduce_part, load(), watch):
        found[number] = estimates
        summary.phases["fits"] += seconds
        reporter.advance(len(parts[number]) * (plan.study.blocks + 1) * SECONDS_PER_FIT)
    if watch():
        return {}
    merged = {
        n: _spread(np.concatenate([found[i][n] for i in range(len(parts))]), sound)
        for n in found[0]
    }
    if not sound.all():
        merged["realizations"] = np.where(sound, plan.study.realizations, 0).astype(np.int32)
    merged["rms_slope"] = np.array([slopes[line_of(task)] for task in variant.tasks])
    return merged


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
) -> Blocks:
    samples = variant.numerics.samples - 1
    records = [(task.key, block) for task in tasks for block in range(plan.study.blocks)]
    scalars, curves = store.read(records, samples)
    time = np.full((len(tasks), samples), np.nan)
    if "relaxation" in plan.study.scene.quantities:
        for row, task in enumerate(tasks):
            pace = task.problem.speed * task.problem.ratio * task.steps_per_spacing
            recorded = record_steps(task.march, variant.numerics.samples)
            times = record_times(recorded, pace, variant.numerics.scheme)
            time[row, : recorded.size] = times
    return Blocks(
        scalars.reshape(len(tasks), plan.study.blocks, -1),
        curves.reshape(len(tasks), plan.study.blocks, -1),
        time,
        np.array([slopes[line_of(task)] for task in tasks]),
        plan.study.scene.quantities,
    )
