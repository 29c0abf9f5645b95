"""The command ``prony``: a material for study.toml from measured moduli."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from ..errors import UserError
from ..study import FREQUENCIES, MODULI, Moduli, read_moduli
from ..system import write_durably

if TYPE_CHECKING:
    from ..reduce import PronyFit

DONE = 0
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
    said = [f"# {line}" for line in _said(options.file, measured, fit)]
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


def _said(file: str, measured: Moduli, fit: "PronyFit") -> list[str]:
    """Return what was fitted, how well, and what the data leave open."""
    omega = measured.omega
    lines = [
        f"{file}: {omega.size} frequencies, {omega[0]:.3g} ... {omega[-1]:.3g} rad/s, "
        f"read as {' and '.join(measured.units)}",
        f"{len(fit.branches)} branches; residual of G* {100 * fit.rms:.2g} % rms, "
        f"{100 * fit.worst:.2g} % at most",
    ]
    if not fit.determined:
        lines.append(
            f"the data do not determine the relaxed modulus: {fit.least:.3g} ... {fit.most:.3g} Pa "
            f"do as well; it wants frequencies below {omega[0]:.3g} rad/s"
        )
    return lines
