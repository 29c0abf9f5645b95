"""The command ``run``: what it prints, its exit status."""

import argparse
import math
import os
import shlex
import sys
from pathlib import Path

from ..ground import UserError
from ..plan import TYPICAL, Pace, Plan, known_machine, learn, this_machine
from ..study import Measured, Study
from ..system import program
from .exit_status import DONE, FAILED, RESUMABLE
from .outline import announced_plan

UNTIMED = 3.0  # s; a study that takes less at the most ends before this machine is measured
OF_A_CLUSTER = ("scheduler", "workers", "batch_seconds")


def run_measured_study(options: argparse.Namespace, study: Measured, result: Path) -> int:
    """Run a measured study; return the exit status."""
    _check(options)
    for option in OF_A_CLUSTER:
        if getattr(options, option) is not None:
            name = option.replace("_", "-")
            raise UserError(f"--{name}: {study.name} is measured in one process; leave it out")
    from ..run import run_measured

    try:
        done = run_measured(study, result, _pace(study.script.outline(study.settings)[1]))
    except KeyboardInterrupt:
        print("interrupted; nothing was written, an earlier result is as it was", file=sys.stderr)
        return RESUMABLE
    learn(done.spent, done.typical)
    print(*done.lines, result, sep="\n")
    return DONE


def run_grid(options: argparse.Namespace, study: Study, result: Path) -> int:
    """Run a study of a grid; return the exit status."""
    _check(options)
    # Before dask is imported, for worker processes too: its warnings on shutdown are noise.
    os.environ.setdefault("DASK_LOGGING__DISTRIBUTED", "error")
    from ..run import RunOptions, run_plan

    plan = paced_plan(study)
    where = options.scheduler or options.batch_system or study.cluster.where
    same = {name: own for name, own in vars(options).items() if name in RunOptions._fields}
    how = RunOptions(study.cluster._replace(where=where), **same)
    summary = run_plan(plan, result, how)
    learn(summary.spent, summary.typical)
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


def paced_plan(study: Study) -> Plan:
    """Return the plan at the pace of this machine, or a typical one where that hardly matters."""
    if known := known_machine():
        return announced_plan(study, known.pace)
    plan = announced_plan(study, TYPICAL)
    pace = _pace(plan.prediction().high)
    return plan if pace is TYPICAL else announced_plan(study, pace)


def _pace(seconds: float) -> Pace:
    """Return the pace of this machine for a study that takes at most so long on the typical one.

    A machine that is not known yet is measured for studies that take longer than measuring it.
    """
    if known := known_machine():
        return known.pace
    return TYPICAL if seconds < UNTIMED else this_machine().pace


def resume_line(what: str) -> str:
    """Return how to go on with a run that ended early."""
    command = f"{program()} {shlex.join(sys.argv[1:])}"
    return f"{what}; what is finished is kept, to resume run again: {command}"


def _check(options: argparse.Namespace) -> None:
    if options.scheduler and options.batch_system:
        raise UserError(f"--scheduler and --{options.batch_system}: only one of them")
    if options.workers is not None and options.workers < 1:
        raise UserError(f"--workers {options.workers}: must be at least 1")
    if options.batch_seconds is not None and not 0.0 < options.batch_seconds < math.inf:
        raise UserError(f"--batch-seconds {options.batch_seconds}: must be a positive number")
    if options.max_failures < 0:
        raise UserError(f"--max-failures {options.max_failures}: must not be negative")
