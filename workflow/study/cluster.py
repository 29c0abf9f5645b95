"""The table [cluster]: the workers that compute a study. Results do not depend on it."""

import datetime
import re
from collections.abc import Callable
from functools import partial
from typing import NamedTuple

from ..ground import UserError
from .settings import TEXT, Key, as_text, choice, integer, matching, positive

LOCAL = "local"
RETIREMENT_MARGIN = 0.1  # share of the walltime left when a worker of a job retires
BATCHES_PER_LIFETIME = 20  # minimum; a worker loses its current batch when it retires
MIN_WALLTIME_SECONDS = 60.0
MEMORY_PATTERN = "[0-9.]+ ?[kMGT]i?B"
WORD_PATTERN, WORD_DESCRIPTION = r"[\w.,:@%+/=-]*", "one word of letters, digits and .,:@%+/=-"


class BatchSystem(NamedTuple):
    """A batch system whose jobs can be workers, through dask-jobqueue."""

    jobqueue: str  # class of dask_jobqueue
    mark: str  # which begins a directive of a job script
    directives: tuple[str, ...]  # of this program, which replaces lost jobs itself
    standard_directives: tuple[str, ...]  # that dask-jobqueue writes
    trial: tuple[str, ...] = ()  # command that checks whether a job script would be accepted


BATCH_SYSTEMS = {
    "slurm": BatchSystem(
        "SLURMCluster",
        "#SBATCH",
        ("--no-requeue",),
        ("-J", "-e", "-o", "-p", "-A", "-n", "--cpus-per-task", "--mem", "-t"),
        ("sbatch", "--test-only"),
    )
}
MARKS = tuple(system.mark for system in BATCH_SYSTEMS.values())
OMISSIBLE_DIRECTIVES = tuple(
    word
    for system in BATCH_SYSTEMS.values()
    for word in (*system.directives, *system.standard_directives)
)


class Cluster(NamedTuple):
    """Workers: processes of this machine, jobs of a batch system, or those of a Dask scheduler."""

    where: str = LOCAL  # "local", a batch system, or the address of a scheduler
    patience: float = 600.0  # s to wait without a worker
    jobs: int = 1
    cores: int = 1  # of each job
    memory: str = "2GB"  # of each job
    walltime: str = "01:00:00"
    queue: str = ""
    account: str = ""
    interface: str = ""  # network interface between nodes
    log_folder: str = "results/jobs"
    prologue: tuple[str, ...] = ()  # lines of the job script before the workers start
    directives: tuple[str, ...] = ()  # of the job script, in addition
    leave_out: tuple[str, ...] = ()  # directives that are not written
    tls_ca_file: str = ""  # PEM; authority that signed the certificate of a scheduler tls://…
    tls_cert: str = ""  # PEM; identifies this client to the scheduler
    tls_key: str = ""  # PEM; key of that certificate, unless in the same file

    @property
    def lifetime(self) -> float:
        """Seconds after which a worker of a job retires, before the job's walltime ends."""
        return (1.0 - RETIREMENT_MARGIN) * walltime_seconds(self.walltime)

    @property
    def longest_batch(self) -> float:
        """Maximum predicted seconds of a batch."""
        in_jobs = self.where in BATCH_SYSTEMS
        return self.lifetime / BATCHES_PER_LIFETIME if in_jobs else float("inf")


THIS_MACHINE = Cluster()  # defaults


def walltime_seconds(text: str) -> float:
    """Return the seconds of a SLURM time such as "minutes" or "[days-]hours:minutes:seconds"."""
    match = re.fullmatch(r"(?:(\d+)-)?(\d+)(?::(\d+))?(?::(\d+))?", text)
    if not match:
        raise ValueError(text)
    days, *parts = match.groups()
    first, second, third = (int(part or 0) for part in parts)
    if days or parts[2]:  # the first number is hours
        return ((int(days or 0) * 24 + first) * 60 + second) * 60 + third
    return first * 60 + second


def _where(key: str, value: object) -> str:
    text = as_text(key, value)
    if text != LOCAL and text not in BATCH_SYSTEMS and "://" not in text:
        known = ", ".join((LOCAL, *BATCH_SYSTEMS))
        raise UserError(f"{key} = {text!r}: must be {known}, tls://host:port or tcp://host:port")
    return text


def _walltime(key: str, value: object) -> str:
    # TOML reads an unquoted 12:00:00 as a time of day.
    text = as_text(key, str(value) if isinstance(value, datetime.time) else value)
    try:
        seconds = walltime_seconds(text)
    except ValueError:
        raise UserError(f'{key} = {text!r}: must be a time such as "12:00:00"') from None
    if seconds < MIN_WALLTIME_SECONDS:
        raise UserError(f"{key} = {text!r}: must be at least {MIN_WALLTIME_SECONDS:.0f} s")
    return text


def _line(key: str, value: object) -> str:
    """Return a text without line breaks, for one line of a job script."""
    text = as_text(key, value)
    if not text.replace("\t", " ").isprintable():
        raise UserError(f"{key} = {text!r}: must be one line")
    return text


def _prologue_line(key: str, value: object) -> str:
    """Return a command of the job script. Raises UserError for a directive."""
    line = _line(key, value)
    if line.lstrip().startswith(MARKS):
        raise UserError(
            f"{key} = {line!r}: would stand below commands, where directives are ignored; give "
            f"cluster.directives = {line.split(maxsplit=1)[1:]}"
        )
    return line


def _directive(key: str, value: object) -> str:
    """Return the text of a directive, without its mark."""
    line = _line(key, value)
    if not line.startswith("-"):
        raise UserError(f'{key} = {line!r}: must begin with a hyphen, as "--qos=long"')
    return line


def _list_of(check: Callable[[str, object], str], key: str, value: object) -> tuple[str, ...]:
    return tuple(check(key, one) for one in (value if isinstance(value, list) else [value]))


ONE_WORD = partial(Key, partial(matching, pattern=WORD_PATTERN, words=WORD_DESCRIPTION), default="")
LINES = partial(
    Key,
    default=(),
    values="one line of text, or a list of them",
    schema={"type": ["string", "array"], "items": TEXT},
)
PEM = partial(Key, _line, default="", values="the path of a file", schema=TEXT)
CLUSTER = {
    "where": Key(
        _where,
        "The workers: processes of this machine, jobs of SLURM, or those of a Dask scheduler at "
        "an address.",
        default=THIS_MACHINE.where,
        values='`"local"`, `"slurm"`, `"tls://host:port"` or `"tcp://host:port"`',
        schema={"type": "string", "pattern": "^(local|slurm)$|://"},
    ),
    "patience": Key(
        positive,
        "The time that a run waits if no worker is there or answers, or the disk cannot be "
        "written.",
        "Doubled, a run gives up later.",
        "s",
        default=THIS_MACHINE.patience,
    ),
    "jobs": Key(
        partial(integer, least=1),
        "The number of jobs.",
        "Doubled, twice as many workers compute.",
        default=THIS_MACHINE.jobs,
    ),
    "cores": Key(
        partial(integer, least=1),
        "The number of cores, and of workers, of each job.",
        "Doubled, twice as many workers share `memory`.",
        default=THIS_MACHINE.cores,
    ),
    "memory": Key(
        partial(matching, pattern=MEMORY_PATTERN, words='a size such as "4GB"'),
        "The memory of each job. `plan` predicts the need of a worker.",
        "Doubled, each worker may use twice as much before it is killed.",
        default=THIS_MACHINE.memory,
        values='a size such as `"4GB"`',
    ),
    "walltime": Key(
        _walltime,
        "The time after which the batch system ends a job. Workers retire after 90 % of it; a "
        "batch must fit into it.",
        "Doubled, workers are replaced half as often.",
        default=THIS_MACHINE.walltime,
        values='a time such as `"12:00:00"` or `"1-00:00:00"`, at least a minute',
        schema={"type": "string", "pattern": "^([0-9]+-)?[0-9]+(:[0-9]+){0,2}$"},
    ),
    "queue": ONE_WORD(
        "The queue, or partition, of the batch system.",
        usual="the default of the batch system",
    ),
    "account": ONE_WORD(
        "The account that is charged for the jobs.",
        usual="the default of the batch system",
    ),
    "interface": ONE_WORD(
        'The network interface that connects the nodes, such as `"ib0"`.',
        usual="chosen by the system",
    ),
    "log_folder": Key(
        _line,
        "The folder for the output of jobs, relative to the working folder, to which every node "
        "needs access.",
        default=THIS_MACHINE.log_folder,
        values="one line of text",
        schema=TEXT,
    ),
    "prologue": LINES(
        partial(_list_of, _prologue_line),
        'Lines of the job script before the workers start, such as `["module load python"]`. They '
        "run with your rights.",
    ),
    "directives": LINES(
        partial(_list_of, _directive),
        'Further directives of the job script, such as `["--qos=long", "--gres=gpu:1"]`.',
    ),
    "leave_out": LINES(
        partial(_list_of, partial(choice, known=OMISSIBLE_DIRECTIVES)),
        'Directives that the job script leaves out, such as `"--mem"` where a site refuses it.',
        values=f"one or a list of {', '.join(OMISSIBLE_DIRECTIVES)}",
    ),
    "tls_ca_file": PEM(
        "A PEM file with the certificate of the authority that signed that of a scheduler `tls://…`.",
    ),
    "tls_cert": PEM(
        "A PEM file with the certificate that identifies you to that scheduler.",
    ),
    "tls_key": PEM(
        "A PEM file with the key of `tls_cert`, unless that file contains it.",
    ),
}
