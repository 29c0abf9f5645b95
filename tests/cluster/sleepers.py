"""Run a scheduler, or many single-threaded workers of one, in this process until it is killed."""

import asyncio
import sys

from distributed import Scheduler, Worker

AT_ONCE = 25  # workers that connect at a time


async def scheduler() -> None:
    """Print the address and serve."""
    async with Scheduler(host="127.0.0.1", port=0, dashboard=False, dashboard_address=":0") as one:
        print(one.address, flush=True)
        await one.finished()


async def workers(address: str, number: str) -> None:
    """Print a line once all are connected, and work."""

    async def connected(worker: Worker) -> None:
        await worker

    some = [Worker(address, nthreads=1, memory_limit=0) for _ in range(int(number))]
    for first in range(0, len(some), AT_ONCE):
        await asyncio.gather(*map(connected, some[first : first + AT_ONCE]))
    print("ready", flush=True)
    await asyncio.gather(*(worker.finished() for worker in some))


if __name__ == "__main__":
    asyncio.run({"scheduler": scheduler, "workers": workers}[sys.argv[1]](*sys.argv[2:]))
