"""Stream items through the cluster: a bounded window, refilled in bulk, gathered in batches."""

from collections.abc import Callable, Iterable, Iterator
from itertools import islice
from typing import Any

from distributed import Client, as_completed
from distributed.client import FutureCancelledError

from workflow.errors import UserError

Stop = Callable[[], bool]


def stream(
    client: Client, function: Callable, items: Iterable[Any], stop: Stop = lambda: False
) -> Iterator[tuple[Any, Any]]:
    """Yield (item, function(item)) as they finish; once stop() is true, only what is running.

    At most a few items per worker thread are in flight, so memory does not grow with the study.
    Raises UserError when the scheduler is lost.
    """
    source = iter(items)
    window = max(4 * sum(client.nthreads().values()), 8)
    pending: dict[str, Any] = {}

    def submit(count: int) -> list:
        fresh = list(islice(source, count))
        futures = client.map(function, fresh, pure=False)
        pending.update((f.key, item) for f, item in zip(futures, fresh, strict=True))
        return futures

    running = as_completed(submit(window))
    for finished in running.batches():
        kept = [future for future in finished if future.key in pending]
        if any(future.status in ("cancelled", "lost") for future in kept):
            raise UserError("the scheduler was lost; run again to resume")
        try:
            results = client.gather(kept)
        except FutureCancelledError as error:
            raise UserError("the scheduler was lost; run again to resume") from error
        done = [(pending.pop(f.key), r) for f, r in zip(kept, results, strict=True)]
        count = len(done)
        del finished, kept, results
        if not stop():
            running.update(submit(count))
        yield from done
