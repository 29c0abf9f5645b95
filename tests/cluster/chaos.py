"""Chaos: kill whatever computes a study, again and again, and look at what comes of it.

    python -m tests.cluster.chaos --kills 50 --seed 1

One study in one folder of results is computed by a scheduler that stands, then by jobs of a
private SLURM, then by processes of this machine, while a seeded random plan kills workers,
nannies, drivers, schedulers and nodes. A driver that ends is started again.
"""

import argparse
import os
import random
import signal
import subprocess
import tempfile
import time
from collections import Counter
from collections.abc import Callable
from pathlib import Path

import psutil

from tests.cluster.processes import PATIENCE, Standing, end, kill, start, workers_of
from tests.cluster.slurm import NODES, Slurm, missing
from tests.cluster.tally import begun
from workflow import journal

SHARES = {"standing": 0.5, "slurm": 0.3, "local": 0.2}  # of the kills
ENDINGS = {0, 2, 130, -signal.SIGKILL, -signal.SIGTERM}  # of drivers
BATCH_SECONDS = "0.15"  # short, so that much can happen in a small study
Weapon = Callable[[], bool]  # returns whether it found something to kill


def settings(core_seconds: float) -> list[str]:
    """Return the smoke study of figure 7 with realizations for so much work."""
    blocks = max(2, round(core_seconds / 3.0))  # 3 s for 10 realizations
    return [
        *("--set", f"study.realizations={10 * blocks}"),
        *("--set", "study.realizations_per_block=10"),
    ]


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

        def at(names: list[str]) -> bool:
            cluster.processes[self.random.choice(names)].kill()
            return True

        weapons = {
            "worker": lambda: self._any(cluster.workers(), signal.SIGKILL),
            "worker, SIGTERM": lambda: self._any(cluster.workers(), signal.SIGTERM),
            "nanny": lambda: at(["worker-1", "worker-2"]),
            "scheduler": lambda: at(["scheduler"]),
        }
        self._leg(kills, weapons, cluster.heal)

    def slurm(self, kills: int, cluster: Slurm) -> None:
        """Kill what belongs to jobs of SLURM."""
        self.options, self.environment = cluster.options(), cluster.environment

        def node() -> bool:
            cluster.set_down(self.random.choice(NODES))
            return True

        weapons = {
            "worker of a job": lambda: self._any(cluster.workers(), signal.SIGKILL),
            "nanny of a job": lambda: self._any(
                [nanny.pid for nanny in cluster.nannies()], signal.SIGKILL
            ),
            "node down": node,
        }
        self._leg(kills, weapons, cluster.heal)

    def local(self, kills: int) -> None:
        """Kill what belongs to processes of this machine."""
        self.options, self.environment = ["--workers", "2"], {}

        def worker() -> bool:
            return self._any(workers_of(psutil.Process(self.driver.pid)), signal.SIGKILL)

        self._leg(kills, {"local worker": worker}, lambda: None)

    def finish(self) -> None:
        """Let the study be finished in peace."""
        while not self.finished():
            self._run_on()
            self.driver.wait(timeout=4.0 * PATIENCE)

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
            assert not self.finished(), "the study was finished before the last kill"
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
            command = ["workflow", "run", "fig7", "--scale", "smoke", *self.study]
            command += ["--out", str(self.folder), "--batch-seconds", BATCH_SECONDS]
            self.driver = start(self.log, *command, *self.options, **self.environment)

    def _wait_for_progress(self, heal: Callable[[], None]) -> None:
        """Heal the cluster until the store has got more, or the driver has ended."""
        size, began = journal.size(self.store), time.monotonic()
        while self.driver.poll() is None and time.monotonic() - began < PATIENCE:
            if any("shard" in entry for entry, _ in journal.entries(self.store, size)):
                return
            heal()
            time.sleep(0.5)

    def _any(self, pids: list[int], number: int) -> bool:
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


def stored(store: Path) -> tuple[int, int, int]:
    """Return how many chunks and records were stored, and how many records more than once."""
    keys, chunks, seen = {}, 0, Counter()
    for entry, _ in journal.entries(store):
        if "part" in entry:
            keys[entry["part"]] = entry["keys"]
        for part, first, blocks in entry.get("chunks", ()):
            chunks += 1
            tasks = [keys[part][i : i + 32] for i in range(0, len(keys[part]), 32)]
            seen.update((key, first + block) for key in tasks for block in range(blocks))
    return chunks, len(seen), sum(count > 1 for count in seen.values())


def undisturbed(folder: Path, study: list[str]) -> bytes:
    """Return the result of the study when nothing is killed."""
    command = ["workflow", "run", "fig7", "--scale", "smoke", *study, "--out", str(folder)]
    process = start(folder / "driver.log", *command, "--workers", "2")
    assert process.wait(timeout=4.0 * PATIENCE) == 0, (folder / "driver.log").read_text()
    return (folder / "fig7.nc").read_bytes()


def run_chaos(folder: Path, kills: int, seed: int, core_seconds: float) -> list[str]:
    """Run it all in ``folder``; return a report. Raises AssertionError where a promise breaks."""
    study = settings(core_seconds)
    for name in ("peace", "war"):
        (folder / name).mkdir()
    expected = undisturbed(folder / "peace", study)
    war = Chaos(folder / "war", study, seed)
    counts = {name: round(share * kills) for name, share in SHARES.items()}
    if missing():
        counts["standing"] += counts.pop("slurm")
    try:
        cluster = Standing(folder / "standing")
        try:
            war.standing(counts["standing"], cluster)
            chunks, _, _ = stored(war.store)
            waste = f"{begun(cluster.tally) - chunks} of {begun(cluster.tally)} batches begun"
        finally:
            cluster.stop()
        if "slurm" in counts:
            private = Slurm(folder / "slurm")
            try:
                war.slurm(counts["slurm"], private)
            finally:
                private.stop()
        war.local(counts["local"])
        war.finish()
    finally:
        if war.driver is not None:
            end(war.driver)
    assert (war.folder / "fig7.nc").read_bytes() == expected, "another result"
    chunks, records, twice = stored(war.store)
    assert twice == 0, f"{twice} records were computed again"
    runs = sum("run" in entry for entry, _ in journal.entries(war.store))
    return [
        f"{sum(war.kills.values())} kills: {dict(sorted(war.kills.items()))}",
        f"{runs} runs; drivers ended with {dict(sorted(war.endings.items()))}",
        f"{records} records in {chunks} batches stored, none twice; result bit-identical",
        f"wasted on the standing cluster: {waste}",
    ]


def main() -> None:
    """Run from the command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kills", type=int, default=50)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--core-seconds", type=float, default=60.0, help="of the study")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        report = run_chaos(Path(folder), options.kills, options.seed, options.core_seconds)
    print("\n".join(report))


if __name__ == "__main__":
    main()
