"""Processes of a measurement: a real scheduler, many sleeping workers, and scripts on their own.

A worker here is distributed.Worker with one thread, many of them in one process: they sleep
through their tasks, so that two cores are enough for hundreds.
"""

import json
import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any, NamedTuple

import psutil

from workflow.study.scripts import load_script

HERE = Path(__file__).parent
QUIET = {  # what distributed does beside the tasks would cost more than many sleeping workers
    "DASK_LOGGING__DISTRIBUTED": "error",
    "DASK_DISTRIBUTED__WORKER__PROFILE__ENABLED": "False",
    "DASK_DISTRIBUTED__ADMIN__SYSTEM_MONITOR__INTERVAL": "60s",
    "DASK_DISTRIBUTED__ADMIN__SYSTEM_MONITOR__GIL__ENABLED": "False",
    "DASK_DISTRIBUTED__ADMIN__TICK__INTERVAL": "10s",
    "DASK_DISTRIBUTED__ADMIN__TICK__CYCLE": "60s",
    "DASK_DISTRIBUTED__SCHEDULER__WORKER_SATURATION": "1.0",  # as workflow.run.clusters sets it
}


class Started(NamedTuple):
    """A process that has said its first line."""

    line: str
    process: psutil.Process

    def cpu(self) -> float:
        """Return the CPU time it has used (s)."""
        times = self.process.cpu_times()
        return times.user + times.system


@contextmanager
def sleeping_cluster(workers: int) -> Iterator[tuple[Started, Started]]:
    """Yield the processes of a scheduler, whose line is its address, and of its workers."""
    with ExitStack() as stack:
        scheduler = stack.enter_context(_started("scheduler"))
        address = scheduler.line
        yield scheduler, stack.enter_context(_started("workers", address, str(workers)))


@contextmanager
def _started(*words: str) -> Iterator[Started]:
    process = subprocess.Popen(
        [sys.executable, str(HERE / "sleepers.py"), *words],
        env={**os.environ, **QUIET},
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,  # connections that end with the measurement
        text=True,
    )
    try:
        line = process.stdout.readline().strip()
        if not line:
            raise RuntimeError(f"{' '.join(words)}: did not start")
        yield Started(line, psutil.Process(process.pid))
    finally:
        process.kill()
        process.wait()
        process.stdout.close()


def alone(script: str, **arguments: Any) -> dict[str, float]:
    """Return what ``measured(**arguments)`` of a script of this folder returns in its own process.

    So its memory is its own. The last line it prints is the answer.
    """
    done = subprocess.run(
        [sys.executable, __file__, script, json.dumps(arguments)],
        env={**os.environ, "DASK_LOGGING__DISTRIBUTED": "error"},
        stdout=subprocess.PIPE,
        text=True,
        check=True,
    )
    return json.loads(done.stdout.splitlines()[-1])


if __name__ == "__main__":
    print(json.dumps(load_script(HERE / f"{sys.argv[1]}.py").measured(**json.loads(sys.argv[2]))))
