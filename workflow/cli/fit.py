"""The command ``fit``: what measured velocity steps determine of the kinetic law."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from .. import (
    laboratory,  # slow to import, all but the units: other commands do without
)
from ..errors import UserError
from ..laboratory import TIMES, VELOCITIES
from ..system import make_folder

if TYPE_CHECKING:
    from ..laboratory import Known

DONE = 0


def add_fit_options(command: argparse.ArgumentParser) -> None:
    """Add what the command ``fit`` is told."""
    add = command.add_argument
    add("files", nargs="+", metavar="FILE", help="text file with time, velocity and friction")
    add("--columns", default="0,1,2", help="columns of time, velocity, friction, from 0 (0,1,2)")
    add("--time", choices=TIMES, help="unit of times (header, else s)")
    add("--velocity", choices=VELOCITIES, help="unit of velocities (header, else m/s)")
    add("--window", type=float, help="seconds after each step that are fitted, at most (all)")
    add("--relaxation-time", type=float, help="tau in s, where it is known from elsewhere")
    add("--hurst", type=float, help="H, where it is known from elsewhere")
    add("--q-max", type=float, help="q_max in 1/m, where it is known from elsewhere")
    add("--out", default="results/fit.png", help="figure, as PNG and PDF (results/fit.png)")


def run_fit(options: argparse.Namespace) -> int:
    """Read, fit, print and draw; return the exit status."""
    known = laboratory.Known(options.relaxation_time, options.hurst, options.q_max)
    _check(options, known)
    columns = _columns(options.columns)
    units = options.time, options.velocity
    records = [laboratory.read_record(Path(f), columns, *units) for f in options.files]
    fit = laboratory.fit_records(records, known, options.window)
    print(*laboratory.describe(fit), sep="\n")
    path = Path(options.out)
    make_folder(path.parent)
    print(*laboratory.draw_fit(fit, path), sep="\n")
    return DONE


def _columns(text: str) -> tuple[int, ...]:
    words = text.split(",")
    if len(words) != 3 or not all(word.strip().isdecimal() for word in words):
        raise UserError(f"--columns {text}: must be three numbers from 0, as 0,1,2")
    return tuple(map(int, words))


def _check(options: argparse.Namespace, known: "Known") -> None:
    positive = {"--window": options.window, "--q-max": known.q_max}
    positive["--relaxation-time"] = known.relaxation_time
    for name, value in positive.items():
        if value is not None and not 0.0 < value < float("inf"):
            raise UserError(f"{name} {value:g}: must be greater than zero")
    if known.hurst is not None and not 0.0 <= known.hurst <= 1.0:
        raise UserError(f"--hurst {known.hurst:g}: must lie between 0 and 1")
