"""What scheduling costs, and what the driver needs for more and more realizations.

    python -m tests.cluster.overhead

Batches wait instead of computing: their planning, sending, gathering and storing is real.
"""

import dataclasses
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from tests.workflow.small import random_result, small_plan
from workflow.plan.batches import batches
from workflow.run.clusters import open_client
from workflow.run.flow import stream
from workflow.simulate.tasks import Batch, BatchResult
from workflow.store.shelf import Shelf
from workflow.store.store import Store
from workflow.study.cluster import HERE

WORKERS = 2
CHUNKS, SECONDS = 40, 2.0
REALIZATIONS = (1_000, 10_000, 100_000, 1_000_000)
PER_BATCH = 500  # realizations


def pretend(batch: Batch) -> BatchResult:
    """Take the predicted time of a batch, compute nothing."""
    time.sleep(batch.seconds)
    return random_result(batch)


def stored(count: int, seconds: float) -> tuple[float, float, int]:
    """Stream batches into a store: wall time, CPU time of the driver with its scheduler, shards."""
    (whole, *_) = batches(small_plan(), set(), 1e9)
    work = (
        dataclasses.replace(whole, first_block=whole.blocks * i, seconds=seconds)
        for i in range(count)
    )
    with tempfile.TemporaryDirectory() as folder, open_client(HERE, WORKERS) as client:
        list(stream(client, pretend, [dataclasses.replace(whole, seconds=0.0)] * WORKERS))
        wall, cpu = time.monotonic(), time.process_time()
        with Shelf(Store(Path(folder)), seconds) as shelf:
            for batch, done in stream(client, pretend, work):
                shelf.add(batch, done)
        wall, cpu = time.monotonic() - wall, time.process_time() - cpu
        return wall, cpu, len(list(Path(folder).glob("*.nc")))


def main() -> None:
    """Print both tables; the second from a process for each row."""
    if len(sys.argv) > 1:
        _, cpu, shards = stored(int(sys.argv[1]) // PER_BATCH, 0.0)
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0
        print(f"{sys.argv[1]:>10s} {peak:10.0f} {shards:8d} {cpu:8.1f}")
        return
    wall, cpu, shards = stored(CHUNKS, SECONDS)
    ideal = CHUNKS * SECONDS / WORKERS
    print(f"{CHUNKS} batches of {SECONDS} s on {WORKERS} workers, {shards} shards:")
    print(f"  wall {wall:.1f} s, ideal {ideal:.1f} s: overhead {wall / ideal - 1.0:.1%}")
    share = cpu / (CHUNKS * SECONDS)
    print(f"  CPU of driver and scheduler {1e3 * cpu / CHUNKS:.1f} ms a batch, {share:.2%} of it")
    print("realizations  driver MiB   shards    CPU s")
    for count in REALIZATIONS:
        subprocess.run([sys.executable, "-m", "tests.cluster.overhead", str(count)], check=True)


if __name__ == "__main__":
    main()
