"""Calls that may never return, because whoever is asked has been stopped."""

import contextlib
import threading
from collections.abc import Callable, Collection
from typing import Any, NamedTuple, Protocol

from distributed import Client, Future, Scheduler
from distributed.client import FutureCancelledError
from distributed.scheduler import KilledWorker

from ..errors import UserError
from .watch import BEAT_SECONDS, QUIET_SECONDS, Watch

LOST = "the scheduler was lost; run again to resume"
POLL_SECONDS = 0.02
CLOSE_SECONDS = 2.0  # for a scheduler to say goodbye, or a worker process to end by itself
ROLL = "elastomer_friction_roll"  # what the scheduler is asked for


class SafeClient(Client):
    """A client that is closed where it is used, and never by Python's collection of garbage.

    That may come while dask holds the lock of its threads, and would wait for that very lock.
    """

    def start(self, **kwargs: Any) -> None:
        """Connect. Where that fails, close what has been opened, and end the thread."""
        try:
            super().start(**kwargs)
        except BaseException:
            self.end()
            self._loop_runner.stop()  # which dask leaves running where nobody answers
            raise

    def end(self) -> None:
        """Close it, whether or not its scheduler answers."""
        with contextlib.suppress(TimeoutError):
            self.close(timeout=CLOSE_SECONDS)

    def __del__(self) -> None:
        """Close nothing."""


class Clock(Protocol):
    """What tells the time: the module time, or a simulation."""

    def monotonic(self) -> float:
        """Return the time in s."""

    def sleep(self, seconds: float, /) -> None:
        """Let time pass."""


class Roll(NamedTuple):
    """What the scheduler knows of its workers, by address."""

    threads: dict[str, int]
    heard: dict[str, float]  # time of the last heartbeat (s), by the scheduler's clock
    busy: dict[str, list[str]]  # keys of what they compute
    paused: Collection[str] = ()  # who takes up nothing for now
    stranded: Collection[str] = ()  # keys of what nobody is there for who may compute it


def answer_rolls(dask_scheduler: Scheduler) -> None:
    """Let a scheduler answer roll calls; run there, once, as it logs whatever it is told to run."""

    def roll() -> Roll:
        workers = dask_scheduler.workers.values()
        return Roll(
            {worker.address: worker.nthreads for worker in workers},
            {worker.address: worker.last_seen for worker in workers},
            {worker.address: [str(task.key) for task in worker.processing] for worker in workers},
            [worker.address for worker in workers if worker not in dask_scheduler.running],
            [str(task.key) for task in dask_scheduler.unrunnable],
        )

    dask_scheduler.handlers[ROLL] = roll


def call_roll(client: Client, first: bool) -> Roll:
    """Return the roll."""
    if first:
        client.run_on_scheduler(answer_rolls)
    return Roll(*client.sync(getattr(client.scheduler, ROLL)))


class Call:
    """A call in a thread of its own, which ends with this process."""

    def __init__(self, function: Callable, *arguments: Any) -> None:
        self._function, self._arguments = function, arguments
        self._value: Any = None
        self._error: BaseException | None = None
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def wait(self, seconds: float) -> bool:
        """Wait for so long at most; return whether it has returned."""
        self._thread.join(seconds)
        return not self._thread.is_alive()

    def result(self) -> Any:
        """Return what the call has returned, or raise what it has raised."""
        if self._error is not None:
            raise self._error
        return self._value

    def _run(self) -> None:
        try:
            self._value = self._function(*self._arguments)
        except BaseException as error:
            self._error = error


def patiently(watch: Watch, lack: str, function: Callable, *arguments: Any) -> Any:
    """Return what a call returns; ``lack`` says what is missing while it does not.

    Raises UserError when the patience of the watch ends, KeyboardInterrupt when it says to stop.
    """
    call, quiet = Call(function, *arguments), 0.0
    while not call.wait(BEAT_SECONDS):
        watch.look(0, 0, lack)
        quiet = quiet + BEAT_SECONDS if watch() else 0.0
        if quiet >= QUIET_SECONDS:
            raise KeyboardInterrupt
    return call.result()


class Fetched(NamedTuple):
    """What futures that have ended came to, by key."""

    results: dict[str, tuple[str, Any]]  # (address of the worker, result)
    errors: dict[str, tuple[str, Exception]]


def erred_on(keys: list[str], dask_scheduler: Scheduler) -> dict[str, str]:
    """Return on which worker tasks have raised; run on the scheduler."""
    tasks = {key: dask_scheduler.tasks.get(key) for key in keys}
    return {key: min(task.erred_on or (), default="") for key, task in tasks.items() if task}


def fetch(client: Client, futures: list[Future]) -> Fetched:
    """Return what futures that have ended came to. Raises UserError where the scheduler is lost."""
    try:
        while True:
            failed = [future for future in futures if future.status == "error"]
            sound = [future for future in futures if future not in failed]
            if any(future.status in ("cancelled", "lost") for future in sound):
                raise UserError(LOST)
            try:
                results = client.gather(sound)
                break
            except (FutureCancelledError, OSError):
                raise
            except Exception:  # a result was lost with its worker, and failed the second time
                if all(future.status != "error" for future in sound):
                    raise
        errors = {str(future.key): future.exception() for future in failed}
        raised = [key for key, error in errors.items() if not isinstance(error, KilledWorker)]
        where = client.run_on_scheduler(erred_on, raised) if raised else {}
    except (FutureCancelledError, OSError) as error:
        raise UserError(LOST) from error
    return Fetched(
        {str(future.key): result for future, result in zip(sound, results, strict=True)},
        {key: (where.get(key, ""), error) for key, error in errors.items()},
    )


class Fetches:
    """Fetches in a thread each: one of them may ask a worker that has been stopped."""

    def __init__(self, client: Client, clock: Clock, call: Callable[..., Call]) -> None:
        self.client, self.clock, self.call = client, clock, call
        self.open: list[tuple[Call, list[str], float]] = []  # keys, when it began

    def begin(self, futures: list[Future]) -> None:
        """Begin to fetch what futures came to, if there are any."""
        if futures:
            keys = [str(future.key) for future in futures]
            fetching = self.call(fetch, self.client, futures)
            self.open.append((fetching, keys, self.clock.monotonic()))

    def done(self) -> list[Fetched]:
        """Return what has come."""
        ended = [entry for entry in self.open if entry[0].wait(0.0)]
        self.open = [entry for entry in self.open if entry not in ended]
        return [call.result() for call, _, _ in ended]

    def overdue(self, seconds: float) -> list[str]:
        """Return the keys of what has not come for so long."""
        now = self.clock.monotonic()
        return [key for _, keys, since in self.open if now - since > seconds for key in keys]

    def rest(self) -> None:
        """Let a little time pass, no more than until something has come."""
        if self.open:
            self.open[0][0].wait(POLL_SECONDS)
        else:
            self.clock.sleep(POLL_SECONDS)
