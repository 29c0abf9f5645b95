"""Stream items through the cluster: a bounded window, refilled in bulk, gathered in batches."""

from collections.abc import Callable, Iterable, Iterator
from itertools import islice
from typing import Any

from distributed import Client, Future, as_completed
from distributed.client import FutureCancelledError

from workflow.errors import UserError

Stop = Callable[[], bool]
LOST = "the scheduler was lost; run again to resume"


def stream(
    client: Client, function: Callable, items: Iterable[Any], stop: Stop = lambda: False
) -> Iterator[tuple[Any, Any]]:
    """Yield (item, function(item)) as they finish; once stop() is true, only what is running.

    At most a few items per worker thread are in flight, so memory does not grow with the study.
    Raises UserError when the scheduler is lost.
    """
    source = iter(items)
    window = max(4 * sum(client.nthreads().values()), 8)
    pending: dict[str, tuple[Future, Any]] = {}

    def submit(count: int) -> list[Future]:
        fresh = list(islice(source, count))
        futures = client.map(function, fresh, pure=False)
        pending.update((f.key, (f, item)) for f, item in zip(futures, fresh, strict=True))
        return futures

    running = as_completed(submit(window))
    for finished in running.batches():
        kept = [future for future in finished if future.key in pending]
        results = _gather(client, kept)
        done = [(pending.pop(f.key)[1], r) for f, r in zip(kept, results, strict=True)]
        count = len(done)
        del finished, kept, results
        if not stop():
            running.update(submit(count))
        else:
            _shed(client, pending)
        yield from done


def _gather(client: Client, futures: list[Future]) -> list[Any]:
    if any(future.status in ("cancelled", "lost") for future in futures):
        raise UserError(LOST)
    try:
        return client.gather(futures)
    except (FutureCancelledError, OSError) as error:
        raise UserError(LOST) from error


def _shed(client: Client, pending: dict[str, tuple[Future, Any]]) -> None:
    """Take back what no worker has yet, so that an interrupted run ends soon."""
    try:
        begun = {key for keys in client.processing().values() for key in keys}
        waiting = [future for key, (future, _) in pending.items() if key not in begun]
        for future in waiting:
            del pending[future.key]
        client.cancel(waiting)
    except OSError as error:
        raise UserError(LOST) from error
