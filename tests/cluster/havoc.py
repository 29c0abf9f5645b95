"""Havoc: a study under fire, and what can be killed of that which computes it."""

import os
import random
import signal
import subprocess
import time
from collections import Counter
from collections.abc import Callable
from pathlib import Path

import psutil

from tests.cluster.processes import PATIENCE, STUDY, Standing, end, kill, start, workers_of
from tests.cluster.slurm import NODES, Slurm
from workflow.store import journal

ENDINGS = {0, 2, 130, -signal.SIGKILL, -signal.SIGTERM}  # of drivers
BATCH_SECONDS = "0.15"  # short, so that much can happen in a small study
Weapon = Callable[[], bool]  # returns whether it found something to kill


class FinishedTooSoonError(Exception):
    """The study was finished before the last kill."""


class Chaos:
    """A study under fire."""

    def __init__(self, folder: Path, study: list[str], seed: int) -> None:
        self.folder, self.study, self.random = folder, study, random.Random(seed)
        self.store, self.log = folder / "store", folder / "driver.log"
        self.kills: Counter[str] = Counter()
        self.endings: Counter[int] = Counter()  # of drivers, by exit status
        self.driver: subprocess.Popen | None = None
        self.options: list[str] = []
        self.environment: dict[str, str] = {}

    def standing(self, kills: int, cluster: Standing) -> None:
        """Kill what belongs to a scheduler with two workers."""
        self.options, self.environment = ["--scheduler", cluster.address], {}

        def at(*names: str) -> bool:
            return self._any([cluster.processes[name].pid for name in names])

        weapons = {
            "worker": lambda: self._any(cluster.workers()),
            "worker, SIGTERM": lambda: self._any(cluster.workers(), signal.SIGTERM),
            "nanny": lambda: at("worker-1", "worker-2"),
            "scheduler": lambda: at("scheduler"),
        }
        self._leg(kills, weapons, cluster.heal)

    def slurm(self, kills: int, cluster: Slurm) -> None:
        """Kill what belongs to jobs of SLURM."""
        self.options, self.environment = cluster.options(), cluster.environment

        weapons = {
            "worker of a job": lambda: self._any(cluster.workers()),
            "nanny of a job": lambda: self._any([nanny.pid for nanny in cluster.nannies()]),
            "node down": lambda: cluster.set_down(self.random.choice(NODES)),
        }
        self._leg(kills, weapons, cluster.heal)

    def local(self, kills: int) -> None:
        """Kill what belongs to processes of this machine."""
        self.options, self.environment = ["--workers", "2"], {}
        weapons = {"local worker": lambda: self._any(workers_of(psutil.Process(self.driver.pid)))}
        self._leg(kills, weapons, lambda: None)

    def finish(self) -> None:
        """Let the study be finished in peace."""
        while not self.finished():
            self._run_on()
            self.driver.wait(timeout=4.0 * PATIENCE)

    def stop(self) -> None:
        """End the driver."""
        if self.driver is not None:
            end(self.driver)

    def finished(self) -> bool:
        """Return whether the driver has ended well."""
        return self.driver is not None and self.driver.poll() == 0

    def _leg(self, kills: int, weapons: dict[str, Weapon], heal: Callable[[], None]) -> None:
        for number in (signal.SIGKILL, signal.SIGTERM, signal.SIGINT):
            weapons[f"driver, {number.name}"] = lambda number=number: self._at_driver(number)
        aim = sum(self.kills.values()) + kills
        while sum(self.kills.values()) < aim:
            self._run_on()
            self._wait_for_progress(heal)
            if self.finished():
                raise FinishedTooSoonError
            name = self.random.choice(sorted(weapons))
            if self.driver.poll() is None and weapons[name]():
                self.kills[name] += 1
                print(f"{sum(self.kills.values()):3d} {name}", flush=True)
            time.sleep(self.random.uniform(0.0, 1.0))
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
            kill(self.random.choice(sorted(pids)), number)
        return bool(pids)

    def _at_driver(self, number: int) -> bool:
        """Signal the driver, as Ctrl-C does its whole group; wait for its end."""
        if self.driver.poll() is not None:
            return False
        (os.killpg if number == signal.SIGINT else os.kill)(self.driver.pid, number)
        self.driver.wait(timeout=PATIENCE)
        return True
