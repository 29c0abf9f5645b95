"""Real scheduler, real driver, sleeping workers: tasks per second, CPU per task, efficiency."""

import time
from collections.abc import Iterator
from operator import pos
from typing import NamedTuple

import numpy as np
from distributed import Client

from workflow.run.flow import stream

from .processes import Started, sleeping_cluster
from .virtual import Costs, VirtualClient, virtual_time

SPREAD = 0.5  # of a task's time, about its mean, each way
LATENCY = 1e-3  # s, of a message between two processes


class Measured(NamedTuple):
    """One stream of tasks; CPU in seconds per task."""

    workers: int
    seconds: float  # mean of a task
    tasks: int
    wall: float
    efficiency: float
    scheduler_cpu: float
    driver_cpu: float
    workers_cpu: float


def durations(seconds: float, tasks: int, seed: int) -> list[float]:
    """Return times of tasks, uniform about their mean."""
    spread = np.random.default_rng(seed).uniform(1.0 - SPREAD, 1.0 + SPREAD, tasks)
    return (seconds * spread).tolist()


def measured(
    workers: int, means: list[float], each: int, nothing: int, seed: int
) -> Iterator[Measured]:
    """Yield a stream of ``nothing`` empty tasks, then one per mean with ``each`` per worker.

    At the end come the empty tasks once more: other work on the machine comes and goes.
    """
    with sleeping_cluster(workers) as (scheduler, some), Client(scheduler.line) as client:
        for mean in (0.0, *means, 0.0):
            tasks = each * workers if mean else nothing
            yield _stream(client, scheduler, some, workers, durations(mean, tasks, seed))


def _stream(
    client: Client, scheduler: Started, some: Started, workers: int, items: list[float]
) -> Measured:
    def cpu() -> np.ndarray:
        return np.array([scheduler.cpu(), time.process_time(), some.cpu()])

    before, began = cpu(), time.monotonic()
    done = sum(1 for _ in stream(client, time.sleep, items))
    wall = time.monotonic() - began
    return Measured(
        workers,
        sum(items) / done,
        done,
        wall,
        sum(items) / (workers * wall),
        *((cpu() - before) / done).tolist(),
    )


def simulated(workers: int, items: list[float], costs: Costs) -> VirtualClient:
    """Return the virtual cluster after the same stream."""
    with virtual_time(VirtualClient(workers, costs, pos)) as client:
        for _ in stream(client, pos, items):
            pass
    return client
