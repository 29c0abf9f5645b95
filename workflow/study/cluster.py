"""Where a study is computed: the table [cluster]. No number depends on it."""

import re
from collections.abc import Callable
from functools import partial
from typing import NamedTuple

from ..errors import UserError
from .settings import Key, as_text, integer, positive, read_table

LOCAL = "local"
MARGIN = 0.1  # of the walltime, at whose start a worker of a job retires
BATCHES_PER_LIFETIME = 20  # a worker that retires loses what it is computing
LEAST_WALLTIME = 60.0  # s


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


HERE = Cluster()


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


def _memory(key: str, value: object) -> str:
    text = as_text(key, value)
    if not re.fullmatch(r"[0-9.]+ ?[kMGT]i?B", text):
        raise UserError(f'{key} = {text!r}: must be a size, as "4GB"')
    return text


def _walltime(key: str, value: object) -> str:
    text = as_text(key, value)
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


def _word(key: str, value: object) -> str:
    """Return a text that stays one word in a directive or a command of a job script."""
    text = as_text(key, value)
    if not re.fullmatch(r"[\w.,:@%+/=-]*", text):
        raise UserError(f"{key} = {text!r}: must be one word of letters, digits and .,:@%+/=-")
    return text


def _prologue(key: str, value: object) -> tuple[str, ...]:
    return tuple(_line(key, line) for line in (value if isinstance(value, list) else [value]))


CHECKS: dict[str, Callable[[str, object], object]] = {  # other keys are texts of one line
    "where": _where,
    "patience": positive,
    "jobs": partial(integer, least=1),
    "cores": partial(integer, least=1),
    "memory": _memory,
    "walltime": _walltime,
    "queue": _word,
    "account": _word,
    "interface": _word,
    "prologue": _prologue,
}
CLUSTER = {key: Key(CHECKS.get(key, _line), usual) for key, usual in HERE._asdict().items()}


def read_cluster(table: object) -> Cluster:
    """Return what a table [cluster] describes. Raises UserError naming key and value."""
    return Cluster(**read_table("cluster", table, CLUSTER))
