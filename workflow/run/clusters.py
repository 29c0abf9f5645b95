"""The client of whatever computes: processes of this machine, SLURM's jobs, a scheduler there."""

import contextlib
import importlib.util
import logging
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import dask
from distributed import Client, LocalCluster

from workflow.errors import UserError
from workflow.study.cluster import LOCAL, SLURM, Cluster, walltime_seconds
from workflow.system.process import MALLOC, PINNED

CONNECT_SECONDS = 10


@contextlib.contextmanager
def open_client(
    cluster: Cluster, workers: int | None = None, dashboard: bool = False
) -> Iterator[Client]:
    """Yield a client of the cluster; ``workers`` is the number of processes of this machine.

    Raises UserError when a scheduler does not answer or a batch system refuses.
    """
    if dashboard and importlib.util.find_spec("bokeh") is None:
        raise UserError("--dashboard: needs bokeh; install it beside this package")
    settings: dict[str, Any] = {
        "distributed.worker.preload": ["workflow.run.worker"],
        "distributed.scheduler.worker-saturation": 1.0,  # none waits on a worker: Ctrl-C ends soon
    }
    pinned = {f"{name}_NUM_THREADS": 1 for name in PINNED}
    for name, value in (MALLOC | pinned).items():
        settings[f"distributed.nanny.pre-spawn-environ.{name}"] = value
    # A lost scheduler is said in one line, by the flow.
    logging.getLogger("distributed.client").setLevel(logging.CRITICAL)
    with contextlib.ExitStack() as stack:
        stack.enter_context(dask.config.set(settings))
        if cluster.where == LOCAL:
            client = Client(stack.enter_context(_local_cluster(workers)))
        elif cluster.where == SLURM:
            client = Client(stack.enter_context(slurm_cluster(cluster, MALLOC)))
        else:
            client = _connected(cluster.where)
        stack.enter_context(client)
        if dashboard:
            print(f"dashboard: {client.dashboard_link}", file=sys.stderr)
        yield client


def _connected(address: str) -> Client:
    try:
        return Client(address, timeout=CONNECT_SECONDS)
    except (OSError, ValueError) as error:
        raise UserError(f"--scheduler {address}: no scheduler answers there") from error


@contextlib.contextmanager
def _local_cluster(workers: int | None) -> Iterator[LocalCluster]:
    # Ctrl-C reaches the whole process group: worker processes must be born ignoring it.
    previous = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        cluster = LocalCluster(
            n_workers=workers or _cores(),
            threads_per_worker=1,
            processes=True,
            dashboard_address="127.0.0.1:0",  # any free port: 8787 may be taken
        )
    finally:
        signal.signal(signal.SIGINT, previous)
    with cluster:
        yield cluster


def _cores() -> int:
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


ADAPT_SECONDS = "5s"  # between looks at whether jobs have to be replaced
STAGGER = 0.1  # of the lifetime, so that workers do not all retire at once


@contextlib.contextmanager
def slurm_cluster(cluster: Cluster, environment: dict[str, str]) -> Iterator[Any]:
    """Yield a cluster whose scheduler is here and whose workers are ``cluster.jobs`` jobs.

    Raises UserError where SLURM is not there or would refuse the jobs.
    """
    try:
        from dask_jobqueue import SLURMCluster
    except ImportError as error:
        raise UserError(
            "--slurm: needs dask-jobqueue (the extra 'slurm' of this package)"
        ) from error
    Path(cluster.log_folder).mkdir(parents=True, exist_ok=True)
    with SLURMCluster(**_settings(cluster, environment)) as jobs:
        _try_submitting(jobs.job_script())
        jobs.adapt(minimum_jobs=cluster.jobs, maximum_jobs=cluster.jobs, interval=ADAPT_SECONDS)
        yield jobs


def _settings(cluster: Cluster, environment: dict[str, str]) -> dict[str, Any]:
    lifetime = cluster.lifetime
    variables = {f"{name}_NUM_THREADS": "1" for name in PINNED} | environment
    exported = [f"export {name}={value}" for name, value in variables.items()]
    return {
        "queue": cluster.queue or None,
        "account": cluster.account or None,
        "cores": cluster.cores,
        "processes": cluster.cores,
        "memory": cluster.memory,
        "walltime": _written(walltime_seconds(cluster.walltime)),
        "interface": cluster.interface or None,
        "log_directory": cluster.log_folder,
        "python": sys.executable,
        "job_extra_directives": ["--no-requeue"],  # we replace jobs ourselves
        "job_script_prologue": [*exported, *cluster.prologue],
        "worker_extra_args": [
            *("--lifetime", f"{lifetime:.0f}s"),
            *("--lifetime-stagger", f"{STAGGER * lifetime:.0f}s"),
            *("--preload", "workflow.run.worker"),
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
