"""A study of 1e5 points with pretended work, run to its end: prints the most memory, in MiB.

    python -m tests.cluster.many_points FOLDER [POINTS]

Workers return results of the right size that took no time; all the rest is real.
"""

import sys
import time
from pathlib import Path

import numpy as np

from elastomer_friction.workflow.plan import make_plan
from elastomer_friction.workflow.run import RunOptions, run_plan
from elastomer_friction.workflow.simulate import PHASES, SCALARS, BatchResult
from elastomer_friction.workflow.study import read_study
from elastomer_friction.workflow.system import peak_bytes, this_maker

STUDY = """
[study]
realizations = 16
realizations_per_block = 4
[material]
shear_modulus = 1e7
relaxation_time = 1e-3
[surface]
length = 0.01
[grid]
hurst = {{linspace = [0, 1, 10]}}
normal_force = {{geomspace = [0.04, 40, 100]}}
spacing = 1e-4
roughness = 1e-5
velocity = {{geomspace = [0.01, 10, {velocities}]}}
velocity_step = 0.2
"""


def pretended(batch):
    """Stand in for block_means: zeros of the right shapes, in no time."""
    shape = len(batch.tasks), batch.blocks
    scalars = np.zeros((*shape, len(SCALARS)))
    curves = np.zeros((*shape, batch.recording.samples - 1))
    spent = np.zeros((len(batch.tasks), len(PHASES)))
    return BatchResult(scalars, curves, spent, batch.seconds, peak_bytes(), this_maker())


def main() -> None:
    """Run from the command line."""
    folder = Path(sys.argv[1])
    points = int(sys.argv[2]) if len(sys.argv) > 2 else 100_000
    file = folder / "many.toml"
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(STUDY.format(velocities=points // 1000), encoding="utf-8")
    began = time.monotonic()
    plan = make_plan(read_study(str(file)))
    print(f"{plan.points} points, {plan.records} records, {time.monotonic() - began:.0f} s to plan")
    options = RunOptions(workers=1, work=pretended, batch_seconds=100.0)
    print(*run_plan(plan, folder / "many.nc", options).lines(plan), sep="\n")
    size = (folder / "many.nc").stat().st_size
    print(f"{time.monotonic() - began:.0f} s in all, result of {size / 2**20:.0f} MiB")


if __name__ == "__main__":
    main()
