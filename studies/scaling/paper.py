"""A whole study on a virtual cluster: real plan, flow, buffer, store and journal, no kernels.

`python -m elastomer_friction.studies.scaling.paper ARGUMENTS` runs it in a process of its own, so
that its memory is that of a driver.
"""

import json
import subprocess
import sys
import tempfile
import time
from operator import attrgetter
from pathlib import Path
from typing import Any, cast

import numpy as np

from elastomer_friction.workflow.cluster import stream
from elastomer_friction.workflow.plan import (
    Missing,
    Plan,
    batch_target,
    cut,
    make_batches,
    make_plan,
    missing_work,
    total_seconds,
)
from elastomer_friction.workflow.simulate import PHASES, SCALARS, Batch, BatchResult
from elastomer_friction.workflow.store import Store, WriteBuffer, size
from elastomer_friction.workflow.study import Study, read_study
from elastomer_friction.workflow.system import peak_bytes, this_maker

from .virtual import Costs, VirtualPool

MEBIBYTE = 2**20


def in_own_process(**arguments: Any) -> dict[str, float]:
    """Return what ``measured(**arguments)`` returns in a process of its own."""
    command = [
        sys.executable,
        "-m",
        "elastomer_friction.studies.scaling.paper",
        json.dumps(arguments),
    ]
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=True)
    return json.loads(done.stdout.splitlines()[-1])


def planned_in_pieces(study: str, scale: str) -> tuple[Plan, list[Missing], float]:
    """Return the plan of a study, its work in pieces, and the target of a batch (s)."""
    plan = make_plan(cast(Study, read_study(study, scale)))
    missing = missing_work(plan, ())
    target = batch_target(total_seconds(missing))
    return plan, cut(plan, missing, target), target


def measured(study: str, scale: str, workers: int, costs: list[float]) -> dict[str, float]:
    """Return what the study takes on so many workers; sizes in MiB, times in s."""
    began = time.process_time()
    plan, pieces, target = planned_in_pieces(study, scale)
    work = make_batches(plan, pieces, target)
    planning = time.process_time() - began
    pool = VirtualPool(workers, Costs(*costs), attrgetter("seconds"), pretend)
    longest = 0.0
    began = time.process_time()
    with tempfile.TemporaryDirectory() as folder:
        store = Store(Path(folder))
        with WriteBuffer(store, target, pool.monotonic) as buffer:
            for batch, done in stream(pool, work):
                buffer.add(batch, done)
                longest = max(longest, batch.seconds)
        spent = time.process_time() - began
        memory = peak_bytes() / MEBIBYTE
        began = time.process_time()
        indexed = len(Store(Path(folder)).index.found)
        indexing = time.process_time() - began
        journal = size(Path(folder))
    if indexed != len(store.index.found):
        raise RuntimeError(
            f"{study}: the journal tells of {indexed} of {len(store.index.found)} rows"
        )
    return {
        "points": plan.points,
        "realizations": sum(len(v.tasks) for v in plan.variants) * plan.study.realizations,
        "planning": planning,
        "batches": pool.tasks,
        "longest_batch": longest,
        "wall": pool.wall,
        "work": pool.busy,
        "efficiency": pool.efficiency,
        "shards": len(store.index.sizes),
        "store": sum(store.index.sizes.values()) / MEBIBYTE,
        "journal": journal / MEBIBYTE,
        "driver_memory": memory,
        "driver_seconds": spent / pool.tasks,  # measured: flow, index, shards; no network
        "indexing": indexing,
    }


def pretend(batch: Batch) -> BatchResult:
    """Return a result of zeros that claims the predicted time."""
    shape = (len(batch.tasks), batch.blocks)
    return BatchResult(
        scalars=np.zeros((*shape, len(SCALARS))),
        curves=np.zeros((*shape, batch.recording.samples - 1)),
        spent=np.zeros((len(batch.tasks), len(PHASES))),
        seconds=batch.seconds,
        peak=0,
        maker=this_maker(),
    )


if __name__ == "__main__":
    print(json.dumps(measured(**json.loads(sys.argv[1]))))
