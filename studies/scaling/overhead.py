"""Time that real worker processes are idle between batches that only sleep.

Runs in a process of its own (processes.alone), as the driver of an embedded cluster.
"""

import dataclasses
import tempfile
import time
from itertools import cycle, islice
from pathlib import Path

from workflow.plan.batches import batches
from workflow.plan.plan import make_plan
from workflow.run.clusters import open_client
from workflow.run.flow import stream
from workflow.store.shelf import Shelf
from workflow.store.store import Store
from workflow.study.cluster import HERE
from workflow.study.read import read_study

from .pretend import pretend, sleep_through, whole


def measured(workers: int, seconds: float, each: int) -> dict[str, float]:
    """Return the share of idle time where every worker gets ``each`` batches of ``seconds``."""
    sample = list(islice(batches(make_plan(read_study("fig7", "smoke")), ()), 8))
    work = [
        dataclasses.replace(batch, seconds=seconds)
        for batch in islice(cycle(sample), workers * each)
    ]
    with tempfile.TemporaryDirectory() as folder, open_client(HERE, workers) as client:
        for _ in stream(client, whole(pretend), work[:workers]):
            pass  # workers have imported everything
        began = time.monotonic()
        with Shelf(Store(Path(folder)), seconds) as shelf:
            for batch, done in stream(client, whole(sleep_through), work):
                shelf.add(batch, done)
        wall = time.monotonic() - began
    return {"wall": wall, "overhead": 1.0 - each * seconds / wall}
