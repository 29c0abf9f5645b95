"""Where a study is computed: the table [cluster]. No number depends on it."""

import datetime
import re
from collections.abc import Mapping
from functools import partial
from typing import Any, NamedTuple

from ..ground import UserError
from .settings import TEXT, Key, as_text, filled, integer, matching, positive

LOCAL = "local"
MARGIN = 0.1  # of the walltime, at whose start a worker of a job retires
BATCHES_PER_LIFETIME = 20  # a worker that retires loses what it is computing
LEAST_WALLTIME = 60.0  # s
MEMORY = "[0-9.]+ ?[kMGT]i?B"
WORD, A_WORD = r"[\w.,:@%+/=-]*", "one word of letters, digits and .,:@%+/=-"


class BatchSystem(NamedTuple):
    """A batch system whose jobs can be workers, through dask-jobqueue."""

    jobqueue: str  # class of dask_jobqueue
    directives: tuple[str, ...]  # in every job script: we replace lost jobs ourselves
    trial: tuple[str, ...] = ()  # command that says of a job script whether it would be taken


BATCH_SYSTEMS = {"slurm": BatchSystem("SLURMCluster", ("--no-requeue",), ("sbatch", "--test-only"))}


class Cluster(NamedTuple):
    """Processes of this machine, the jobs of a batch system, or a scheduler that is there."""

    where: str = LOCAL  # or a batch system, or the address of a scheduler, tls://host:port
    patience: float = 600.0  # s to wait while there is no worker
    jobs: int = 1
    cores: int = 1  # of each job
    memory: str = "2GB"  # of each job
    walltime: str = "01:00:00"
    queue: str = ""
    account: str = ""
    interface: str = ""  # network interface between nodes
    log_folder: str = "results/jobs"
    prologue: tuple[str, ...] = ()  # lines of the job script before the workers start
    tls_ca_file: str = ""  # PEM; who has signed the certificates of a scheduler tls://host:port
    tls_cert: str = ""  # PEM; shows that scheduler who we are
    tls_key: str = ""  # PEM; of that certificate, unless it stands in the same file

    @property
    def lifetime(self) -> float:
        """Seconds after which a worker of a job retires, well before the job is ended."""
        return (1.0 - MARGIN) * walltime_seconds(self.walltime)

    @property
    def longest_batch(self) -> float:
        """Seconds that a batch may take at most."""
        in_jobs = self.where in BATCH_SYSTEMS
        return self.lifetime / BATCHES_PER_LIFETIME if in_jobs else float("inf")


THIS_MACHINE = Cluster()


def walltime_seconds(text: str) -> float:
    """Return the seconds of SLURM's "minutes", "[days-]hours:minutes:seconds" or the like."""
    found = re.fullmatch(r"(?:(\d+)-)?(\d+)(?::(\d+))?(?::(\d+))?", text)
    if not found:
        raise ValueError(text)
    days, *parts = found.groups()
    first, second, third = (int(part or 0) for part in parts)
    if days or parts[2]:  # hours come first
        return ((int(days or 0) * 24 + first) * 60 + second) * 60 + third
    return first * 60 + second


def _where(key: str, value: object) -> str:
    text = as_text(key, value)
    if text != LOCAL and text not in BATCH_SYSTEMS and "://" not in text:
        known = ", ".join((LOCAL, *BATCH_SYSTEMS))
        raise UserError(f"{key} = {text!r}: must be {known}, tls://host:port or tcp://host:port")
    return text


def _walltime(key: str, value: object) -> str:
    # What is not quoted is a time of day to TOML.
    text = as_text(key, str(value) if isinstance(value, datetime.time) else value)
    try:
        seconds = walltime_seconds(text)
    except ValueError:
        raise UserError(f'{key} = {text!r}: must be a time, as "12:00:00"') from None
    if seconds < LEAST_WALLTIME:
        raise UserError(f"{key} = {text!r}: must be at least {LEAST_WALLTIME:.0f} s")
    return text


def _line(key: str, value: object) -> str:
    """Return a text that stays within its line of a job script."""
    text = as_text(key, value)
    if not text.replace("\t", " ").isprintable():
        raise UserError(f"{key} = {text!r}: must be one line")
    return text


def _prologue(key: str, value: object) -> tuple[str, ...]:
    return tuple(_line(key, line) for line in (value if isinstance(value, list) else [value]))


ONE_WORD = partial(Key, partial(matching, pattern=WORD, words=A_WORD), default="")
PEM = partial(Key, _line, default="", values="the path of a file", schema=TEXT)
CLUSTER = {
    "where": Key(
        _where,
        "Where batches are computed: on the cores of this machine, as jobs of SLURM, or by a Dask "
        "scheduler at an address.",
        default=THIS_MACHINE.where,
        values='`"local"`, `"slurm"`, `"tls://host:port"` or `"tcp://host:port"`',
        schema={"type": "string", "pattern": "^(local|slurm)$|://"},
    ),
    "patience": Key(
        positive,
        "How long a run waits while there is no worker, no answer from any worker, or no disk "
        "that can be written.",
        "Doubled, a run gives up after twice the time.",
        "s",
        default=THIS_MACHINE.patience,
    ),
    "jobs": Key(
        partial(integer, least=1),
        "The number of jobs that are asked of the batch system.",
        "Doubled, twice as many workers compute, as far as the queue grants them.",
        default=THIS_MACHINE.jobs,
    ),
    "cores": Key(
        partial(integer, least=1),
        "The number of cores of each job. Each runs one worker of one thread.",
        "Doubled, each job has twice as many workers, which share `memory`.",
        default=THIS_MACHINE.cores,
    ),
    "memory": Key(
        partial(matching, pattern=MEMORY, words='a size, as "4GB"'),
        "The memory of each job. `plan` predicts what a worker needs.",
        "Doubled, each worker may use twice as much before it is ended; nothing gets quicker.",
        default=THIS_MACHINE.memory,
        values='a size such as `"4GB"`',
    ),
    "walltime": Key(
        _walltime,
        "The time after which the batch system ends a job. Workers retire at nine tenths of it, "
        "and no batch is predicted to take longer than a twentieth of that.",
        "Doubled, workers are replaced half as often, and jobs may wait longer in the queue.",
        default=THIS_MACHINE.walltime,
        values='a time such as `"12:00:00"` or `"1-00:00:00"`, at least a minute',
        schema={"type": "string", "pattern": "^([0-9]+-)?[0-9]+(:[0-9]+){0,2}$"},
    ),
    "queue": ONE_WORD(
        "The queue, or partition, of the batch system.",
        usual="that of the batch system",
    ),
    "account": ONE_WORD(
        "The account to which the jobs are charged.",
        usual="that of the batch system",
    ),
    "interface": ONE_WORD(
        'The network interface by which nodes reach each other, such as `"ib0"`.',
        usual="that which the system chooses",
    ),
    "log_folder": Key(
        _line,
        "The folder for what jobs print, from the working folder. Every node must see it, because "
        "certificates of a run lie beside it.",
        default=THIS_MACHINE.log_folder,
        values="one line of text",
        schema=TEXT,
    ),
    "prologue": Key(
        _prologue,
        'Lines of the job script before the workers start, such as `["module load python"]`. They '
        "run with your rights.",
        default=THIS_MACHINE.prologue,
        values="one line of text, or a list of them",
        schema={"type": ["string", "array"], "items": TEXT},
    ),
    "tls_ca_file": PEM(
        "A PEM file with the certificate of who has signed those of a scheduler `tls://…`.",
    ),
    "tls_cert": PEM(
        "A PEM file with the certificate that shows that scheduler who you are.",
    ),
    "tls_key": PEM(
        "A PEM file with the key of that certificate, unless the certificate's file holds it.",
    ),
}


def read_cluster(given: Mapping[str, Any]) -> Cluster:
    """Return what the checked values of a table [cluster] describe."""
    return Cluster(**filled("cluster", given, CLUSTER))
