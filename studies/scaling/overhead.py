"""Time that real worker processes are idle between batches that only sleep.

Runs in a process of its own (processes.alone), as the driver of an embedded cluster.
"""

import dataclasses
import tempfile
import time
from itertools import cycle, islice
from pathlib import Path

from workflow.cluster import open_client
from workflow.flow import stream
from workflow.place import HERE
from workflow.plan import batches, make_plan
from workflow.reader import read_study
from workflow.shelf import Shelf
from workflow.store import Store

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
