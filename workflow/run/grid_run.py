"""Run a plan: compute the missing records, store them, reduce them and write the result."""

import time
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ...kernels.compile import cache
from .. import result as results
from ..ground import UserError
from ..plan import (
    JACKKNIFE_GROUPS,
    Missing,
    Plan,
    batch_target,
    cut,
    missing_work,
    total_records,
    total_seconds,
)
from ..simulate import Batch, BatchResult, Record, load_kernels
from ..store import DamagedShard, Store, WriteBuffer, enter_result, store_folder
from ..study import LOCAL
from ..system import (
    DiskRetry,
    Interrupt,
    Maker,
    Watch,
    check_place,
    clear_leftovers,
    hold,
    import_dask,
    report_compilation,
    require_memory,
)
from .blame import Blame
from .collect import Collector, Rounds
from .failures import Failures
from .graph import FitNode
from .measured_rates import MeasuredRates
from .run_progress import Progress
from .status import (
    Status,
    StatusWriter,
    check_owner,
    status_file,
    study_digest,
    study_source,
)
from .store_key import KEY_ATTRIBUTE, is_unchanged, result_key
from .stream import Stream
from .summary import Summary
from .workers import RunOptions, fit_seconds, open_pool

if TYPE_CHECKING:
    from ..result import Groups


LLVM_BYTES = 2**26  # memory without which LLVM ends the process while it loads kernels
ATTEMPTS = 3  # at collecting a result if shards are found damaged


def run_plan(plan: Plan, result: Path, how: RunOptions) -> Summary:
    """Compute the missing records of a plan, store them, and write the result file.

    A run that is interrupted, or in which more than ``how.max_failures`` problems fail, keeps all
    finished batches but writes no result file. Otherwise failed problems are marked in the result.
    """
    import_dask()
    began = time.monotonic()
    announcing = report_compilation("the kernels needed", "10 to 60 s", cache.WAITING_EVENT)
    with hold(store_folder(result), without=how.no_lock), announcing:
        run = _Run(plan, result, how)
        if not run.is_done():
            run.load_kernels()
            with run.interrupt, open_pool(how, run.seconds(), run.watch) as pool:
                run.summary.start = time.monotonic() - began
                run.finish(pool)
    run.summary.wall = time.monotonic() - began
    return run.summary


class _Run:
    def __init__(self, plan: Plan, result: Path, how: RunOptions) -> None:
        self.plan, self.result, self.how = plan, result, how
        self.interrupt = Interrupt()
        self.retry = DiskRetry(how.cluster.patience, self.interrupt)
        for path in (result, status_file(result)):
            clear_leftovers(path)
        check_place(result)
        check_owner(plan.study, result)
        self.store = store = Store(store_folder(result), self.retry)
        store.prepare()
        self.makers = store.index.makers_of(plan.expected)
        require_one(self.makers, how.one_kind)
        self.failures = Failures(store, plan, how.max_failures)
        if how.retry_failed:
            store.forget_failures({task.key for _, task in self.failures.tasks()})
        self.rates, self.blame = MeasuredRates(plan), Blame()
        self.watch = Watch(self._stops, how.cluster.patience)
        name = study_digest(plan.study)
        store.begin(name)
        self.missing = missing_work(plan, self.failures)
        done, left = self._extent(self.missing)
        self.summary = Summary(reused=done, predicted=left)
        status = Status(name, plan.records, done, left, len(self.failures.tasks()))
        status.source = study_source(plan.study)
        self.status = StatusWriter(result, store.folder, status, self._extent)
        self.progress = Progress(self.summary, status, self.rates, self.failures)

    def is_done(self) -> bool:
        """Return whether the result exists and is up to date; if so, complete the summary."""
        if not is_unchanged(self.plan, self.store, self.failures, self.result, self.missing):
            return False
        self.summary.written = self.summary.unchanged = True
        self.summary.read_estimates(self.plan, self.result)
        self.summary.failures = self.failures.lines()
        self.status.end("finished")
        return True

    def seconds(self) -> float:
        """Return the predicted core-seconds of the missing records and of all fits."""
        groups = (min(blocks, JACKKNIFE_GROUPS) for blocks in self.plan.expected.values())
        return total_seconds(self.missing) + sum(fit_seconds(self.plan, count) for count in groups)

    def load_kernels(self) -> None:
        """Load or compile the required kernels once for all processes of this machine."""
        if self.missing and self.how.cluster.where == LOCAL:  # remote workers compile their own
            require_memory(LLVM_BYTES)
            for variant in self.plan.variants:
                load_kernels(variant.lines.body, variant.numerics.scheme, variant.quantities)

    def finish(self, pool: Any) -> None:
        """Compute and collect, then write the result; always record the outcome in the status."""
        state = "ended early"
        try:
            with self.watch.telling(self._look):
                datasets = self._datasets(pool)
            if datasets:
                with self.summary.filing():
                    self.retry(partial(results.write_datasets, self.result, datasets))
                    self.retry(partial(enter_result, self.result))
                self.summary.written = True
                self.summary.read_estimates(self.plan, self.result)
            state = "finished" if datasets else "interrupted" if self.interrupt() else "stopped"
        finally:
            self.summary.interrupted = self.interrupt() and not self.summary.written
            self.summary.failures = self.failures.lines()
            self.status.end(state)

    def _datasets(self, pool: Any) -> "Groups":
        """Compute and fit in rounds, then collect; begin again if shards are damaged."""
        collector = Collector(self.plan, self.store)
        missing = self.missing if self.plan.first == self.plan.expected else None
        for _ in range(ATTEMPTS):
            rounds = Rounds(self.plan)
            while self._compute(pool, collector, rounds.blocks, missing):
                missing = None
                if not rounds.advance(collector):
                    return self._marked(collector.datasets(rounds.blocks), rounds.blocks)
            if self._stops():
                return {}
            missing = None
        raise UserError(
            f"{self.store.folder}: shards were damaged {ATTEMPTS} times; is the disk sound?"
        )

    def _marked(self, datasets: "Groups", blocks: dict[str, int]) -> "Groups":
        """Return the datasets with the record makers and the result key as attributes."""
        sound = {key: count for key, count in blocks.items() if key not in self.store.failed}
        makers = self.store.index.makers_of(sound)
        require_one(makers, self.how.one_kind)
        attributes = results.maker_attributes(makers) | {
            KEY_ATTRIBUTE: result_key(self.plan, self.store, blocks)
        }
        return {label: data.assign_attrs(attributes) for label, data in datasets.items()}

    def _compute(
        self,
        pool: Any,
        collector: Collector,
        blocks: dict[str, int],
        missing: list[Missing] | None,
    ) -> bool:
        """Compute and store what is missing, and fit all tasks from ``blocks`` of each.

        missing : known missing records. Returns whether all is done: there was no stop, and no
        stored record turned out damaged.
        """
        if missing is None:
            missing = missing_work(self.plan, self.failures, blocks)
        target = self.how.batch_seconds or batch_target(total_seconds(missing))
        target = min(target, self.how.cluster.longest_batch)
        pieces = cut(missing, target)
        with WriteBuffer(self.store, target) as buffer:
            graph = collector.graph(blocks, partial(self._read, buffer))
            nodes = graph.nodes(pieces, target, self.rates.rate)

            def look(threads: int, _: int) -> None:
                self.progress.report_workers(threads)
                buffer.flush_when_due()

            with self.progress.begin(pieces, graph), self.watch.telling(look):
                for node, value in Stream(pool, nodes, self.watch, self.failures, self.blame):
                    if isinstance(node, FitNode):
                        collector.enter(node, value[0])
                        self.progress.fitted(node, value[1])
                    else:
                        self._store(buffer, node.item, value)
        return not (self._stops() or graph.damaged)

    def _store(self, buffer: WriteBuffer, batch: Batch, done: BatchResult) -> None:
        """Store and count a finished batch. Raises UserError if its maker is another one."""
        self.makers.add(done.maker)
        require_one(self.makers, self.how.one_kind)
        with self.summary.filing():
            buffer.add(batch, done)
        self.progress.computed(batch, done)

    def _read(
        self, buffer: WriteBuffer, records: list[Record], width: int
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return scalars and curves of finished records. Raises DamagedShard."""
        with self.summary.filing():
            if not all(record in self.store for record in records):
                buffer.flush()
                if not all(record in self.store for record in records):
                    raise DamagedShard  # its damage was found earlier, and its records were dropped
            return self.store.read(records, width)

    def _extent(self, missing: list[Missing] | None = None) -> tuple[int, float]:
        """Return the number of settled records, and the predicted core-seconds of the others."""
        missing_records = missing_work(self.plan, self.failures) if missing is None else missing
        return self.plan.records - total_records(missing_records), total_seconds(missing_records)

    def _stops(self) -> bool:
        return self.interrupt() or self.failures.too_many()

    def _look(self, threads: int, in_flight: int) -> None:
        """Record the number of workers, and write the status if it is due."""
        self.summary.workers = max(self.summary.workers, threads)
        self.status.write(threads, min(threads, in_flight))


def require_one(makers: set[Maker], required: bool) -> None:
    """Raise UserError if records have several makers and ``required`` is true."""
    if required and len(makers) > 1:
        kinds = "; ".join(f"{maker.versions} on {maker.processor}" for maker in sorted(makers))
        raise UserError(
            f"--one-kind: records of {len(makers)} kinds would be mixed: {kinds}; compute in "
            "another folder (--out), or leave the option out"
        )
