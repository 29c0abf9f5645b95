"""Core-hours of a whole study, from a random sample of its batches.

    python -m tests.tools.core_hours fig7 --scale paper --minutes 20 --seed 1 --out sample.json

It measures CPU time of one thread, which computes as a worker does. How draws lead to the whole
stands in sample.py. A shared machine is not always equally quick: the probes on which plans rest
are timed before and after each draw, and its time is told as the machine of the plan would take.
"""

import argparse
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from elastomer_friction.workflow.plan import this_machine
from elastomer_friction.workflow.plan.cost import PARTS
from elastomer_friction.workflow.plan.cost.machine import Pace
from elastomer_friction.workflow.plan.cost.timing import factors
from elastomer_friction.workflow.plan.plan import make_plan
from elastomer_friction.workflow.simulate import BatchResult, block_means
from elastomer_friction.workflow.study import read_study
from tests.tools.sample import (
    Draw,
    Estimate,
    Stratum,
    drawn,
    number_of_draws,
    strata,
    total,
)

LEAST = 60  # draws of all variants
ROUNDS = 2  # of the probes, at each time
HOUR = 3600.0


def described(draw: Draw, result: BatchResult, slower: np.ndarray) -> dict[str, Any]:
    """Return what a draw was and took, to be kept.

    slower : how much longer parts of work took meanwhile than on the machine of the plan.
    """
    batch = draw.batch
    first = batch.tasks[0].problem
    by_speed: dict[float, float] = {}
    for task, own in zip(batch.tasks, result.spent.sum(axis=1).tolist(), strict=True):
        by_speed[task.problem.speed] = by_speed.get(task.problem.speed, 0.0) + own
    spent = result.spent.sum(axis=0)
    parts = (np.append(spent, result.seconds - spent.sum()) / slower).tolist()
    return {
        "variant": draw.label,
        "hurst": first.hurst,
        "elements": first.elements,
        "steps": sorted({task.steps_per_spacing for task in batch.tasks}),
        "loads": sorted({task.problem.load for task in batch.tasks}),
        "tasks": len(batch.tasks),
        "first_line": draw.first_line,
        "lines": batch.blocks * batch.realizations_per_block,
        "share": draw.share,
        "predicted": batch.seconds,
        "seconds": sum(parts),
        "used": result.seconds,
        "parts": dict(zip(PARTS, parts, strict=True)),
        "speeds": list(by_speed.items()),
    }


def measured(whole: list[Stratum], draws: list[Draw], pace: Pace) -> Iterator[dict[str, Any]]:
    """Yield what each draw is and took. pace : of the plan."""
    for stratum in whole:  # machine code is loaded
        small = min(stratum.batches, key=lambda batch: batch.seconds)
        block_means(small)
    planned = np.array([pace.measured[part][0] for part in PARTS])
    before = factors(ROUNDS)
    for number, draw in enumerate(draws):
        result, after = block_means(draw.batch), factors(ROUNDS)
        now = np.array([(before[part][0] * after[part][0]) ** 0.5 for part in PARTS])
        row, before = described(draw, result, now / planned), after
        said = f"{number + 1:4d} of {len(draws)}: {row['seconds']:8.2f} s, "
        print(f"{said}predicted {draw.batch.seconds:8.2f}", flush=True)
        yield row


def over_predicted(rows: list[dict[str, Any]], label: str) -> list[float]:
    """Return measured over predicted time of the draws of a variant."""
    own = [row for row in rows if row["variant"] == label]
    return [row["seconds"] / row["predicted"] for row in own]


def by_part(whole: list[Stratum], rows: list[dict[str, Any]]) -> dict[str, float]:
    """Return the core-hours of each part of the work."""
    found = dict.fromkeys(PARTS, 0.0)
    for stratum in whole:
        own = [row for row in rows if row["variant"] == stratum.label]
        for row in own:
            weight = stratum.seconds / HOUR / len(own) / row["predicted"]
            for part, seconds in row["parts"].items():
                found[part] += weight * seconds
    return found


def verdict(whole: list[Stratum], rows: list[dict[str, Any]]) -> dict[str, Any]:
    """Print what the draws say; return it."""
    hours: dict[str, Estimate] = {}
    for stratum in whole:
        own = over_predicted(rows, stratum.label)
        hours[stratum.label] = total([stratum.seconds / HOUR], [own])
        print(
            f"{stratum.label or 'the study itself':20s}{hours[stratum.label]} core-hours, ", end=""
        )
        print(f"predicted {stratum.seconds / HOUR:.3g}, {len(own)} draws")
    each = [over_predicted(rows, stratum.label) for stratum in whole]
    hours["all"] = total([stratum.seconds / HOUR for stratum in whole], each)
    longest = max(row["seconds"] / row["share"] for row in rows)
    print(f"{'all':20s}{hours['all']} core-hours; longest batch {longest:.0f} s")
    parts = by_part(whole, rows)
    print("by part: " + ", ".join(f"{name} {value:.3g}" for name, value in parts.items()))
    return {"hours": hours, "parts": parts, "longest_batch_seconds": longest}


def options() -> argparse.Namespace:
    """Return what the command line asks for."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("study")
    parser.add_argument("--scale", default="paper")
    parser.add_argument("--minutes", type=float, default=0.0, help="predicted work, at least")
    parser.add_argument("--draws", type=int, default=LEAST, help="at least")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--out", type=Path, help="a JSON file for all of it")
    return parser.parse_args()


def main() -> None:
    """Draw, measure, print; write where asked."""
    asked = options()
    study = read_study(asked.study, asked.scale, [])
    pace = this_machine().pace
    whole = strata(make_plan(study, pace))
    generator = np.random.default_rng(asked.seed)
    numbers = number_of_draws(whole, asked.draws, 60.0 * asked.minutes)
    draws = [d for s, n in zip(whole, numbers, strict=True) for d in drawn(s, n, generator)]
    rows = list(measured(whole, draws, pace))
    print(f"\n{study.name}, {asked.scale}, seed {asked.seed}")
    kept = {**vars(asked), "out": None, **verdict(whole, rows), "draws": rows}
    if asked.out:
        asked.out.write_text(json.dumps(kept) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
