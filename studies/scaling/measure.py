"""What clusters of 10, 100 and 1000 workers do with the studies of the paper."""

from collections.abc import Callable
from typing import cast

import numpy as np
import pandas as pd
import xarray as xr

from workflow.errors import UserError
from workflow.plan import batch_target, cut, make_plan, missing_work, total_seconds
from workflow.result import Groups
from workflow.study import Study, axis_values, integer, positive, read_study

from .paper import alone
from .virtual import Costs, durations, simulated

TASKS_PER_WORKER = 30  # of the uniform batches
SECONDS_PER_BATCH = 1.3e-4  # of the driver of a simulated study: outline
SECONDS_TO_PLAN = 1e-4  # per task of it


def counts(key: str, value: object) -> tuple[int, ...]:
    """Return a list of whole numbers of at least one."""
    if not isinstance(value, list) or not value:
        raise UserError(f"{key} = {value!r}: must be a list of whole numbers")
    return tuple(integer(f"{key}[{i}]", part, 1) for i, part in enumerate(value))


def lengths(key: str, value: object) -> tuple[float, ...]:
    """Return seconds, all positive."""
    return tuple(positive(key, part) for part in axis_values(key, value))


def names(key: str, value: object) -> tuple[str, ...]:
    """Return names of grid studies."""
    if not isinstance(value, list) or not all(isinstance(part, str) for part in value):
        raise UserError(f"{key} = {value!r}: must be a list of names of studies")
    return tuple(value)


SETTINGS = {
    "studies": names,
    "scale": lambda key, value: names(key, [value])[0],
    "workers": counts,  # of the simulated studies
    "uniform_workers": counts,  # of the simulated uniform batches
    "uniform_seconds": lengths,
    "scheduler_seconds": positive,  # what one task costs the scheduler
    "driver_seconds": positive,  # and the driver
    "latency": positive,  # s, of a message between two processes
}


def outline(settings: dict) -> tuple[list[str], float]:
    """Return what would be measured, and the predicted core-seconds of this and its processes."""
    seconds = sum(_study_seconds(name, settings) for name in settings["studies"])
    workers = ", ".join(map(str, settings["workers"]))
    named = ", ".join(settings["studies"])
    return [f"simulated   {named} ({settings['scale']}) on {workers} workers"], seconds + 5.0


def _study_seconds(name: str, settings: dict) -> float:
    plan = make_plan(cast(Study, read_study(name, settings["scale"])))
    missing = missing_work(plan, ())
    target = batch_target(total_seconds(missing))
    number = sum(piece.blocks * piece.seconds / target for piece in cut(plan, missing, target))
    tasks = sum(len(variant.tasks) for variant in plan.variants)
    return len(settings["workers"]) * (SECONDS_TO_PLAN * tasks + SECONDS_PER_BATCH * number)


def measure(settings: dict, seed: int, advance: Callable[[float], None]) -> dict[str, xr.Dataset]:
    """Return the groups uniform (at the root) and studies."""
    costs = Costs(settings["scheduler_seconds"], settings["driver_seconds"], settings["latency"])
    uniform = _uniform(settings, costs, seed)
    advance(5.0)
    return {"": uniform, "studies": _studies(settings, costs, advance)}


def _uniform(settings: dict, costs: Costs, seed: int) -> xr.Dataset:
    """Return efficiency over (seconds, workers) of simulated batches of one mean length."""
    shape = (len(settings["uniform_seconds"]), len(settings["uniform_workers"]))
    efficiency, rate = np.empty(shape), np.empty(shape)
    for i, mean in enumerate(settings["uniform_seconds"]):
        for j, workers in enumerate(settings["uniform_workers"]):
            client = simulated(workers, durations(mean, TASKS_PER_WORKER * workers, seed), costs)
            efficiency[i, j], rate[i, j] = client.efficiency, client.tasks / client.wall
    dims = ("seconds", "workers")
    coords = {"seconds": list(settings["uniform_seconds"])}
    coords["workers"] = list(settings["uniform_workers"])
    return xr.Dataset({"efficiency": (dims, efficiency), "rate": (dims, rate)}, coords)


def _studies(settings: dict, costs: Costs, advance: Callable[[float], None]) -> xr.Dataset:
    """Return what simulated runs of whole studies take, over (study, workers)."""
    frames = []
    for name in settings["studies"]:
        for workers in settings["workers"]:
            where = {"study": name, "scale": settings["scale"], "workers": workers}
            frames.append({**where, **alone(**where, costs=list(costs))})
        advance(_study_seconds(name, settings))
    frame = pd.DataFrame(frames).drop(columns="scale").set_index(["study", "workers"])
    return frame.to_xarray()


def table(groups: Groups) -> pd.DataFrame:
    """Return one row per study and cluster."""
    return groups["studies"].to_dataframe().reset_index()
