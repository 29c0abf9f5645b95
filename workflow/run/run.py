"""Run a plan: compute what is missing, store it as it finishes, reduce, write the result."""

import time
from collections.abc import Callable
from functools import partial
from operator import attrgetter
from pathlib import Path
from typing import NamedTuple

from distributed import Client

from workflow.cluster import Watch, check_versions, open_client, own_versions, run_batch, stream
from workflow.errors import UserError
from workflow.plan import (
    Missing,
    Plan,
    batch_target,
    cut,
    make_batches,
    missing_work,
    total_records,
    total_seconds,
)
from workflow.result import Groups, made_by, write_datasets
from workflow.run.collect import Collector
from workflow.run.failures import Failures
from workflow.run.makers import require_one
from workflow.run.rounds import Rounds
from workflow.run.status import Status, StatusWriter, identity, status_file
from workflow.run.summary import Summary, accuracy_lines
from workflow.simulate import BatchResult, load_kernels
from workflow.store import DamagedShard, Shelf, Store, store_folder
from workflow.study import HERE, LOCAL, Cluster
from workflow.system import (
    Interrupt,
    Patience,
    Reporter,
    check_place,
    clear_leftovers,
    hold,
    package_versions,
    processor,
)

ATTEMPTS = 3  # at a result, when shards turn out damaged


class How(NamedTuple):
    """How to run a plan; no number of the result depends on it.

    batch_seconds : predicted length of a batch; by default it grows with the study.
    work : what a worker does with a batch; a test may let it do something else.
    """

    cluster: Cluster = HERE
    workers: int | None = None  # processes of this machine; None: one per core
    dashboard: bool = False
    batch_seconds: float | None = None
    max_failures: int = 0
    retry_failed: bool = False
    one_kind: bool = False  # refuse to mix records of several makers
    no_lock: bool = False  # go on where the file system has no locks
    work: Callable[..., BatchResult] = run_batch


def run_plan(plan: Plan, result: Path, how: How) -> Summary:
    """Compute whatever of the plan is not stored yet and write the result file.

    An interrupted run keeps all finished batches and writes no result file; so does one with
    more than ``how.max_failures`` failed problems. With fewer, these are marked in the result.
    """
    began = time.monotonic()
    folder = store_folder(result)
    with hold(folder, without=how.no_lock):
        run = _Run(plan, result, how)
        if run.missing and how.cluster.where == LOCAL:  # workers elsewhere compile for themselves
            for variant in plan.variants:
                load_kernels(variant.numerics.scheme, plan.asked)
        where = (how.cluster, how.workers, how.dashboard, run.watch)
        with run.interrupt, open_client(*where) as client:
            check_versions(client, run.watch)
            run.summary.start = time.monotonic() - began
            run.finish(client)
    run.summary.wall = time.monotonic() - began
    return run.summary


class _Run:
    def __init__(self, plan: Plan, result: Path, how: How) -> None:
        self.plan, self.result, self.how = plan, result, how
        self.interrupt = Interrupt()
        self.patience = Patience(how.cluster.patience, self.interrupt)
        for path in (result, status_file(result)):
            clear_leftovers(path)
        check_place(result)
        self.store = store = Store(store_folder(result), self.patience)
        store.prepare()
        self.makers = store.index.makers_of(plan.expected)
        require_one(self.makers, how.one_kind)
        self.failures = Failures(store, plan, how.max_failures)
        if how.retry_failed:
            store.forget_failures({task.key for _, task in self.failures.tasks()})
        self.watch = Watch(self._stops, how.cluster.patience)
        name = identity(plan.study)
        store.begin(name, package_versions(), processor())
        self.missing = missing_work(plan, self.failures)
        done, left = self._extent(self.missing)
        self.summary = Summary(reused=done, predicted=left)
        failed = len(self.failures.tasks())
        status = Status(name, plan.records, done, left, failed)
        self.status = StatusWriter(result, store.folder, status, self._extent)

    def finish(self, client: Client) -> None:
        """Compute, collect and write; the status says how it ended, whatever happens."""
        state = "ended early"
        try:
            with self.watch.telling(self._look):
                datasets = self._datasets(client)
            if datasets:
                with self.summary.filing():
                    self.patience(partial(write_datasets, self.result, datasets))
                self.summary.written = True
                for label, dataset in datasets.items():
                    self.summary.accuracy += accuracy_lines(label, dataset)
            state = "finished" if datasets else "interrupted" if self.interrupt() else "stopped"
        finally:
            self.summary.interrupted = self.interrupt() and not self.summary.written
            self.summary.failures = self.failures.lines()
            self.status.end(state)

    def _datasets(self, client: Client) -> Groups:
        """Compute what is missing, then collect; once more where shards turn out damaged."""
        collector = Collector(client, self.store, self.plan, self.summary, self.watch)
        missing = self.missing if self.plan.first == self.plan.expected else None
        for _ in range(ATTEMPTS):
            rounds = Rounds(self.plan)
            try:
                while True:
                    if missing is None:
                        missing = missing_work(self.plan, self.failures, rounds.blocks)
                    self._compute(client, missing)
                    missing = None
                    if self._stops():
                        return {}
                    if not rounds.go_on(collector):
                        return self._marked(collector.datasets(rounds.blocks), rounds.blocks)
            except DamagedShard:
                continue
        raise UserError(
            f"{self.store.folder}: shards were damaged {ATTEMPTS} times; is the disk sound?"
        )

    def _marked(self, datasets: Groups, blocks: dict[str, int]) -> Groups:
        """Return the datasets with what computed their records."""
        sound = {key: count for key, count in blocks.items() if key not in self.store.failed}
        makers = self.store.index.makers_of(sound)
        require_one(makers, self.how.one_kind)
        return {label: data.assign_attrs(made_by(makers)) for label, data in datasets.items()}

    def _compute(self, client: Client, missing: list[Missing]) -> None:
        """Compute and store what is missing."""
        target = self.how.batch_seconds or batch_target(total_seconds(missing))
        target = min(target, self.how.cluster.longest_batch)
        pieces = cut(self.plan, missing, target)
        work = make_batches(self.plan, pieces, target)
        function = partial(self.how.work, expected=own_versions())
        reporter = Reporter("computing", total_seconds(pieces))
        with reporter, Shelf(self.store, target) as shelf:

            def look(threads: int, in_flight: int) -> None:
                del in_flight
                if threads:  # or else the watch says that there are none
                    reporter.beat(threads, self.failures.fresh)
                shelf.flush_when_due()

            with self.watch.telling(look):
                predicted = attrgetter("seconds")
                streamed = stream(client, function, work, self.watch, self.failures, predicted)
                for batch, done in streamed:
                    self.makers.add(done.maker)
                    require_one(self.makers, self.how.one_kind)
                    with self.summary.filing():
                        shelf.add(batch, done)
                    self.summary.count(batch, done)
                    reporter.advance(batch.seconds)

    def _extent(self, missing: list[Missing] | None = None) -> tuple[int, float]:
        """Return the number of records that are settled, and the predicted seconds of the rest."""
        found = missing_work(self.plan, self.failures) if missing is None else missing
        return self.plan.records - total_records(found), total_seconds(found)

    def _stops(self) -> bool:
        return self.interrupt() or self.failures.too_many()

    def _look(self, threads: int, in_flight: int) -> None:
        """Take note of the workers every second."""
        self.summary.workers = max(self.summary.workers, threads)
        self.status.write(threads, min(threads, in_flight))
