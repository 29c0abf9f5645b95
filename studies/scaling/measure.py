"""What clusters of 10, 100 and 1000 workers do with the studies of the paper."""

from collections.abc import Callable
from functools import cache, partial
from itertools import product
from typing import Any

import pandas as pd
import xarray as xr

from elastomer_friction.workflow.errors import UserError
from elastomer_friction.workflow.result import Groups
from elastomer_friction.workflow.study import Key, integer, positive

from .paper import in_own_process, planned_in_pieces
from .virtual import Costs, durations, simulated

TASKS_PER_WORKER = 30  # of the uniform batches
SECONDS_PER_TASK = 1.0e-4  # of the typical machine, to simulate one of them; the next two are too
SECONDS_PER_BATCH = 1.2e-3  # of a simulated study
SECONDS_TO_PLAN = 3.4e-5  # per task of it
ATTRIBUTES = {  # of the variables of a result: what they mean, and their units
    "workers": ("workers of the simulated cluster", "1"),
    "uniform_workers": ("workers of the simulated cluster", "1"),
    "uniform_seconds": ("mean length of the batches", "s"),
    "study": ("study that is simulated", ""),
    "efficiency": ("share of their time in which the workers compute", "1"),
    "rate": ("batches that are computed in a second", "s-1"),
    "points": ("points of the grid", "1"),
    "realizations": ("realizations of all points and variants", "1"),
    "planning": ("CPU time of planning", "s"),
    "batches": ("batches", "1"),
    "longest_batch": ("length of the longest batch", "s"),
    "wall": ("time from the first batch to the last result", "s"),
    "work": ("time of all batches together", "s"),
    "shards": ("shards of the store", "1"),
    "store": ("size of the store", "MiB"),
    "journal": ("size of its journal", "MiB"),
    "driver_memory": ("most memory of the driver", "MiB"),
    "driver_seconds": ("CPU time of the driver for a batch", "s"),
    "indexing": ("CPU time of reading the store's index", "s"),
}


def list_of(check: Callable[[str, object], Any]) -> Callable[[str, object], tuple]:
    """Return the check of a list whose every part passes ``check``."""

    def parts(key: str, value: object) -> tuple:
        if not isinstance(value, list) or not value:
            raise UserError(f"{key} = {value!r}: must be a list, not an empty one")
        return tuple(check(f"{key}[{i}]", part) for i, part in enumerate(value))

    return parts


def text(key: str, value: object) -> str:
    """Return a name; the reader of studies refuses those it does not know."""
    del key
    return str(value)


counts = list_of(partial(integer, least=1))
SETTINGS = {
    "studies": Key(
        list_of(text),
        "The names of the studies whose runs are simulated.",
        "Each further study takes as long as its simulations do.",
        values="a list of names of studies",
    ),
    "scale": Key(
        text,
        "The scale of these studies.",
        "Another scale has other grids, so that the simulated times are other ones.",
        values="the name of a scale that the studies have",
    ),
    "workers": Key(
        counts,
        "The numbers of workers of the clusters on which the studies are simulated.",
        "Doubled, a cluster does a study in half the time as long as its scheduler keeps up.",
        values="a list of whole numbers, each at least 1",
    ),
    "uniform_workers": Key(
        counts,
        "The numbers of workers of clusters that are simulated with batches of one mean length.",
        "Doubled, the scheduler is kept twice as busy.",
        values="a list of whole numbers, each at least 1",
    ),
    "uniform_seconds": Key(
        list_of(positive),
        "The mean lengths of these batches.",
        "Doubled, twice as many workers are kept busy by one scheduler.",
        "s",
        values="a list of numbers above 0",
    ),
    "scheduler_seconds": Key(
        positive,
        "The CPU time that one task costs the scheduler, measured with empty tasks.",
        "Doubled, a cluster saturates at half as many workers.",
        "s",
    ),
    "driver_seconds": Key(
        positive,
        "The CPU time that one task costs the driver, which collects and stores its result.",
        "Doubled, the driver handles half as many tasks a second.",
        "s",
    ),
    "latency": Key(
        positive,
        "The time that a message takes from one process to another.",
        "Doubled, a worker waits for its next batch that much longer.",
        "s",
    ),
}


def outline(settings: dict) -> tuple[list[str], float]:
    """Return what would be measured, and the predicted core-seconds of this and its processes."""
    scale, clusters = settings["scale"], len(settings["workers"])
    seconds = sum(_study_seconds(name, scale, clusters) for name in settings["studies"])
    workers = ", ".join(map(str, settings["workers"]))
    named = ", ".join(settings["studies"])
    lines = [f"simulated   {named} ({settings['scale']}) on {workers} workers"]
    return lines, seconds + _uniform_seconds(settings)


def _uniform_seconds(settings: dict) -> float:
    clusters, means = settings["uniform_workers"], settings["uniform_seconds"]
    return SECONDS_PER_TASK * TASKS_PER_WORKER * sum(clusters) * len(means)


@cache  # a plan of the paper's scale takes seconds, and the outline has asked before
def _study_seconds(name: str, scale: str, clusters: int) -> float:
    plan, pieces, target = planned_in_pieces(name, scale)
    number = sum(piece.blocks / max(1.0, target / piece.seconds) for piece in pieces)
    tasks = sum(len(variant.tasks) for variant in plan.variants)
    return clusters * (SECONDS_TO_PLAN * tasks + SECONDS_PER_BATCH * number)


def measure(settings: dict, seed: int, advance: Callable[[float], None]) -> dict[str, xr.Dataset]:
    """Return the groups uniform (at the root) and studies."""
    costs = Costs(settings["scheduler_seconds"], settings["driver_seconds"], settings["latency"])
    uniform = _uniform(settings, costs, seed)
    advance(_uniform_seconds(settings))
    return {"": uniform, "studies": _studies(settings, costs, advance)}


def _described(dataset: xr.Dataset) -> xr.Dataset:
    """Return a dataset whose variables say what they mean."""
    for name, variable in dataset.variables.items():
        meaning, units = ATTRIBUTES[str(name)]
        variable.attrs = {"long_name": meaning} | ({"units": units} if units else {})
    return dataset


def _uniform(settings: dict, costs: Costs, seed: int) -> xr.Dataset:
    """Return efficiency and rate of simulated batches of one mean length.

    Over (uniform_seconds, uniform_workers).
    """
    rows = []
    for mean, workers in product(settings["uniform_seconds"], settings["uniform_workers"]):
        pool = simulated(workers, durations(mean, TASKS_PER_WORKER * workers, seed), costs)
        rate = pool.tasks / pool.wall
        rows.append((mean, workers, pool.efficiency, rate))
    over = ["uniform_seconds", "uniform_workers"]
    frame = pd.DataFrame(rows, columns=[*over, "efficiency", "rate"])
    return _described(frame.set_index(over).to_xarray())


def _studies(settings: dict, costs: Costs, advance: Callable[[float], None]) -> xr.Dataset:
    """Return what simulated runs of whole studies take, over (study, workers)."""
    frames = []
    for name in settings["studies"]:
        for workers in settings["workers"]:
            where = {"study": name, "scale": settings["scale"], "workers": workers}
            frames.append({**where, **in_own_process(**where, costs=list(costs))})
        advance(_study_seconds(name, settings["scale"], len(settings["workers"])))
    frame = pd.DataFrame(frames).drop(columns="scale").set_index(["study", "workers"])
    return _described(frame.to_xarray())


def table(groups: Groups) -> pd.DataFrame:
    """Return one row per study and cluster."""
    return groups["studies"].to_dataframe().reset_index()
