"""Summary of a run and its times, printed at its end."""

import time
from collections import defaultdict
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from .. import reduce
from .. import result as results
from ..ground import counted
from ..plan import Plan
from ..simulate import PHASES, Batch, BatchResult
from ..study import COMMON_AXES
from ..system import duration, peak_bytes
from .failures import point_in_words

if TYPE_CHECKING:
    import xarray as xr

COSTLIEST = 3  # number of costliest points shown


@dataclass
class Summary:
    """Summary of a run. Times are core-seconds of workers unless stated otherwise."""

    batches: int = 0  # number of finished batches
    reused: int = 0  # number of records already settled in the store
    predicted: float = 0.0  # time of all missing records
    predicted_done: float = 0.0  # time of the finished batches
    used: float = 0.0  # measured time of the finished batches
    start: float = 0.0  # s, wall time until the kernels are compiled and the workers started
    wall: float = 0.0  # s, wall time of the whole run
    workers: int = 1  # largest number of worker threads
    files: float = 0.0  # s, wall time of reading and writing in the driver
    peak: int = 0  # bytes, peak memory of the largest worker
    interrupted: bool = False
    written: bool = False  # whether the result file exists at the end
    unchanged: bool = False  # whether the result file was up to date before the run
    failures: list[str] = field(default_factory=list)  # lines of a table
    # Table of a small result, and lines on the accuracy that each variant reached:
    estimates: list[str] = field(default_factory=list)
    phases: dict[str, float] = field(default_factory=lambda: defaultdict(float))  # time by phase
    tasks: dict[str, float] = field(default_factory=lambda: defaultdict(float))  # time by task key

    def count(self, batch: Batch, done: BatchResult) -> None:
        """Add a finished batch."""
        self.batches += 1
        self.predicted_done += batch.seconds
        self.used += done.seconds
        self.peak = max(self.peak, done.peak)
        phases = done.spent.sum(axis=0)
        for phase, seconds in zip(PHASES, phases, strict=True):
            self.phases[phase] += float(seconds)
        self.phases["calls"] += done.seconds - float(phases.sum())
        for task, seconds in zip(batch.tasks, done.spent.sum(axis=1), strict=True):
            self.tasks[task.key] += float(seconds)

    @contextmanager
    def filing(self) -> Iterator[None]:
        """Add the wall time of this block to ``files``."""
        began = time.monotonic()
        yield
        self.files += time.monotonic() - began

    def read_estimates(self, plan: Plan, result: Path) -> None:
        """Read the table of a small result, and lines on the accuracy if one is requested."""
        with ExitStack() as stack:
            for label, dataset in results.open_result(plan.study, result, stack).items():
                if not label:
                    self.estimates += results.short_table(dataset)
                self.estimates += accuracy_lines(label, dataset)

    def lines(self, plan: Plan) -> list[str]:
        """Return the lines of the summary."""
        study = plan.study
        factor = f" (factor {self.used / self.predicted_done:.2f})" if self.predicted_done else ""
        whole = "" if self.written else f", of {duration(self.predicted)} for the whole"
        rows = [
            f"{self.batches} batches computed in {duration(self.wall)}, {self.reused} records "
            f"reused; {duration(self.used)} of core time used, {duration(self.predicted_done)} "
            f"predicted for them{factor}{whole}"
        ]
        rows += [f"{title}: {description}" for title, description in study.descriptions]
        if self.unchanged:
            rows.append("the result is there already, of the same study, program and records")
        if self.batches:
            rows.append(f"body: {study.body_choice}")
            if study.rounding and not any(variant.goals for variant in plan.variants):
                rows.append(f"realizations: {study.realizations} each{study.rounding}")
            rows += [
                self._where(),
                self._memory(plan),
                *self._costliest(plan),
            ]
        return rows + self.estimates

    def _where(self) -> str:
        """Return a line with the shares of the workers' core time, counted from their start."""
        whole = max((self.wall - self.start) * self.workers, 1e-9)
        shares = {**self.phases, "scheduling, waiting": whole - sum(self.phases.values())}
        shown = ", ".join(f"{name} {max(part, 0.0) / whole:.0%}" for name, part in shares.items())
        return (
            f"start {self.start:.0f} s; then {counted(self.workers, 'worker')}: {shown}; "
            f"files {self.files:.1f} s in the driver"
        )

    def _memory(self, plan: Plan) -> str:
        return (
            f"memory: {self.peak / 2**20:.0f} MiB in the largest worker, "
            f"{plan.predicted_worker_bytes() / 2**20:.0f} MiB predicted; "
            f"{peak_bytes() / 2**20:.0f} MiB here, "
            f"{plan.predicted_driver_bytes() / 2**20:.0f} MiB predicted"
        )

    def _costliest(self, plan: Plan) -> list[str]:
        tasks = {task.key: (task, v.label) for v in plan.variants for task in v.tasks}
        lines = []
        for key in sorted(self.tasks, key=lambda key: -self.tasks[key])[:COSTLIEST]:
            task, label = tasks[key]
            point = plan.first_point(task)
            place = point_in_words({a: v for a, v in point.items() if len(plan.study.grid[a]) > 1})
            share = self.tasks[key] / self.used
            words = place, f"m={task.steps_per_spacing}", label
            lines.append(f"  {share:4.0%}  {' '.join(filter(None, words))}")
        return ["points that cost most:", *lines]


def accuracy_lines(label: str, dataset: "xr.Dataset") -> list[str]:
    """Return lines with the number of points that meet the accuracy, and the worst point."""
    if "accuracy_status" not in dataset:
        return []
    status = dataset.accuracy_status.values
    wanted = dataset.attrs["accuracy"]
    met, partly = np.sum(status > reduce.MISSED), np.sum(status == reduce.MET_WHERE_DEFINED)
    line = (
        f"accuracy {wanted:.3g} {label}: met at {met} of {status.size} points"
        f" ({partly} of them have no rate, or no jump, to be known)"
    )
    missed = dataset.accuracy_reached.where(dataset.accuracy_status == reduce.MISSED)
    if not (status == reduce.MISSED).any():
        return [line]
    worst = missed.argmax(...)
    index = dataset.isel(worst)
    where = " ".join(f"{axis}={float(index[axis]):.4g}" for axis in COMMON_AXES)
    return [line, f"  worst: {float(index.accuracy_reached):.2g} at {where}"]
