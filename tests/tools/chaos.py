"""Chaos: kill whatever computes a study, again and again, and look at what comes of it.

    python -m tests.tools.chaos --kills 50 --seed 1

One study in one folder of results is computed by a scheduler that stands, then by jobs of a
private SLURM, then by processes of this machine, while a seeded random plan kills workers,
nannies, drivers, schedulers and nodes. A driver that ends is started again.
"""

import argparse
import tempfile
from collections import Counter
from pathlib import Path

from tests.cluster.havoc import Chaos, FinishedTooSoonError
from tests.cluster.processes import PATIENCE, Standing, end, start
from tests.cluster.slurm import Slurm, missing
from tests.cluster.tally import begun
from workflow.store import journal

SHARES = {"standing": 0.5, "slurm": 0.3, "local": 0.2}  # of the kills


def settings(core_seconds: float) -> list[str]:
    """Return the smoke study of figure 7 with realizations for so much work."""
    blocks = max(2, round(core_seconds / 3.0))  # 3 s for 10 realizations
    return [
        *("--set", f"study.realizations={10 * blocks}"),
        *("--set", "study.realizations_per_block=10"),
    ]


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
    """Run it all in ``folder``; return a report. Raises AssertionError where a promise breaks.

    A study that a fast machine finishes before the last kill is made twice as long.
    """
    while True:
        attempt = folder / f"{core_seconds:.0f}"
        attempt.mkdir()
        try:
            return _one_study(attempt, kills, seed, core_seconds)
        except FinishedTooSoonError:
            core_seconds *= 2.0


def _one_study(folder: Path, kills: int, seed: int, core_seconds: float) -> list[str]:
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
