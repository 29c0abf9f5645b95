"""Event loop in a thread of its own, which Ctrl-C does not reach."""

import asyncio
import concurrent.futures
import contextlib
import signal
import threading
from collections.abc import Iterator
from multiprocessing import resource_tracker

from tornado.ioloop import IOLoop

JOIN_SECONDS = 2.0  # timeout for the end of the thread


@contextlib.contextmanager
def loop_without_ctrl_c() -> Iterator[IOLoop]:
    """Yield the event loop of a thread that blocks SIGINT.

    Ctrl-C is sent to the whole process group. Workers started from the thread inherit the block.
    """
    started: concurrent.futures.Future[IOLoop] = concurrent.futures.Future()
    finished = asyncio.Event()

    async def until_finished() -> None:
        started.set_result(IOLoop.current())
        await finished.wait()

    def run() -> None:
        signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
        asyncio.run(until_finished())

    resource_tracker.ensure_running()  # a later start would unblock the signal in that thread
    thread = threading.Thread(target=run, name="IO loop", daemon=True)
    thread.start()
    loop = started.result()  # not dask's LoopRunner: it runs on if a client does not connect
    try:
        yield loop
    finally:
        loop.add_callback(finished.set)
        thread.join(JOIN_SECONDS)
