"""Where a study is computed: the table [cluster]. No number depends on it."""

import re
from dataclasses import dataclass, fields

from workflow.errors import UserError
from workflow.study.checks import as_text, check_keys, integer, positive

LOCAL, SLURM = "local", "slurm"

MARGIN = 0.1  # of the walltime, at whose start a worker of a job retires
BATCHES_PER_LIFETIME = 20  # a worker that retires loses what it is computing


@dataclass(frozen=True)
class Cluster:
    """Processes of this machine, the jobs of a batch system, or a scheduler that is there."""

    where: str = LOCAL  # or SLURM or the address of a scheduler, tcp://host:port
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

    @property
    def lifetime(self) -> float:
        """Seconds after which a worker of a job retires, well before the job is ended."""
        return (1.0 - MARGIN) * walltime_seconds(self.walltime)

    @property
    def longest_batch(self) -> float:
        """Seconds that a batch may take at most."""
        return self.lifetime / BATCHES_PER_LIFETIME if self.where == SLURM else float("inf")


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


HERE = Cluster()
LEAST_WALLTIME = 60.0  # s


def read_cluster(table: dict) -> Cluster:
    """Return what a table [cluster] describes. Raises UserError naming key and value."""
    names = tuple(field.name for field in fields(Cluster))
    check_keys("cluster.", table, names)
    found = {name: _value(f"cluster.{name}", name, value) for name, value in table.items()}
    return Cluster(**found)


def _value(key: str, name: str, value: object) -> object:
    if name in ("jobs", "cores"):
        return integer(key, value, 1)
    if name == "patience":
        return positive(key, value)
    if name == "prologue":
        lines = value if isinstance(value, list) else [value]
        return tuple(as_text(key, line) for line in lines)
    text = as_text(key, value)
    if name == "where" and text not in (LOCAL, SLURM) and "://" not in text:
        raise UserError(f"{key} = {text!r}: must be local, slurm or tcp://host:port")
    if name == "memory" and not re.fullmatch(r"[0-9.]+ ?[kMGT]i?B", text):
        raise UserError(f'{key} = {text!r}: must be a size, as "4GB"')
    if name == "walltime":
        _check_walltime(key, text)
    return text


def _check_walltime(key: str, text: str) -> None:
    try:
        seconds = walltime_seconds(text)
    except ValueError:
        raise UserError(f'{key} = {text!r}: must be a time, as "12:00:00"') from None
    if seconds < LEAST_WALLTIME:
        raise UserError(f"{key} = {text!r}: must be at least {LEAST_WALLTIME:.0f} s")
