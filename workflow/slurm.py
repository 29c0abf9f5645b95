"""Workers as jobs of SLURM, through dask-jobqueue: lost and expired ones are replaced."""

import contextlib
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from workflow.errors import UserError
from workflow.place import Place, walltime_seconds

ADAPT_SECONDS = "5s"  # between looks at whether jobs have to be replaced
STAGGER = 0.1  # of the lifetime, so that workers do not all retire at once
PINNED = ("OMP", "MKL", "OPENBLAS", "NUMBA")  # libraries that must not start threads of their own


@contextlib.contextmanager
def slurm_cluster(place: Place, environment: dict[str, str]) -> Iterator[Any]:
    """Yield a cluster whose scheduler is here and whose workers are ``place.jobs`` jobs.

    Raises UserError where SLURM is not there or would refuse the jobs.
    """
    try:
        from dask_jobqueue import SLURMCluster
    except ImportError as error:
        raise UserError(
            "--slurm: needs dask-jobqueue (the extra 'slurm' of this package)"
        ) from error
    Path(place.log_folder).mkdir(parents=True, exist_ok=True)
    with SLURMCluster(**_settings(place, environment)) as cluster:
        _try_submitting(cluster.job_script())
        cluster.adapt(minimum_jobs=place.jobs, maximum_jobs=place.jobs, interval=ADAPT_SECONDS)
        yield cluster


def _settings(place: Place, environment: dict[str, str]) -> dict[str, Any]:
    lifetime = place.lifetime
    exports = {f"{name}_NUM_THREADS": "1" for name in PINNED} | environment
    return {
        "queue": place.queue or None,
        "account": place.account or None,
        "cores": place.cores,
        "processes": place.cores,
        "memory": place.memory,
        "walltime": _written(walltime_seconds(place.walltime)),
        "interface": place.interface or None,
        "log_directory": place.log_folder,
        "python": sys.executable,
        "job_extra_directives": ["--no-requeue"],  # we replace jobs ourselves
        "job_script_prologue": [f"export {n}={v}" for n, v in exports.items()] + [*place.prologue],
        "worker_extra_args": [
            *("--lifetime", f"{lifetime:.0f}s"),
            *("--lifetime-stagger", f"{STAGGER * lifetime:.0f}s"),
            *("--preload", "workflow.worker_setup"),
        ],
        "scheduler_options": {"dashboard_address": ":0"},
    }


def _written(seconds: float) -> str:
    minutes, second = divmod(int(seconds), 60)
    return f"{minutes // 60:02d}:{minutes % 60:02d}:{second:02d}"


def _try_submitting(script: str) -> None:
    """Let SLURM say now what it would otherwise say to nobody, once for every job."""
    command = ["sbatch", "--test-only"]
    try:
        done = subprocess.run(command, input=script, capture_output=True, text=True)
    except FileNotFoundError as error:
        raise UserError("--slurm: sbatch is not found on this machine") from error
    if done.returncode:
        said = " ".join(done.stderr.split()) or f"exit status {done.returncode}"
        raise UserError(f"--slurm: SLURM refuses the jobs: {said}")
