"""What studies take over what `plan` predicts: every study of the tree, as it comes.

    python -m tests.tools.predictions --scales smoke default --seconds 60 --out predictions.json

Each study runs as a user runs it, into a folder that is thrown away. The machine is measured before
and after it, since what else runs there changes. "First" is the CPU time over what the mean of both
predicts, as on a new machine; "learned" is the same after the runs of all other rows. What earlier
runs have taught this machine enters neither, and these teach it nothing.
"""

import argparse
import json
import math
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from elastomer_friction.kernels import Quantities
from elastomer_friction.workflow.plan.cost.machine import (
    WHOLE,
    Learned,
    Pace,
    Parted,
    label,
    prediction,
)
from elastomer_friction.workflow.plan.cost.timing import factors
from elastomer_friction.workflow.plan.plan import make_plan
from elastomer_friction.workflow.run import RunOptions, run_measured, run_plan
from elastomer_friction.workflow.simulate import load_kernels
from elastomer_friction.workflow.study import (
    AnyStudy,
    Measured,
    Study,
    known_scales,
    known_studies,
    read_study,
)

WITHIN = 1.25


Parts = dict[str, tuple[float, float]]  # how much longer than typical they take (timing.py)


def between(before: Parts, after: Parts) -> Parts:
    """Return the geometric mean of two measurements."""
    return {
        part: (math.sqrt(before[part][0] * after[part][0]), max(before[part][1], after[part][1]))
        for part in before
    }


def run_one(study: AnyStudy, longest: float) -> dict[str, Any] | None:
    """Run a study; return what it took and what was predicted, None where that is too long."""
    with tempfile.TemporaryDirectory() as folder:
        result = Path(folder, "result.nc")
        if isinstance(study, Measured):
            before, typical = factors(), study.script.outline(study.settings)[1]
            if prediction(Pace(before), {(study.name, WHOLE): typical}).seconds > longest:
                return None
            done = run_measured(study, result, Pace(before))
            return described(before, done.spent, done.typical)
        assert isinstance(study, Study)
        before = factors()
        plan = make_plan(study, Pace(before))
        if plan.prediction().seconds > longest:
            return None
        found = run_plan(plan, result, RunOptions())
    return described(before, found.spent, found.typical)


def described(before: Parts, spent: Parted, typical: Parted) -> dict[str, Any]:
    """Return what a run took and what was predicted, in all and by part."""
    measured = between(before, factors())
    return {
        "used": sum(spent.values()),
        "predicted": prediction(Pace(measured), typical).seconds,
        "parts": [[*which, used, typical[which]] for which, used in spent.items()],
        "measured": measured,
    }


def learned_from(rows: list[dict[str, Any]], measured: Parts) -> Pace:
    """Return what a machine knows after some runs."""
    known: dict[str, Learned] = {}
    for row in rows:
        for kind, part, used, typical in row["parts"]:
            name = label(kind, part)
            known[name] = known.get(name, Learned()).after(used, typical)
    return Pace(measured, known)


def again(rows: list[dict[str, Any]]) -> Iterator[dict[str, Any]]:
    """Yield the rows with what the others would have led to predict."""
    for number, row in enumerate(rows):
        pace = learned_from(rows[:number] + rows[number + 1 :], row["measured"])
        typical = {(kind, part): seconds for kind, part, _, seconds in row["parts"]}
        yield row | {"learned": prediction(pace, typical).seconds}


def table(rows: list[dict[str, Any]]) -> Iterator[str]:
    """Yield the lines of the table."""
    yield f"{'study':28}{'used, s':>9}{'first':>7}{'learned':>9}   used over typical, by part"
    for row in rows:
        shares = [
            f"{part} {used / typical:.2f} ({used / row['used']:.0%})"
            for _, part, used, typical in row["parts"]
            if used > 0.05 * row["used"] and typical
        ]
        ratios = row["used"] / row["predicted"], row["used"] / row["learned"]
        name = f"{row['study']} {row['scale']}"
        yield f"{name:28}{row['used']:9.2f}{ratios[0]:7.2f}{ratios[1]:9.2f}   {', '.join(shares)}"
    for name, which in (("first", "predicted"), ("learned", "learned")):
        ratios = [row["used"] / row[which] for row in rows]
        near = sum(1.0 / WITHIN <= ratio <= WITHIN for ratio in ratios)
        yield f"{name}: {near} of {len(rows)} within {WITHIN}"


def options() -> argparse.Namespace:
    """Return what is asked for."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("studies", nargs="*", default=sorted(known_studies()))
    parser.add_argument("--scales", nargs="+", default=["smoke"], help="'default' is one of them")
    parser.add_argument("--seconds", type=float, default=60.0, help="longest predicted")
    parser.add_argument("--out", type=Path, help="a JSON file for all of it")
    return parser.parse_args()


def main() -> None:
    """Run, print; write where asked."""
    asked = options()
    load_kernels("exponential", Quantities())
    rows: list[dict[str, Any]] = []
    for scale in asked.scales:
        for name in asked.studies:
            if scale in ("default", *known_scales(name)):
                study = read_study(name, None if scale == "default" else scale, [])
                found = run_one(study, asked.seconds)
                rows += [{"study": name, "scale": scale} | found] if found else []
                if asked.out:  # a long run may be stopped
                    asked.out.write_text(json.dumps(rows) + "\n", encoding="utf-8")
    print("\n".join(table(list(again(rows)))))


if __name__ == "__main__":
    main()
