"""CPU time of batches on the code of commit 9b0af71, a line of JSON for each that is read.

Run as a script with the root of a checkout of that commit as PYTHONPATH: it imports its workflow.
Lines are random ones of the same kind: that code knows no quartets. Marches are as long as its plan
made them at the steps per spacing that are given.
"""

import json
import sys
from types import SimpleNamespace

from elastomer_friction.workflow.batch import Batch, Task, block_means
from elastomer_friction.workflow.resolution import horizon_steps
from elastomer_friction.workflow.similarity import Problem

from elastomer_friction.kernels import Quantities


def batch_of(given):
    """Return the batch that a line of JSON describes."""
    asked = Quantities(*given["quantities"])
    numerics = SimpleNamespace(horizon=given["horizon"])
    tasks = []
    for numbers, steps in given["tasks"]:
        problem = Problem(*numbers)
        march = horizon_steps(problem, numerics, steps) if asked.relaxation else 0
        tasks.append(Task(problem, steps, march, ""))
    return Batch(
        seed=given["seed"],
        normalisation=given["normalisation"],
        quantities=asked,
        scheme=given["scheme"],
        samples=given["samples"],
        tasks=tuple(tasks),
        first_block=given["first_line"],
        blocks=1,
        realizations_per_block=given["lines"],
        seconds=0.0,
    )


if __name__ == "__main__":
    for line in sys.stdin:
        batch = batch_of(json.loads(line))
        print(json.dumps({"seconds": block_means(batch).seconds}), flush=True)
