"""What clusters of 10, 100 and 1000 workers do with the studies of the paper."""

from functools import partial
from pathlib import Path

import numpy as np
import pandas as pd
import xarray as xr

from workflow.errors import UserError
from workflow.plan.batches import batch_target, batches
from workflow.plan.plan import make_plan
from workflow.study.checks import integer, positive
from workflow.study.grid import axis_values
from workflow.study.read import read_study

from .processes import alone
from .real import LATENCY, Costs, durations, measured, simulated

OF_A_RUN = ("workers", "seconds", "tasks", "wall", "efficiency")
OF_CPU = ("scheduler_cpu", "driver_cpu", "workers_cpu")
TASKS_PER_WORKER = 30  # of the uniform batches
SECONDS_PER_BATCH = 1.3e-4  # of the driver of a simulated study: outline
SECONDS_TO_PLAN = 1e-4  # per task of it
SECONDS_PER_TASK = 8e-3  # of all processes of a real cluster


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
    "real_workers": counts,  # of real clusters of sleeping workers
    "real_seconds": lengths,
    "real_tasks": partial(integer, least=1),  # per worker
    "empty_tasks": partial(integer, least=1),
    "realizations": counts,  # of real runs whose driver's memory is taken
    "overhead_workers": partial(integer, least=1),
    "overhead_seconds": positive,
    "overhead_tasks": partial(integer, least=1),  # per worker
}


def outline(settings: dict) -> tuple[list[str], float]:
    """Return what would be measured, and the predicted core-seconds of this and its processes."""
    seconds = sum(_study_seconds(name, settings) for name in settings["studies"])
    each = settings["real_tasks"] * len(settings["real_seconds"])
    real = [2 * settings["empty_tasks"] + each * w for w in settings["real_workers"]]
    seconds += SECONDS_PER_TASK * sum(real) + 3.0 * len(real)
    seconds += sum(4.0 + 1e-4 * total for total in settings["realizations"]) + 5.0
    lines = [
        f"simulated   {', '.join(settings['studies'])} ({settings['scale']}) on "
        f"{', '.join(map(str, settings['workers']))} workers",
        f"real        {', '.join(map(str, settings['real_workers']))} sleeping workers; "
        f"{settings['overhead_workers']} worker processes",
    ]
    return lines, seconds


def _study_seconds(name: str, settings: dict) -> float:
    plan = make_plan(read_study(name, settings["scale"]))
    target = batch_target(sum(batch.seconds for batch in batches(plan, ())))
    number = sum(1 for _ in batches(plan, (), target))
    tasks = sum(len(variant.tasks) for variant in plan.variants)
    return len(settings["workers"]) * (SECONDS_TO_PLAN * tasks + SECONDS_PER_BATCH * number)


def measure(settings: dict, seed: int, advance) -> dict[str, xr.Dataset]:
    """Return the groups uniform (at the root), real, studies and memory."""
    runs = _real_runs(settings, seed, advance)
    empty = runs.where(runs.seconds == 0.0, drop=True)
    costs = Costs(float(empty.scheduler_cpu.max()), float(empty.driver_cpu.max()), LATENCY)
    found = {
        "": _uniform(settings, costs, seed),
        "real": runs,
        "studies": _studies(settings, costs, advance),
        "memory": _memory(settings, advance),
    }
    idle = alone(
        "overhead",
        workers=settings["overhead_workers"],
        seconds=settings["overhead_seconds"],
        each=settings["overhead_tasks"],
    )
    found[""] = found[""].assign_attrs(
        {f"{name}_seconds_per_task": value for name, value in costs._asdict().items()}
        | {"overhead": idle["overhead"]}
    )
    return found


def _real_runs(settings: dict, seed: int, advance) -> xr.Dataset:
    """Return real streams, and beside each the same one simulated.

    All processes share the cores of this machine: the simulation is told what an empty task
    took there by the clock, as the one cost of the one server.
    """
    rows, same = [], []
    for workers in settings["real_workers"]:
        means, each = list(settings["real_seconds"]), settings["real_tasks"]
        some = list(measured(workers, means, each, settings["empty_tasks"], seed))
        advance(SECONDS_PER_TASK * sum(run.tasks for run in some))
        empty = [run.wall / run.tasks for run in some if run.seconds == 0.0]
        for run, mean in zip(some, (0.0, *means, 0.0), strict=True):
            items = durations(mean, run.tasks, seed)
            client = simulated(workers, items, Costs(float(np.mean(empty)), 0.0, LATENCY))
            rows.append(run)
            same.append(client.efficiency)
    data = {name: ("run", np.array([getattr(r, name) for r in rows])) for name in OF_A_RUN + OF_CPU}
    return xr.Dataset({**data, "simulated_efficiency": ("run", np.array(same))})


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


def _studies(settings: dict, costs: Costs, advance) -> xr.Dataset:
    """Return what simulated runs of whole studies take, over (study, workers)."""
    frames = []
    for name in settings["studies"]:
        for workers in settings["workers"]:
            where = {"study": name, "scale": settings["scale"], "workers": workers}
            frames.append({**where, **alone("paper", **where, costs=list(costs))})
        advance(_study_seconds(name, settings))
    frame = pd.DataFrame(frames).drop(columns="scale").set_index(["study", "workers"])
    return frame.to_xarray()


def _memory(settings: dict, advance) -> xr.Dataset:
    """Return the memory of a real driver over the number of realizations."""
    frames = []
    for realizations in settings["realizations"]:
        run = alone("memory", realizations=realizations)
        frames.append({"realizations": realizations, **run})
        advance(4.0 + 1e-4 * realizations)
    return pd.DataFrame(frames).set_index("realizations").to_xarray()


def table(result: Path) -> pd.DataFrame:
    """Return one row per study and cluster."""
    with xr.open_dataset(result, group="studies") as data:
        return data.to_dataframe().reset_index()
