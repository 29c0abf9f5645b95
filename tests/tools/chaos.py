"""Chaos: repeatedly kill and stop processes that compute a study, and check its result.

    python -m tests.tools.chaos --kills 50 --seed 1
    python -m tests.tools.chaos --kills 100 --stops 100      stops (SIGSTOP) of up to 60 s

One study in one folder of results is computed on a standing scheduler, then by jobs of a private
SLURM, then by processes of this machine, while a seeded random plan kills workers, nannies,
drivers, schedulers and nodes, or stops them for a while. A driver that ends is restarted.
"""

import argparse
import contextlib
import signal
import tempfile
from collections import Counter
from pathlib import Path

from elastomer_friction.workflow.store import journal
from tests.cluster.havoc import Chaos, Count, FinishedTooSoonError
from tests.cluster.processes import PATIENCE, STUDY, Standing, end, start
from tests.cluster.slurm import Slurm, missing
from tests.cluster.tally import begun

SHARES = {"slurm": 0.3, "local": 0.2}  # of the strikes; the rest is on the standing scheduler


def stored(store: Path) -> tuple[int, int, int]:
    """Return the numbers of stored chunks, of records, and of records stored more than once."""
    keys, chunks, written = {}, 0, Counter()
    for entry, _ in journal.entries(store):
        if "part" in entry:
            keys[entry["part"]] = entry["keys"]
        for part, first, blocks in entry.get("chunks", ()):
            chunks += 1
            tasks = [keys[part][i : i + 32] for i in range(0, len(keys[part]), 32)]
            written.update((key, first + block) for key in tasks for block in range(blocks))
    return chunks, len(written), sum(count > 1 for count in written.values())


def run_chaos(folder: Path, count: Count, seed: int, core_seconds: float) -> list[str]:
    """Run everything in ``folder``; return a report. Raises AssertionError if a promise is broken.

    If a fast machine finishes the study before the last strike, it is repeated twice as long.
    """
    while True:
        attempt = folder / f"{core_seconds:.0f}"
        attempt.mkdir()
        try:
            return _one_study(attempt, count, seed, core_seconds)
        except FinishedTooSoonError:
            core_seconds *= 2.0


def legs(count: Count) -> dict[str, Count]:
    """Return the number of strikes of each leg; without SLURM the first gets those of SLURM."""
    plan = {name: [round(SHARES[name] * number) for number in count] for name in ("slurm", "local")}
    if missing():
        plan["slurm"] = [0, 0]
    rest = [whole - a - b for whole, a, b in zip(count, *plan.values(), strict=True)]
    return {"standing": Count(*rest)} | {name: Count(*pair) for name, pair in plan.items()}


def _one_study(folder: Path, count: Count, seed: int, core_seconds: float) -> list[str]:
    blocks = max(2, round(core_seconds / 3.0))  # 3 s for 12 realizations
    study = ["--set", f"study.realizations={12 * blocks}"]
    study += ["--set", "study.realizations_per_block=12"]
    for name in ("peace", "war"):
        (folder / name).mkdir()
    peace = start(folder / "peace" / "log", *STUDY, *study, "--out", str(folder / "peace"))
    counts = legs(count)
    war = Chaos(folder / "war", study, seed)
    with contextlib.ExitStack() as afterwards:
        afterwards.callback(war.stop)
        afterwards.callback(end, peace)
        cluster = Standing(folder / "standing")
        afterwards.callback(cluster.stop)
        war.standing(counts["standing"], cluster)
        tally, (standing, _, _) = begun(cluster.tally), stored(war.store)
        cluster.stop()
        if any(counts["slurm"]):
            private = Slurm(folder / "slurm")
            afterwards.callback(private.stop)
            war.slurm(counts["slurm"], private)
        war.local(counts["local"])
        war.finish()
        assert peace.wait(timeout=4.0 * PATIENCE) == 0
        expected = (folder / "peace" / "fig7-smoke.nc").read_bytes()
    assert (war.folder / "fig7-smoke.nc").read_bytes() == expected, "another result"
    chunks, records, twice = stored(war.store)
    assert twice == 0, f"{twice} records were computed again"
    runs = sum("run" in entry for entry, _ in journal.entries(war.store))
    return [
        f"{sum(war.strikes.values())} kills and stops: {dict(sorted(war.strikes.items()))}",
        war.stops.line(),
        f"{runs} runs; drivers ended with {dict(sorted(war.endings.items()))}",
        f"{records} records in {chunks} batches stored, none twice; result bit-identical",
        f"wasted on the standing cluster: {tally - standing} of {tally} batches begun",
    ]


def main() -> None:
    """Run from the command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kills", type=int, default=50)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--core-seconds", type=float, default=60.0, help="of the study")
    parser.add_argument("--stops", type=int, default=0, help="for up to 60 s")
    options = parser.parse_args()
    signal.signal(signal.SIGINT, signal.default_int_handler)  # in the background it is ignored
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        count = Count(options.kills, options.stops)
        report = run_chaos(Path(folder), count, options.seed, options.core_seconds)
    print("\n".join(report))


if __name__ == "__main__":
    main()
