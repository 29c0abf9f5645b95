"""Havoc: a study under fire, and what can be killed or stopped of that which computes it."""

import os
import random
import signal
import subprocess
import time
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import psutil

from elastomer_friction.workflow.store import journal
from tests.cluster.processes import PATIENCE, STUDY, Standing, end, kill, start, workers_of
from tests.cluster.slurm import NODES, Slurm
from tests.cluster.stops import Stops

ENDINGS = {0, 2, 130, -signal.SIGKILL, -signal.SIGTERM, -signal.SIGINT}  # Ctrl-C: early
BATCH_SECONDS = "0.15"  # short, so that much can happen in a small study
STOPPABLE = ("worker", "nanny", "scheduler", "worker of a job", "nanny of a job", "local worker")
Weapon = Callable[[], bool]  # returns whether it found something to kill


class Count(NamedTuple):
    """How many strikes."""

    kills: int
    stops: int = 0


class FinishedTooSoonError(Exception):
    """The study was finished before the last strike."""


class Chaos:
    """A study under fire."""

    def __init__(self, folder: Path, study: list[str], seed: int) -> None:
        self.folder, self.study, self.random = folder, study, random.Random(seed)
        self.stops = Stops(self.random)
        self.store, self.log = folder / "store", folder / "driver.log"
        self.silent = 0  # bytes of the log before the driver has said anything
        self.strikes: Counter[str] = Counter()
        self.endings: Counter[int] = Counter()  # of drivers, by exit status
        self.driver: subprocess.Popen | None = None
        self.stopping = False  # instead of killing
        self.options: list[str] = []
        self.environment: dict[str, str] = {}

    def standing(self, count: Count, cluster: Standing) -> None:
        """Strike what belongs to a scheduler with two workers."""
        self.options, self.environment = ["--scheduler", cluster.address], {}

        def at(*names: str) -> bool:
            return self._any([cluster.processes[name].pid for name in names])

        weapons = {
            "worker": lambda: self._any(cluster.workers()),
            "worker, SIGTERM": lambda: self._any(cluster.workers(), signal.SIGTERM),
            "nanny": lambda: at("worker-1", "worker-2"),
            "scheduler": lambda: at("scheduler"),
        }
        self._leg(count, weapons, cluster.heal)

    def slurm(self, count: Count, cluster: Slurm) -> None:
        """Strike what belongs to jobs of SLURM."""
        self.options, self.environment = cluster.options(), cluster.environment

        weapons = {
            "worker of a job": lambda: self._any(cluster.workers()),
            "nanny of a job": lambda: self._any([nanny.pid for nanny in cluster.nannies()]),
            "node down": lambda: cluster.set_down(self.random.choice(NODES)),
        }
        self._leg(count, weapons, cluster.heal)

    def local(self, count: Count) -> None:
        """Strike what belongs to processes of this machine."""
        self.options, self.environment = ["--workers", "2"], {}
        weapons = {"local worker": lambda: self._any(workers_of(psutil.Process(self.driver.pid)))}
        self._leg(count, weapons, lambda: None)

    def finish(self) -> None:
        """Let the study be finished in peace."""
        while not self.finished():
            self._run_on()
            self.driver.wait(timeout=4.0 * PATIENCE)

    def stop(self) -> None:
        """End the driver."""
        self.stops.let_go()
        if self.driver is not None:
            end(self.driver)

    def finished(self) -> bool:
        """Return whether the driver has ended well."""
        return self.driver is not None and self.driver.poll() == 0

    def _leg(self, count: Count, weapons: dict[str, Weapon], heal: Callable[[], None]) -> None:
        """Kill and stop so often, in any order: kill after some progress, stop whatever happens.

        What is stopped goes on by itself; kills and further stops come meanwhile.
        """
        for number in (signal.SIGKILL, signal.SIGTERM, signal.SIGINT):
            weapons[f"driver, {number.name}"] = lambda number=number: self._at_driver(number)
        brakes = {f"{name}, stopped": weapons[name] for name in STOPPABLE if name in weapons}
        brakes["driver, stopped"] = lambda: self._stop(self.driver.pid)
        plan = [weapons] * count.kills + [brakes] * count.stops
        self.random.shuffle(plan)
        while plan:
            self._run_on()
            if plan[-1] is weapons:
                self._wait_for_progress(heal)
            if self.finished():
                raise FinishedTooSoonError
            name = self.random.choice(sorted(plan[-1]))
            self.stopping = plan[-1] is brakes
            if self.driver.poll() is None and plan[-1][name]():
                plan.pop()
                self.strikes[name] += 1
                print(f"{sum(self.strikes.values()):3d} {name}", flush=True)
            time.sleep(self.random.uniform(0.0, 1.0))
        self.stops.let_go()
        self._at_driver(signal.SIGINT)

    def _run_on(self) -> None:
        """Start a driver where none runs."""
        if self.driver is not None and self.driver.poll() is not None:
            self.endings[self.driver.returncode] += 1
            assert self.driver.returncode in ENDINGS, self.log.read_text()[-5000:]
            self.driver = None
        if self.driver is None:
            command = [*STUDY, *self.study, "--out", str(self.folder), *self.options]
            command += ["--batch-seconds", BATCH_SECONDS]
            self.driver = start(self.log, *command, **self.environment)
            self.silent = self.log.stat().st_size

    def _wait_for_progress(self, heal: Callable[[], None]) -> None:
        """Heal the cluster until the store has got more, or the driver has ended."""
        size, began = journal.size(self.store), time.monotonic()
        while self.driver.poll() is None and time.monotonic() - began < PATIENCE:
            if any("shard" in entry for entry, _ in journal.entries(self.store, size)):
                return
            heal()
            time.sleep(0.5)

    def _any(self, pids: list[int], number: int = signal.SIGKILL) -> bool:
        if pids:
            victim = self.random.choice(sorted(pids))
            if self.stopping:
                return self._stop(victim)
            kill(victim, number)
        return bool(pids)

    def _stop(self, pid: int) -> bool:
        self.stops.stop(pid)
        return True

    def _at_driver(self, number: int) -> bool:
        """Signal the driver, as Ctrl-C does its whole group; wait for its end."""
        while number == signal.SIGINT and self.log.stat().st_size == self.silent:
            if self.driver.poll() is not None:  # until it says a line Python itself may be starting
                return False
            time.sleep(0.05)
        if self.driver.poll() is not None:
            return False
        (os.killpg if number == signal.SIGINT else os.kill)(self.driver.pid, number)
        self.driver.wait(timeout=PATIENCE)
        return True
