"""The processes of a cluster: a scheduler, workers, drivers; started, found, ended."""

import contextlib
import os
import random
import re
import shutil
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import psutil
from distributed import Client

from tests.support.python import ROOT
from tests.support.small import write_study

PATIENCE = 300.0  # seconds to wait for a process at most
# Kills a process when its parent ends in any way: pytest may end without running its fixtures.
ENDS_WITH_PARENT = ("setpriv", "--pdeathsig", "KILL") if shutil.which("setpriv") else ()
STUDY = ("workflow", "run", "fig7", "--scale", "smoke")
TRIAL_SIZE = ("--set", "study.realizations=40")  # 160 batches, so that much can happen


def free_port() -> int:
    """Return a port that is free now, and below those that systems give to who asks for any."""
    while True:
        with contextlib.suppress(OSError), socket.socket() as probe:
            probe.bind(("127.0.0.1", port := random.randrange(10_000, 32_768)))
            return port


def start(
    log: Path, *arguments: str, cwd: Path = ROOT, before: tuple[str, ...] = (), **environment: str
) -> subprocess.Popen:
    """Start ``python -m ...`` in a process group of its own, its output added to a file.

    The process is killed when the process of the tests ends.

    before : a command that starts it, such as ``ip netns exec``.
    """
    with log.open("ab") as output:
        return subprocess.Popen(
            [*ENDS_WITH_PARENT, *before, sys.executable, "-m", *arguments],
            cwd=cwd,
            env={**os.environ, "PYTHONUNBUFFERED": "1", "GIT_DIR": "/nowhere", **environment},
            stdin=subprocess.DEVNULL,
            stdout=output,
            stderr=output,
            start_new_session=True,
        )


def start_scheduler(log: Path, port: int, host: str = "127.0.0.1") -> subprocess.Popen:
    """Start a scheduler that gives up silent workers sooner than docs/cluster.md advises."""
    options = ("--host", host, "--port", str(port), "--no-dashboard")
    ttl = {"DASK_DISTRIBUTED__SCHEDULER__WORKER_TTL": "10s"}
    return start(log, "distributed.cli.dask_scheduler", *options, **ttl)


def start_worker(log: Path, address: str, *options: str, **how) -> subprocess.Popen:
    """Start a worker of one thread, its files beside its log."""
    own = ("--nthreads", "1", "--no-dashboard", "--local-directory", str(log.with_suffix("")))
    return start(log, "distributed.cli.dask_worker", address, *own, *options, **how)


def end(process: subprocess.Popen) -> None:
    """End a process, if it still runs, and whatever it has started."""
    if process.poll() is None:
        children = psutil.Process(process.pid).children(recursive=True)
        for pid in (process.pid, *(child.pid for child in children)):
            kill(pid, signal.SIGKILL)
        process.wait(timeout=PATIENCE)


def kill(pid: int, number: int) -> None:
    """Send a signal to a process, which may be gone already."""
    with contextlib.suppress(ProcessLookupError):
        os.kill(pid, number)


def workers_of(process: psutil.Process) -> list[int]:
    """Return the pids of the worker processes below a nanny or a driver."""
    try:
        family = process.children(recursive=True)
        return [child.pid for child in family if "spawn_main" in " ".join(child.cmdline())]
    except psutil.NoSuchProcess:
        return []


def ports_of(pids: list[int]) -> set[int]:
    """Return the TCP ports at which processes, and those that they started, listen."""
    family, connections = [psutil.Process(pid) for pid in pids], []
    family += [child for process in family for child in process.children(recursive=True)]
    for process in family:
        with contextlib.suppress(psutil.NoSuchProcess):  # it ended just now
            connections += process.net_connections("tcp")
    return {c.laddr.port for c in connections if c.status == psutil.CONN_LISTEN}


def wait_while(lacking: Callable[[], object], process: subprocess.Popen, log: Path) -> None:
    """Wait for something that a process is to bring about before it ends."""
    until = time.monotonic() + PATIENCE
    while lacking():
        assert process.poll() is None, log.read_text()
        assert time.monotonic() < until, log.read_text()
        time.sleep(0.01)


def shards(folder: Path) -> set[str]:
    """Return the names of the shards beside a result."""
    return {path.name for path in (folder / "store").glob("*.npz")}


class Trial:
    """A run of the small study in many batches, in a process that something is to happen to."""

    def __init__(
        self, folder: Path, *options: str, stopping: bool = False, **environment: str
    ) -> None:
        """``stopping`` : whether it stops itself once it has stored something, see stopping.py."""
        folder.mkdir(exist_ok=True)
        self.folder, self.log = folder, folder / "log"
        many = (*TRIAL_SIZE, "--batch-seconds", "1e-9")
        self.words = (write_study(folder), "--out", str(folder), *many, *options)
        self.again(module="tests.cluster.stopping" if stopping else "workflow", **environment)

    def again(self, *more: str, module: str = "workflow", **environment: str) -> None:
        """Start the run, or start it once more."""
        self.driver = start(self.log, module, "run", *self.words, *more, **environment)

    def lines(self) -> list[str]:
        """Return what was said."""
        return self.log.read_text().splitlines()

    def wait_for_its_stop(self) -> None:
        """Wait until the run has stopped itself: the rest of it would not be long in coming."""
        driver = psutil.Process(self.driver.pid)

        def runs() -> bool:
            return driver.status() != psutil.STATUS_STOPPED or not shards(self.folder)

        wait_while(runs, self.driver, self.log)

    def go_on(self) -> None:
        """Let the run go on."""
        self.driver.send_signal(signal.SIGCONT)

    def wait_for(self, pattern: str) -> None:
        """Wait until a line of a pattern was said."""
        wait_while(lambda: not said(pattern, self.lines()), self.driver, self.log)

    def ended(self) -> tuple[int, list[str]]:
        """Return the exit status and what was said."""
        return self.driver.wait(timeout=4.0 * PATIENCE), self.lines()

    def whole(self) -> bytes:
        """Return the bytes of the result of a run that ends well."""
        status, lines = self.ended()
        assert status == 0, lines
        assert "Traceback" not in "".join(lines)
        return (self.folder / "small.nc").read_bytes()


def said(pattern: str, lines: list[str]) -> int:
    """Return how many lines are of a pattern."""
    return sum(re.fullmatch(pattern, line) is not None for line in lines)


class Standing:
    """A scheduler and two workers with nannies, as a user would start them; healed on demand."""

    def __init__(self, folder: Path, worker_1: dict[str, str] | None = None) -> None:
        """``worker_1`` : variables of the environment of the first worker alone."""
        self.folder, self.worker_1 = folder, worker_1 or {}
        self.port = free_port()
        self.address = f"tcp://127.0.0.1:{self.port}"
        self.tally = folder / "tally"
        self.tally.mkdir(parents=True)
        self.processes: dict[str, subprocess.Popen] = {}
        self.heal()

    def heal(self) -> None:
        """Start whatever is not running."""
        for name in ("scheduler", "worker-1", "worker-2"):
            process = self.processes.get(name)
            if process is None or process.poll() is not None:
                self.processes[name] = self._start(name)

    def complete(self) -> None:
        """Start whatever is not running, until the scheduler knows both workers."""
        self.heal()
        with Client(self.address, timeout=PATIENCE, set_as_default=False) as client:
            while len(client.nthreads()) < 2:
                time.sleep(0.1)
                self.heal()

    def stop(self) -> None:
        """End all."""
        for process in self.processes.values():
            end(process)

    def workers(self) -> list[int]:
        """Return the pids of the worker processes."""
        alive = [p.pid for p in self.processes.values() if p.poll() is None]
        return [pid for nanny in alive for pid in workers_of(psutil.Process(nanny))]

    def _start(self, name: str) -> subprocess.Popen:
        log = self.folder / f"{name}.log"
        if name == "scheduler":
            return start_scheduler(log, self.port)
        options = ["--preload", "tests.cluster.tally", "--death-timeout", "60"]
        own = self.worker_1 if name == "worker-1" else {}
        return start_worker(log, self.address, *options, TALLY=str(self.tally), **own)
