"""How much longer than a typical machine this one takes, as JSON: a module to run.

It runs in a process of its own, set up like a worker (how memory is kept matters as much as the
processor), and computes what a worker computes: whole realizations of a few problems.
"""

import json
from datetime import UTC, datetime

import numpy as np

from ....kernels import Quantities
from ....kernels.compile.clock import computing_seconds
from ...simulate import Batch, Problem, Recording, Task, block_means
from ...system import processor
from .work import DRAWING, PARTS, Work, drawing_seconds, typical_seconds

FOUR = (0.003, 0.03, 0.3, 3.0)
ROUNDS = 5  # of all probes; the quickest of each part counts, the slowest tells how far it varies
# H, N, vbar, m, steps to march, loads, blocks of four lines: one load and many that share sweeps,
# short lines and long ones, narrow contacts and wide ones, slow sliding and fast. Together they
# take as long over what is typical as the batches of all studies do.
PROBES = (
    (0.7, 5000, 1.0, 4, 60, (0.1,), 12),
    (0.0, 5000, 10.0, 12, 40, FOUR, 1),
    (0.7, 5000, 30.0, 4, 100, FOUR, 4),
    (0.7, 50_000, 3.0, 4, 24, (0.3,), 3),
    (0.3, 2000, 30.0, 8, 20, tuple(np.geomspace(0.01, 1.0, 5)), 4),
    (0.5, 1000, 1.0, 8, 30, tuple(np.geomspace(0.003, 10.0, 20)), 8),
    (0.3, 1000, 1.0, 8, 40, (0.01, 0.1), 12),
    (0.8, 5000, 100.0, 4, 100, (0.3,), 12),
)
RECORDING = Recording(64)


def batch(
    hurst: float,
    elements: int,
    speed: float,
    steps: int,
    march_steps: int,
    loads: tuple[float, ...],
    blocks: int,
) -> Batch:
    """Return the batch of a probe."""
    problems = [Problem(hurst, elements, load, speed, 1.2) for load in loads]
    tasks = tuple(Task(problem, steps, march_steps, "") for problem in problems)
    return Batch(1, "modal", Quantities(), "exponential", RECORDING, tasks, 0, blocks, 4, 0.0)


def typical(probe: Batch) -> np.ndarray:
    """Return the typical seconds of the parts of a probe."""
    found = np.zeros(len(PARTS))
    count = len(probe.tasks)  # on the same lines at the same speed
    for task in probe.tasks:
        work = Work(task.problem, task.steps_per_spacing, task.march_steps, True, count, count)
        found += list(typical_seconds(probe.quantities, work, RECORDING).values())
    samples = probe.tasks[0].problem.elements * probe.tasks[0].steps_per_spacing
    found[PARTS.index(DRAWING)] = drawing_seconds(samples)
    return probe.blocks * probe.realizations_per_block * found


def used(probe: Batch) -> np.ndarray:
    """Return the CPU seconds that the parts of a probe take."""
    began = computing_seconds()
    spent = block_means(probe).spent.sum(axis=0)
    return np.append(spent, max(computing_seconds() - began - spent.sum(), 1e-6))


def factors(rounds: int = ROUNDS) -> dict[str, tuple[float, float]]:
    """Return part -> (used over typical, its largest over its smallest) of the probes together.

    Whatever else runs on the machine only ever takes time: the quickest round is nearest to what
    the machine can do.
    """
    probes = [batch(*probe) for probe in PROBES]
    for probe in probes:
        used(probe)  # machine code is loaded, memory is there
    whole = sum(typical(probe) for probe in probes)
    found = np.array([sum(used(probe) for probe in probes) / whole for _ in range(rounds)])
    least, worst = found.min(axis=0), found.max(axis=0) / found.min(axis=0)
    return dict(zip(PARTS, zip(least.tolist(), worst.tolist(), strict=True), strict=True))


if __name__ == "__main__":
    today = datetime.now(UTC).date().isoformat()
    print(json.dumps({"machine": processor(), "date": today, "measured": factors()}))
