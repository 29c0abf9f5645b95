"""Workers as jobs of a batch system through dask-jobqueue, which replaces lost jobs."""

import contextlib
import re
import shlex
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import dask
from tornado.ioloop import IOLoop

from ..ground import UserError
from ..study import BATCH_SYSTEMS, Cluster
from ..system import THREADS, interface_named, refused
from .security import new_security, private_pages

# Workers import code from their local folder, which must therefore belong to this user alone. They
# import nothing from the folder in which the job was submitted.
PRIVATE_FOLDER_LINES = (
    "export PYTHONSAFEPATH=1",
    "export DASK_TEMPORARY_DIRECTORY=$(mktemp -d)",
    "trap 'rm -rf \"$DASK_TEMPORARY_DIRECTORY\"' EXIT",
)
ADAPT_INTERVAL = "5s"  # between checks for lost workers
LIFETIME_STAGGER = 0.1  # random share of the lifetime, so that workers do not all retire at once


@contextlib.contextmanager
def job_cluster(loop: IOLoop, cluster: Cluster, dashboard: bool = False) -> Iterator[Any]:
    """Yield a cluster with a local scheduler and workers in ``cluster.jobs`` jobs.

    They share a certificate of this run, stored in a private folder beside the logs. Raises
    UserError if dask-jobqueue, the batch system or the interface is missing, or jobs are refused.
    """
    name, logs = cluster.where, Path(cluster.log_folder)
    try:
        import dask_jobqueue
    except ImportError as error:
        needed = f"--{name}: needs dask-jobqueue; {sys.executable} -m pip install dask-jobqueue"
        raise UserError(needed) from error
    start = getattr(dask_jobqueue, BATCH_SYSTEMS[name].jobqueue)
    with refused(logs, "cannot be used:"):
        logs.mkdir(parents=True, exist_ok=True)
        keys = tempfile.TemporaryDirectory(prefix=".tls-", dir=logs.resolve())
    with keys as folder:
        security = new_security(folder, quoted=True)
        pages, options = private_pages(security, dashboard)
        shared = {"loop": loop, "security": security, "scheduler_options": options}
        with dask.config.set(pages), start(**shared, **_settings(cluster, pages)) as jobs:
            _try_submitting(name, jobs.job_script())
            jobs.adapt(
                minimum_jobs=cluster.jobs, maximum_jobs=cluster.jobs, interval=ADAPT_INTERVAL
            )
            yield jobs


def _settings(cluster: Cluster, pages: dict[str, Any]) -> dict[str, Any]:
    """Return the arguments of dask-jobqueue's cluster. pages : settings of dask."""
    settings = {f"DASK_{name.replace('.', '__').upper()}": value for name, value in pages.items()}
    exported = [f"export {k}={shlex.quote(str(v))}" for k, v in {**THREADS, **settings}.items()]
    stagger = LIFETIME_STAGGER * cluster.lifetime
    lifetime = f"--lifetime {cluster.lifetime:.0f}s --lifetime-stagger {stagger:.0f}s"
    logs = re.sub(r'(["\\])', r"\\\1", str(Path(cluster.log_folder))).replace("%", "%%")
    outputs = (f'-{kind[0]} "{logs}/dask-worker-%J.{kind}"' for kind in ("err", "out"))  # for SLURM
    own = [*BATCH_SYSTEMS[cluster.where].directives, *outputs]
    own = [line for line in own if line.split()[0] not in cluster.leave_out]
    same = ("queue", "account", "cores", "memory", "walltime")
    return {name: getattr(cluster, name) or None for name in same} | {
        "processes": cluster.cores,
        "interface": interface_named(cluster.interface),
        "log_directory": None,  # dask-jobqueue would not quote it
        "python": shlex.quote(sys.executable),
        "job_extra_directives": [*own, *cluster.directives],
        # Of any line with one of these texts; None: the setting of dask-jobqueue.
        "job_directives_skip": [f" {w}{end}" for w in cluster.leave_out for end in " ="] or None,
        "job_script_prologue": [*exported, *PRIVATE_FOLDER_LINES, *cluster.prologue],
        "worker_extra_args": [*lifetime.split(), "--no-dashboard"],
        "protocol": "tls://",
    }


def _try_submitting(name: str, script: str) -> None:
    """Submit the script on trial, since errors of the real submissions are not reported."""
    command = BATCH_SYSTEMS[name].trial
    try:
        done = subprocess.run(command, input=script, capture_output=True, text=True)
    except FileNotFoundError as error:
        raise UserError(f"--{name}: {command[0]} is not found on this machine") from error
    if done.returncode:
        message = " ".join(done.stderr.split()) or f"exit status {done.returncode}"
        raise UserError(
            f"--{name}: {name.upper()} refuses the jobs: {message}; cluster.directives adds "
            "directives such as --qos, and cluster.leave_out omits some, such as --mem"
        )
