"""Memory of a real driver with its scheduler and two worker processes, kernels left out.

Runs in a process of its own (processes.alone).
"""

import tempfile
from pathlib import Path
from unittest.mock import patch

from workflow.plan.batches import batches
from workflow.plan.plan import make_plan
from workflow.run import run as runner
from workflow.study.read import read_study
from workflow.system.process import peak_bytes

from .pretend import pretend, whole

STUDY = """
[study]
title = "ten points"
seed = 1
realizations = {realizations}
realizations_per_block = {block}
[material]
shear_modulus = 1e7
relaxation_time = 1e-3
[surface]
length = 0.01
[grid]
hurst = 0.7
normal_force = 1.0
spacing = 1e-5
roughness = 1e-5
velocity = {{geomspace = [1e-3, 1e-1, 10]}}
velocity_step = 0.2
"""
POINTS = 10
PER_BATCH = 100  # realizations
BLOCKS = 1000  # at most, per point


def measured(realizations: int) -> dict[str, float]:
    """Return the peak memory (MiB) of the driver in a run of so many realizations."""
    each = realizations // POINTS
    text = STUDY.format(realizations=each, block=max(1, each // BLOCKS))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "points.toml"
        path.write_text(text, encoding="utf-8")
        plan = make_plan(read_study(str(path)))
        predicted = sum(batch.seconds for batch in batches(plan, ()))
        with patch.object(runner, "run_batch", whole(pretend)):
            seconds = predicted * PER_BATCH / realizations
            how = runner.How(workers=2, batch_seconds=seconds)
            summary = runner.run_plan(plan, Path(folder) / "points.nc", how)
    return {
        "batches": summary.batches,
        "memory": peak_bytes() / 2**20,
    }
