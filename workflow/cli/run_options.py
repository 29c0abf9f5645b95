"""The command ``run``: checks of its options, output and exit status."""

import argparse
import math
import os
import shlex
import sys
from pathlib import Path

from ..ground import UserError
from ..plan import Plan, make_plan
from ..study import Measured, Study
from ..system import program
from .exit_status import DONE, FAILED, RESUMABLE

SECONDS_PER_POINT = 1.5e-5  # planning time per point and variant
ANNOUNCED_SECONDS = 1.0  # planning time above which a message is printed
OF_A_CLUSTER = ("scheduler", "workers", "batch_seconds")  # options refused by measured studies


def run_measured_study(options: argparse.Namespace, study: Measured, result: Path) -> int:
    """Run a measured study and return the exit status."""
    _check(options)
    for option in OF_A_CLUSTER:
        if getattr(options, option) is not None:
            name = option.replace("_", "-")
            raise UserError(f"--{name}: {study.name} is measured in one process; leave it out")
    from ..run import run_measured

    try:
        lines = run_measured(study, result)
    except KeyboardInterrupt:
        print("interrupted; nothing was written, an earlier result is as it was", file=sys.stderr)
        return RESUMABLE
    print(*lines, result, sep="\n")
    return DONE


def run_grid(options: argparse.Namespace, study: Study, result: Path) -> int:
    """Run a study of a grid and return the exit status."""
    _check(options)
    # Set before dask is imported, also for worker processes, to hide its warnings on shutdown.
    os.environ.setdefault("DASK_LOGGING__DISTRIBUTED", "error")
    from ..run import RunOptions, run_plan

    plan = announced_plan(study)
    where = options.scheduler or options.batch_system or study.cluster.where
    shared = {name: value for name, value in vars(options).items() if name in RunOptions._fields}
    how = RunOptions(study.cluster._replace(where=where), **shared)
    summary = run_plan(plan, result, how)
    print("\n".join(summary.lines(plan)))
    if summary.failures:
        print("\n".join(summary.failures), file=sys.stderr)
    if summary.interrupted:
        print(resume_line("interrupted"), file=sys.stderr)
        return RESUMABLE
    if summary.written:
        print(result)
    else:
        print(f"stopped: more than {options.max_failures} problems failed", file=sys.stderr)
    return FAILED if summary.failures else DONE


def announced_plan(study: Study) -> Plan:
    """Return the plan of a study; print a message first if planning takes long."""
    points = math.prod(study.shape) * len(study.variants)
    seconds = SECONDS_PER_POINT * points
    if seconds > ANNOUNCED_SECONDS:
        print(f"Planning {points} points, about {seconds:.0f} s.", file=sys.stderr)
    return make_plan(study)


def resume_line(event: str) -> str:
    """Return a line with the command that resumes an interrupted run."""
    command = f"{program()} {shlex.join(sys.argv[1:])}"
    return f"{event}; what is finished is kept, to resume run again: {command}"


def _check(options: argparse.Namespace) -> None:
    if options.scheduler and options.batch_system:
        raise UserError(f"--scheduler and --{options.batch_system}: only one of them")
    if options.workers is not None and options.workers < 1:
        raise UserError(f"--workers {options.workers}: must be at least 1")
    if options.batch_seconds is not None and not 0.0 < options.batch_seconds < math.inf:
        raise UserError(f"--batch-seconds {options.batch_seconds}: must be a positive number")
    if options.max_failures < 0:
        raise UserError(f"--max-failures {options.max_failures}: must not be negative")
