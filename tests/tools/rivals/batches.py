"""Draws of sample.py on an earlier commit: what they are is told to a process of its own."""

import contextlib
import json
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from elastomer_friction.workflow.plan.plan import Plan
from tests.tools.rivals.checkout import checkout
from tests.tools.sample import Draw

SCRIPT = Path(__file__).with_name("batches_then.py")
Then = Callable[[Draw], float]  # the seconds that a draw takes there


@contextlib.contextmanager
def at(commit: str, plan: Plan) -> Iterator[Then]:
    """Yield what measures a draw on the code of a commit."""
    script = [sys.executable, str(SCRIPT)]
    with (
        checkout(commit) as (place, environment),
        subprocess.Popen(
            script,
            env=environment,
            cwd=place,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        ) as process,
    ):
        assert process.stdin is not None
        assert process.stdout is not None
        into, out = process.stdin, process.stdout

        def measure(draw: Draw) -> float:
            print(json.dumps(to_be_computed(draw, plan)), file=into, flush=True)
            return float(json.loads(out.readline())["seconds"])

        yield measure
        into.close()


def to_be_computed(draw: Draw, plan: Plan) -> dict[str, Any]:
    """Return all that a draw is, for another commit."""
    batch = draw.batch
    return {
        "seed": batch.seed,
        "normalisation": batch.normalisation,
        "quantities": batch.quantities[:4],
        "scheme": batch.scheme,
        "samples": batch.recording.samples,
        "horizon": plan.study.variants[draw.label].horizon,
        "first_line": batch.first_block * batch.realizations_per_block,
        "lines": batch.blocks * batch.realizations_per_block,
        "tasks": [(task.problem[:5], task.steps_per_spacing) for task in batch.tasks],
    }
