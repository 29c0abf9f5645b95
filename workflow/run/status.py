"""Progress of a study, written to the folder of its result during a run.

The status file records an offset in the journal of the store. A reader counts only later entries,
so that its time does not grow with the number of points.
"""

import hashlib
import json
import os
import socket
import sys
import time
from collections.abc import Callable
from dataclasses import asdict, dataclass
from datetime import datetime
from pathlib import Path
from typing import Any

from ..ground import UserError, open_plain
from ..plan import make_plan, missing_work, total_records, total_seconds
from ..result import differing_settings, peek
from ..simulate import CODE_HASH
from ..store import Store, is_as_written, journal
from ..study import AnyStudy, Study
from ..system import holder, unreadable, write_durably
from .failures import Failures

WRITE_SECONDS = 5.0  # shortest time between two writes
MAX_STATUS_BYTES = 2**16  # read from a status file


@dataclass
class Status:
    """Progress of a study."""

    study: str  # digest of the study, see study_digest
    total: int  # number of records, one per problem and block
    done: int  # number of settled records: stored, or of failed problems
    left: float  # remaining core-seconds as predicted by the plan
    failed: int = 0  # number of failed problems
    offset: int = 0  # bytes of the journal counted so far
    state: str = "not running"
    running: int = 0  # number of running batches
    workers: int = 0
    updated: str = ""
    host: str = ""
    pid: int = 0
    source: str = ""  # of the study, see study_source
    rate: float = 1.0  # ratio of corrected to predicted core time of the remaining work

    @property
    def seconds_left(self) -> float:
        """Remaining core-seconds, corrected by the rate of the finished batches."""
        return self.left * self.rate

    def advance(self, folder: Path) -> bool:
        """Count new entries of the journal; return False if all records must be counted again."""
        if journal.size(folder) < self.offset:
            return False
        complete = True
        for entry, offset in journal.entries(folder, self.offset):
            self.offset = offset
            if "shard" in entry:
                self.done += entry["records"]
                left = self.left - entry.get("predicted", 0.0)
                self.left = max(0.0, left) if self.done < self.total else 0.0
            elif "failed" in entry:
                self.failed += 1
                complete = False  # the entry does not state which of its records are stored
            elif entry.keys() & {"run", "retry", "dropped"}:  # another run, or a dropped shard
                return False
        return complete

    def runs(self, by: str | None) -> bool:
        """Return whether the process ``by`` runs this study."""
        return by is not None and by.startswith(f"process {self.pid} on {self.host} since")

    @property
    def ended(self) -> str:
        """Outcome of the last run, provided that no run is active."""
        return "was killed" if self.state == "running" else self.state

    def lines(self, result: Path, by: str | None) -> list[str]:
        """Return the output of the command. by : holder of the folder's lock, or None."""
        total = max(self.total, self.done)  # rounds may need more records than predicted
        alive = self.runs(by)
        running, workers = (self.running, self.workers) if alive else (0, 0)
        source = "predicted" if self.rate == 1.0 else "by the rate of the finished batches"
        lines = [
            f"done        {self.done} of {total} records (problem x block)",
            f"running     {running} batches on {workers} workers",
            f"waiting     {total - self.done} records",
            f"failed      {self.failed} problems",
            f"remaining   {self.seconds_left / 3600.0:.3g} core-hours, {source}",
        ]
        if alive:
            lines.append(f"run         {self.state}, by {by}; updated {self.updated}")
        elif by is not None:
            lines.append(f"run         another study, by {by}")
        else:
            lines.append(f"run         {self.ended}{', ' + self.updated if self.updated else ''}")
        return [*lines, result_line(result)]


def result_line(result: Path) -> str:
    """Return the line with the path of the result."""
    return f"result      {result}{'' if result.is_file() else ' (not written yet)'}"


def study_digest(study: Study) -> str:
    """Return a digest of the settings of a study and of the numerical code."""
    return hashlib.sha256((CODE_HASH + study.text).encode()).hexdigest()[:16]


def study_source(study: AnyStudy) -> str:
    """Return the folder of a study and its name."""
    return str(study.folder.resolve() / study.name)


def check_owner(study: AnyStudy, result: Path) -> None:
    """Raise UserError if a run of this study would replace the result of another study.

    Another study has another title or grid, unless the status file states that it was run from the
    same file, whose title and grid may change.
    """
    if not result.is_file() or (not is_as_written(result) and unreadable([result])):
        return
    earlier = peek(result)
    if earlier is None or _written(result).get("source") == study_source(study):
        return
    settings = differing_settings(study, earlier.attributes)
    if any(key == "study.title" or key.startswith("grid.") for key in settings):
        raise UserError(
            f"{result}: holds the result of another study, {earlier.attributes['title']!r:.80}; "
            "choose another folder with --out, or remove that file"
        )


def status_file(result: Path) -> Path:
    """Return the path of the status file that belongs to a result."""
    return result.with_suffix(".status.json")


class StatusWriter:
    """Writer that replaces the status file of a run every few seconds."""

    def __init__(
        self, result: Path, folder: Path, status: Status, extent: Callable[[], tuple[int, float]]
    ) -> None:
        """Create the writer. extent : returns settled records and core-seconds of the others."""
        self.path, self.folder = status_file(result), folder
        self.status, self.extent = status, extent
        self.status.pid, self.status.host = os.getpid(), socket.gethostname()
        self.status.offset = journal.size(folder)
        self.written = -WRITE_SECONDS
        self.complaint = ""  # last warning, which is not repeated

    def write(self, workers: int, running: int) -> None:
        """Write the status if it is due."""
        if time.monotonic() - self.written >= WRITE_SECONDS:
            self.end("running", workers, running)

    def end(self, state: str, workers: int = 0, running: int = 0) -> None:
        """Write the status with this state of the run; warn if the disk refuses."""
        self.written = time.monotonic()
        try:
            self._bring_up_to_date(state, workers, running)
            write_durably(self.path, json.dumps(asdict(self.status), indent=1).encode())
        except UserError as error:
            if str(error) != self.complaint:
                print(f"warning: {error}; the run continues", file=sys.stderr)
            self.complaint = str(error)

    def _bring_up_to_date(self, state: str, workers: int, running: int) -> None:
        if not self.status.advance(self.folder):
            self.status.done, self.status.left = self.extent()
            self.status.offset = journal.size(self.folder)
        self.status.state, self.status.workers, self.status.running = state, workers, running
        self.status.updated = datetime.now().astimezone().isoformat(" ", "seconds")


def _written(result: Path) -> dict[str, Any]:
    """Return the content of the status file that belongs to a result, empty if it has none."""
    try:
        with open_plain(status_file(result)) as file:
            content = json.loads(file.read(MAX_STATUS_BYTES))
    except (OSError, ValueError, RecursionError):
        return {}
    return content if isinstance(content, dict) else {}


def read_status(study: Study, result: Path, folder: Path) -> Status:
    """Return the progress of a study from its status file, or by counting all records."""
    try:
        status = Status(**_written(result))
        types = Status.__annotations__.items()
        sound = all(isinstance(getattr(status, name), (of, int)) for name, of in types)
        if sound and status.study == study_digest(study) and status.advance(folder):
            return status
    except (OSError, TypeError):
        pass
    return _counted(study, folder)


def _counted(study: Study, folder: Path) -> Status:
    """Return the status of a study by counting its settled records."""
    plan = make_plan(study)
    failures = Failures(Store(folder), plan, 0)
    missing = missing_work(plan, failures)
    done, failed = plan.records - total_records(missing), len(failures.tasks())
    return Status(study_digest(study), plan.records, done, total_seconds(missing), failed)


def status_lines(study: Study, result: Path, folder: Path) -> tuple[list[str], dict[str, object]]:
    """Return the output of the command ``status``, as lines and as data."""
    status, by = read_status(study, result, folder), holder(folder)
    lines = status.lines(result, by)
    alive = status.runs(by)
    facts = {
        "written": result.is_file(),
        "records": max(status.total, status.done),
        "records_done": status.done,
        "problems_failed": status.failed,
        "predicted_core_seconds_left": status.seconds_left,
        "state": status.state if alive else "another study runs" if by else status.ended,
        "batches_running": status.running if alive else 0,
        "workers": status.workers if alive else 0,
        "run_by": by,
        "updated": status.updated,
    }
    return lines, facts
