"""Run a plan: compute what is missing, store it as it finishes, reduce, write the result."""

import time
from pathlib import Path

import xarray as xr
from distributed import Client

from workflow.batch import block_means, load_kernels
from workflow.cluster import open_client
from workflow.collect import collect
from workflow.dataset import write_datasets
from workflow.durable import clear_leftovers
from workflow.errors import UserError
from workflow.flow import stream
from workflow.interrupt import Interrupt
from workflow.lock import hold
from workflow.plan import Plan, batch_target, batches, quantities
from workflow.progress import Reporter
from workflow.shelf import Shelf
from workflow.store import DamagedShard, Store
from workflow.summary import Summary

ATTEMPTS = 3  # at a result, when shards turn out damaged


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
    folder = store_folder(result)
    with hold(folder):
        store = Store(folder)
        store.prepare()
        clear_leftovers(result)
        summary = _foreseen(plan, store)
        if summary.predicted:
            for variant in plan.variants:
                load_kernels(variant.numerics.scheme, quantities(plan.study))
        with open_client(scheduler, workers) as client, Interrupt() as interrupt:
            summary.start = time.monotonic() - began
            summary.workers = max(1, sum(client.nthreads().values()))
            datasets = _datasets(client, store, plan, batch_seconds, summary, interrupt)
            if datasets:
                with summary.filing():
                    write_datasets(result, datasets)
            summary.interrupted = interrupt()
    summary.wall = time.monotonic() - began
    return summary


def store_folder(result: Path) -> Path:
    """Return the folder of finished batches beside a result file; studies share it."""
    return result.parent / "store"


def _foreseen(plan: Plan, store: Store) -> Summary:
    missing = [(batch.seconds, len(batch.tasks) * batch.blocks) for batch in batches(plan, store)]
    predicted = sum(seconds for seconds, _ in missing)
    return Summary(reused=plan.records - sum(n for _, n in missing), predicted=predicted)


def _datasets(
    client: Client,
    store: Store,
    plan: Plan,
    batch_seconds: float | None,
    summary: Summary,
    interrupt: Interrupt,
) -> dict[str, xr.Dataset]:
    """Compute what is missing, then collect; once more where shards turn out damaged."""
    for _ in range(ATTEMPTS):
        predicted = _foreseen(plan, store).predicted
        target = batch_seconds or batch_target(predicted)
        with Reporter("computing", predicted) as reporter, Shelf(store, target) as shelf:
            for batch, done in stream(client, block_means, batches(plan, store, target), interrupt):
                with summary.filing():
                    shelf.add(batch, done)
                summary.count(batch, done)
                reporter.advance(batch.seconds)
        try:
            return {} if interrupt() else collect(client, store, plan, summary, interrupt)
        except DamagedShard:
            continue
    raise UserError(f"{store.folder}: shards were damaged {ATTEMPTS} times; is the disk sound?")
