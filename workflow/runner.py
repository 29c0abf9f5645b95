"""Run a plan: compute what is missing, store it as it finishes, reduce, write the result."""

import time
from functools import partial
from pathlib import Path

import xarray as xr
from distributed import Client

from workflow.batch import load_kernels
from workflow.cluster import open_client
from workflow.collect import collect
from workflow.dataset import write_datasets
from workflow.durable import clear_leftovers
from workflow.errors import UserError
from workflow.failures import Failures
from workflow.flow import stream
from workflow.interrupt import Interrupt
from workflow.lock import hold
from workflow.plan import Plan, batch_target, batches, quantities
from workflow.progress import Reporter
from workflow.shelf import Shelf
from workflow.store import DamagedShard, Store
from workflow.summary import Summary
from workflow.versions import check_versions, versions
from workflow.work import run_batch

ATTEMPTS = 3  # at a result, when shards turn out damaged


def run_plan(
    plan: Plan,
    result: Path,
    scheduler: str | None = None,
    workers: int | None = None,
    batch_seconds: float | None = None,
    max_failures: int = 0,
    retry_failed: bool = False,
) -> Summary:
    """Compute whatever of the plan is not stored yet and write the result file.

    batch_seconds : predicted length of a batch; by default it grows with the study. An
    interrupted run keeps all finished batches and writes no result file; so does one with more
    than ``max_failures`` failed problems. With fewer, these are marked in the result.
    """
    began = time.monotonic()
    folder = store_folder(result)
    with hold(folder):
        store = Store(folder)
        store.prepare()
        clear_leftovers(result)
        failures = Failures(store, plan, max_failures)
        if retry_failed:
            store.forget_failures({task.key for _, task in failures.tasks()})
        summary = _foreseen(plan, failures)
        if summary.predicted:
            for variant in plan.variants:
                load_kernels(variant.numerics.scheme, quantities(plan.study))
        with open_client(scheduler, workers) as client, Interrupt() as interrupt:
            check_versions(client)
            summary.start = time.monotonic() - began
            summary.workers = max(1, sum(client.nthreads().values()))
            datasets = _datasets(client, failures, batch_seconds, summary, interrupt)
            if datasets:
                with summary.filing():
                    write_datasets(result, datasets)
                summary.written = True
            summary.interrupted = interrupt()
            summary.failures = failures.lines()
    summary.wall = time.monotonic() - began
    return summary


def store_folder(result: Path) -> Path:
    """Return the folder of finished batches beside a result file; studies share it."""
    return result.parent / "store"


def _foreseen(plan: Plan, settled: Failures) -> Summary:
    missing = [(batch.seconds, len(batch.tasks) * batch.blocks) for batch in batches(plan, settled)]
    predicted = sum(seconds for seconds, _ in missing)
    return Summary(reused=plan.records - sum(n for _, n in missing), predicted=predicted)


def _datasets(
    client: Client,
    failures: Failures,
    batch_seconds: float | None,
    summary: Summary,
    interrupt: Interrupt,
) -> dict[str, xr.Dataset]:
    """Compute what is missing, then collect; once more where shards turn out damaged."""
    store, plan = failures.store, failures.plan

    def stop() -> bool:
        return interrupt() or failures.too_many()

    for _ in range(ATTEMPTS):
        predicted = _foreseen(plan, failures).predicted
        target = batch_seconds or batch_target(predicted)
        work = batches(plan, failures, target)
        run = partial(run_batch, expected=versions())
        with Reporter("computing", predicted) as reporter, Shelf(store, target) as shelf:
            for batch, done in stream(client, run, work, stop, failures):
                with summary.filing():
                    shelf.add(batch, done)
                summary.count(batch, done)
                reporter.advance(batch.seconds)
        try:
            return {} if stop() else collect(client, store, plan, summary, interrupt)
        except DamagedShard:
            continue
    raise UserError(f"{store.folder}: shards were damaged {ATTEMPTS} times; is the disk sound?")
