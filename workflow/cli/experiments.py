"""The commands ``prony`` and ``fit``: what measurements determine of a material and of the law."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from .. import laboratory  # slow to import, all but the units: other commands do without
from ..errors import UserError
from ..laboratory import TIMES, VELOCITIES
from ..study import FREQUENCIES, MODULI, read_moduli
from ..system import make_folder, write_durably
from .run_options import DONE

if TYPE_CHECKING:
    pass

LEAST_SHARE = 1e-9  # of the stiffest branch, that a relaxed modulus is


def add_prony_options(command: argparse.ArgumentParser) -> None:
    """Add what the command ``prony`` is told."""
    add = command.add_argument
    add("file", help="text file with the columns frequency, G' and G''")
    add("--frequency", choices=FREQUENCIES, help="unit of frequencies (header, else rad/s)")
    add("--modulus", choices=MODULI, help="unit of moduli (header, else Pa)")
    add("--branches", type=int, help="branches at most (as few as describe the data as well)")
    add("--out", help="CSV file for the branches, to be named as material.branches_file")


def run_prony(options: argparse.Namespace) -> int:
    """Fit, print a table [material], write the branches if asked to; return the exit status."""
    if options.branches is not None and options.branches < 1:
        raise UserError(f"--branches {options.branches}: must be at least 1")
    measured = read_moduli(Path(options.file), options.frequency, options.modulus)
    from ..reduce import fit_prony

    fit = fit_prony(measured.omega, measured.values, options.branches)
    stiffest = max((modulus for modulus, _ in fit.branches), default=0.0)
    if not fit.branches or fit.shear_modulus < LEAST_SHARE * stiffest:
        lacking = "relaxed modulus" if fit.branches else "branches"
        raise UserError(f"prony {options.file}: the best fit has no {lacking}; is it a rubber?")
    omega = measured.omega
    said = [
        f"# {options.file}: {omega.size} frequencies, {omega[0]:.3g} ... {omega[-1]:.3g} rad/s, "
        f"read as {' and '.join(measured.units)}",
        f"# {len(fit.branches)} branches; residual of G* {100 * fit.rms:.2g} % rms, "
        f"{100 * fit.worst:.2g} % at most",
    ]
    if not fit.determined:
        said.append(
            f"# the data do not determine the relaxed modulus: {fit.least:.3g} ... {fit.most:.3g} "
            f"Pa do as well; it wants frequencies below {omega[0]:.3g} rad/s"
        )
    modulus = f"shear_modulus = {fit.shear_modulus:.6g}"
    rows = [f"{modulus:.6g}, {time:.6g}" for modulus, time in fit.branches]
    if options.out:
        lines = [*said, f"# {modulus}", "modulus [Pa], time [s]", *rows, ""]
        write_durably(Path(options.out), "\n".join(lines).encode())
        branches = [f'branches_file = "{options.out}"']
    else:
        branches = ["branches = [", *(f"    [{row}]," for row in rows), "]"]
    print(*said, "[material]", modulus, *branches, sep="\n")
    return DONE


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
    positive = {"--window": options.window, "--q-max": known.q_max}
    positive["--relaxation-time"] = known.relaxation_time
    for name, value in positive.items():
        if value is not None and not 0.0 < value < float("inf"):
            raise UserError(f"{name} {value:g}: must be greater than zero")
    if known.hurst is not None and not 0.0 <= known.hurst <= 1.0:
        raise UserError(f"--hurst {known.hurst:g}: must lie between 0 and 1")
    words = options.columns.split(",")
    if len(words) != 3 or not all(word.strip().isdecimal() for word in words):
        raise UserError(f"--columns {options.columns}: must be three numbers from 0, as 0,1,2")
    columns = tuple(map(int, words))
    units = options.time, options.velocity
    records = [laboratory.read_record(Path(f), columns, *units) for f in options.files]
    fit = laboratory.fit_records(records, known, options.window)
    print(*laboratory.describe(fit), sep="\n")
    path = Path(options.out)
    make_folder(path.parent)
    print(*laboratory.draw_fit(fit, path), sep="\n")
    return DONE
