"""A whole study on a virtual cluster: real plan, flow, shelf, store and journal, no kernels.

Runs in a process of its own (processes.alone), so that its memory is that of a driver.
"""

import tempfile
import time
from operator import attrgetter
from pathlib import Path

from workflow.plan.batches import batch_target, batches
from workflow.plan.plan import make_plan
from workflow.run.flow import stream
from workflow.store.journal import size
from workflow.store.shelf import Shelf
from workflow.store.store import Store
from workflow.study.read import read_study
from workflow.system.process import peak_bytes

from .pretend import pretend
from .virtual import Costs, VirtualClient, virtual_time

MEBIBYTE = 2**20


def measured(study: str, scale: str, workers: int, costs: list[float]) -> dict[str, float]:
    """Return what the study takes on so many workers; sizes in MiB, times in s."""
    began = time.process_time()
    plan = make_plan(read_study(study, scale))
    target = batch_target(sum(batch.seconds for batch in batches(plan, ())))
    planned = time.process_time() - began
    client = VirtualClient(workers, Costs(*costs), attrgetter("seconds"))
    longest = 0.0
    began = time.process_time()
    with tempfile.TemporaryDirectory() as folder:
        store = Store(Path(folder))
        with virtual_time(client), Shelf(store, target) as shelf:
            for batch, done in stream(client, pretend, batches(plan, store, target)):
                shelf.add(batch, done)
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
        "planning": planned,
        "batches": client.tasks,
        "longest_batch": longest,
        "wall": client.wall,
        "work": client.busy,
        "efficiency": client.efficiency,
        "shards": len(store.index.sizes),
        "store": sum(store.index.sizes.values()) / MEBIBYTE,
        "journal": journal / MEBIBYTE,
        "driver_memory": memory,
        "driver_seconds": spent / client.tasks,  # measured: flow, index, shards; no network
        "indexing": indexing,
    }
