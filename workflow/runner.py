"""Run a plan: compute what is missing, store it as it finishes, reduce, write the result."""

import signal
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from types import FrameType

import numpy as np
from distributed import Client

from kernels import Case, Line, amplitudes, run_case
from workflow.batch import Batch, block_means
from workflow.cluster import open_client
from workflow.collect import collect
from workflow.dataset import write_datasets
from workflow.flow import stream
from workflow.plan import Plan, batch_target, batches, quantities
from workflow.progress import Reporter
from workflow.store import Store
from workflow.summary import Summary


class Interrupt:
    """Ctrl-C and SIGTERM: the first stops taking up work, a later one aborts at once."""

    BOUNCE_SECONDS = 1.0  # one key press or `timeout` may signal process and group

    def __init__(self) -> None:
        self.asked = 0.0

    def __enter__(self) -> "Interrupt":
        self.previous = {s: signal.signal(s, self._handle) for s in (signal.SIGINT, signal.SIGTERM)}
        return self

    def __exit__(self, *_: object) -> None:
        for number, handler in self.previous.items():
            signal.signal(number, handler)

    def __call__(self) -> bool:
        return self.asked > 0.0

    def _handle(self, number: int, frame: FrameType | None) -> None:
        now = time.monotonic()
        if self.asked and now - self.asked > self.BOUNCE_SECONDS:
            raise KeyboardInterrupt
        if not self.asked:
            self.asked = now
            print("stopping: running batches are finished and stored", file=sys.stderr)


def run_plan(
    plan: Plan,
    result: Path,
    scheduler: str | None = None,
    workers: int | None = None,
    batch_seconds: float | None = None,
) -> Summary:
    """Compute whatever of the plan is not stored yet and write the result file.

    batch_seconds : predicted length of a batch; by default it grows with the study. An
    interrupted run keeps all finished batches and writes no result file.
    """
    began = time.monotonic()
    store = Store(store_folder(result))
    stored = store.records()
    predicted = sum(batch.seconds for batch in batches(plan, stored))
    target = batch_seconds or batch_target(predicted)
    wanted = ((t.key, b) for v in plan.variants for t in v.tasks for b in range(plan.study.blocks))
    summary = Summary(reused=sum(record in stored for record in wanted), predicted=predicted)
    if predicted:
        warm_up(plan)
    with open_client(scheduler, workers) as client, Interrupt() as interrupt:
        summary.start = time.monotonic() - began
        summary.workers = max(1, sum(client.nthreads().values()))
        work = batches(plan, stored, target)
        _compute(client, store, work, summary, interrupt)
        datasets = {} if interrupt() else collect(client, store, plan, summary, interrupt)
        if datasets:
            with summary.filing():
                write_datasets(result, datasets)
    summary.interrupted = interrupt()
    summary.wall = time.monotonic() - began
    return summary


def store_folder(result: Path) -> Path:
    """Return the folder of finished batches beside a result file; studies share it."""
    return result.parent / "store"


def warm_up(plan: Plan) -> None:
    """Compile every kernel once, so that workers find machine code in the cache."""
    for scheme in {variant.numerics.scheme for variant in plan.variants}:
        phases = np.linspace(0.0, 6.0, 8)
        line = Line.self_affine(amplitudes(0.5, 16), phases, 16, 2)
        case = Case(0.1, 1.0, (1.2,), (np.arange(1, 3),), scheme)
        run_case(line, case, quantities(plan.study))


def _compute(
    client: Client, store: Store, work: Iterator[Batch], summary: Summary, interrupt: Interrupt
) -> None:
    with Reporter("computing", summary.predicted) as reporter:
        for batch, done in stream(client, block_means, work, interrupt):
            with summary.filing():
                store.add(batch, done)
            summary.count(batch, done)
            reporter.advance(batch.seconds)
