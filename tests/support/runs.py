"""Runs of the small study, in the process of a test or on the cluster of the tests."""

from pathlib import Path
from typing import NamedTuple

import xarray as xr

from elastomer_friction.workflow.plan.plan import Plan
from elastomer_friction.workflow.run.grid_run import run_plan
from elastomer_friction.workflow.run.summary import Summary
from elastomer_friction.workflow.run.workers import RunOptions
from elastomer_friction.workflow.store.store import store_folder
from elastomer_friction.workflow.study.cluster import LOCAL, Cluster
from tests.support.small import small_plan


class Run(NamedTuple):
    """A finished run."""

    plan: Plan
    summary: Summary
    path: Path

    def load(self, group: str | None = None) -> xr.Dataset:
        """Return the result."""
        with xr.open_dataset(self.path, group=group) as dataset:
            return dataset.load()


def run(
    folder: Path,
    *settings: str,
    scheduler: str = LOCAL,
    scale: str | None = None,
    batch_seconds: float = 3.0,
    **how,
) -> Run:
    """Run the small study with --set ``settings``, in this process unless a scheduler is given."""
    plan, path = small_plan(*settings, scale=scale), folder / "small.nc"
    how = RunOptions(Cluster(scheduler), batch_seconds=batch_seconds, **how)
    return Run(plan, run_plan(plan, path, how), path)


def shards(folder: Path) -> dict[str, tuple[int, int]]:
    """Return (inode, time) of the shards of a result by name; both change if one is rewritten."""
    files = store_folder(folder / "small.nc").glob("*.npz")
    return {file.name: (file.stat().st_ino, file.stat().st_mtime_ns) for file in files}
