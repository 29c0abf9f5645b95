"""The commands ``prony`` and ``fit``: what measurements determine of a material and of the law."""

import argparse
import math
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from .. import laboratory, report  # slow to import: other commands do without
from ..ground import UserError
from ..study import INCOMPRESSIBLE, Moduli, read_moduli
from ..system import make_folder, write_durably
from .exit_status import DONE

if TYPE_CHECKING:
    from ..reduce import PronyFit

LEAST_SHARE = 1e-9  # of the stiffest branch, that a relaxed modulus is
LARGEST_RESIDUAL = 0.15  # rms of G*, of a material


def run_prony(options: argparse.Namespace) -> int:
    """Fit, print a table [material], write the branches if asked to; return the exit status."""
    if options.branches is not None and options.branches < 1:
        raise UserError(f"--branches {options.branches}: must be at least 1")
    if not -1.0 < options.poisson <= INCOMPRESSIBLE:
        raise UserError(f"--poisson {options.poisson:g}: must lie between -1 and 0.5")
    source, out = Path(options.file), Path(options.out) if options.out else None
    if out and out.exists() and source.exists() and out.samefile(source):
        raise UserError(f"--out {options.out}: is the measurement itself; name another file")
    units = options.frequency, options.modulus
    columns = columns_of(options.columns, (2, 3)) if options.columns else None
    temperatures = _temperatures(options.temperatures) if options.temperatures else ()
    measured = read_moduli(source, *units, columns, options.poisson, temperatures)
    measured, keys = _at_one_temperature(options, measured)
    from ..reduce import fit_prony

    fit = fit_prony(measured.omega, measured.values, options.branches)
    _check_fit(options, measured, fit)
    said = [f"# {line}" for line in (*measured.told, *_described(measured, fit, options.branches))]
    rows = [f"{modulus:.6g}, {time:.6g}" for modulus, time in fit.branches]
    modulus = f"shear_modulus = {fit.shear_modulus:.6g}"
    table = ["[material]", modulus, *keys]
    listed = ["branches = [", *(f"    [{row}]," for row in rows), "]"]
    if out:
        lines = [*said, f"# {modulus}", "modulus [Pa], time [s]", *rows, ""]
        write_durably(out, "\n".join(lines).encode())
        beside = (out.parent / "study.toml").is_file()
        listed = [f'branches_file = "{out.name if beside else out.resolve().as_posix()}"']
    printed = FORMS[options.write](fit) or [*table, *listed]
    print(*said, *printed, sep="\n")
    return DONE


def _at_one_temperature(
    options: argparse.Namespace, measured: Moduli
) -> tuple[Moduli, tuple[str, ...]]:
    """Return the moduli, shifted to one temperature where they are of several, and lines of it."""
    asked = laboratory.Shifting(options.reference, options.law, options.vertical)
    if measured.temperatures is not None:
        return laboratory.master_curve(options.file, measured, asked)
    if asked != laboratory.Shifting():
        raise UserError(
            f"prony {options.file}: --reference, --law and --vertical shift sweeps at several "
            "temperatures; it holds one: give --temperatures, or a column of them"
        )
    return measured, ()


def _check_fit(options: argparse.Namespace, measured: Moduli, fit: "PronyFit") -> None:
    """Raise UserError where a fit is none, or is of no foundation that carries a load."""
    where = f"prony {options.file}"
    stiffest = max((modulus for modulus, _ in fit.branches), default=0.0)
    if fit.dense > LARGEST_RESIDUAL:
        raise UserError(
            f"{where}: no Prony series describes it: {100 * fit.dense:.2g} % of the moduli are "
            f"left over, more than {100 * LARGEST_RESIDUAL:g} %; {measured.told[0]}; give other "
            "--columns or units, and the temperatures of all sweeps"
        )
    if fit.rms > LARGEST_RESIDUAL:
        raise UserError(
            f"{where}: {options.branches} branches are too few: {100 * fit.rms:.2g} % of G* are "
            f"left over, by as many as are wanted {100 * fit.dense:.2g} %; give more --branches"
        )
    if not fit.branches or fit.shear_modulus < LEAST_SHARE * stiffest:
        lacking = "relaxed modulus" if fit.branches else "branches"
        raise UserError(f"{where}: the best fit has no {lacking}; is it a rubber?")


def _described(measured: Moduli, fit: "PronyFit", asked: int | None) -> list[str]:
    """Return what was fitted and how well, in sentences."""
    omega = measured.omega
    said = [
        f"{omega.size} times, {1.0 / omega[-1]:.3g} ... {1.0 / omega[0]:.3g} s"
        if measured.over_time
        else f"{omega.size} frequencies, {omega[0]:.3g} ... {omega[-1]:.3g} rad/s",
        f"{len(fit.branches)} branches; residual of {'G' if measured.over_time else 'G*'} "
        f"{100 * fit.rms:.2g} % rms, "
        f"{100 * fit.worst:.2g} % at most; what is slower than {fit.slowest:.3g} s counts as "
        "relaxed",
    ]
    ends = (1.0 / omega[0], "s down") if measured.over_time else (omega[0], "rad/s")
    first = f"{ends[0]:.3g} {ends[1]}"
    decades = _per_decade(measured, fit)
    said.append(
        f"residual per decade from {first}: {', '.join(f'{100 * one:.2g}' for one in decades)} %"
    )
    if decades.max() > LARGEST_RESIDUAL:
        said.append(
            f"beware: more than {100 * LARGEST_RESIDUAL:g} % are left over in decade "
            f"{decades.argmax() + 1} of them: leave out these rows, or take no result from there"
        )
    if asked is not None and fit.rms > 2.0 * fit.dense:
        said.append(f"{asked} branches are too few: more of them leave {100 * fit.dense:.2g} % rms")
    if not fit.determined:
        said.append(
            f"the data do not determine the relaxed modulus: {fit.least:.3g} ... {fit.most:.3g} "
            f"Pa do as well; it wants "
            + (
                f"times beyond {ends[0]:.3g} s"
                if measured.over_time
                else f"frequencies below {first}"
            )
        )
    return said


def _per_decade(measured: Moduli, fit: "PronyFit") -> np.ndarray:
    """Return the rms residual in each decade of the frequency that holds one."""
    decade = np.floor(np.log10(measured.omega / measured.omega[0]) + 1e-9)
    squares = [np.mean(fit.residual[decade == each] ** 2) for each in np.unique(decade)]
    return np.sqrt(squares)


def _shares(fit: "PronyFit") -> tuple[float, list[tuple[float, float]]]:
    """Return G_0 (Pa) at once after a step, and the branches as shares of it."""
    whole = fit.shear_modulus + sum(modulus for modulus, _ in fit.branches)
    return whole, [(modulus / whole, time) for modulus, time in fit.branches]


def _for_abaqus(fit: "PronyFit") -> list[str]:
    whole, shares = _shares(fit)
    head = f"** shares of the instantaneous G_0 = {whole:.6g} Pa; g_i, k_i, tau_i in s"
    rows = [f"{share:.6g}, 0, {time:.6g}" for share, time in shares]
    return [head, "*VISCOELASTIC, TIME=PRONY", *rows]


def _for_ansys(fit: "PronyFit") -> list[str]:
    whole, shares = _shares(fit)
    head = f"! shares of the instantaneous G_0 = {whole:.6g} Pa; alpha_i, tau_i in s"
    values = [f"TBDATA,{2 * i + 1},{a:.6g},{t:.6g}" for i, (a, t) in enumerate(shares)]
    return [head, f"TB,PRONY,1,1,{len(shares)},SHEAR", *values]


FORMS: dict[str, Callable[["PronyFit"], list[str]]] = {
    "study": lambda _: [],
    "abaqus": _for_abaqus,
    "ansys": _for_ansys,
}


def columns_of(words: str, counts: tuple[int, ...] = (3,)) -> tuple[int, ...]:
    """Return so many numbers of columns that are given as 0,1,2. Raises UserError."""
    each = words.split(",")
    if len(each) not in counts or not all(word.strip().isdecimal() for word in each):
        raise UserError(f"--columns {words}: must be three numbers from 0, as 0,1,2")
    return tuple(map(int, each))


def _temperatures(words: str) -> tuple[float, ...]:
    """Return temperatures in °C that are given as -20,0,20. Raises UserError."""
    try:
        found = tuple(map(float, words.split(",")))
    except ValueError:
        found = (math.nan,)
    if not all(map(math.isfinite, found)):
        raise UserError(f"--temperatures {words}: must be numbers in °C, as -20,0,20")
    return found


def run_fit(options: argparse.Namespace) -> int:
    """Read, fit, print and draw; return the exit status."""
    known = laboratory.Known(options.relaxation_time, options.hurst, options.q_max)
    positive = {"--window": options.window, "--q-max": known.q_max}
    positive["--stiffness"] = options.stiffness
    positive["--relaxation-time"] = known.relaxation_time
    for name, value in positive.items():
        if value is not None and not 0.0 < value < float("inf"):
            raise UserError(f"{name} {value:g}: must be greater than zero")
    if known.hurst is not None and not 0.0 <= known.hurst <= 1.0:
        raise UserError(f"--hurst {known.hurst:g}: must lie between 0 and 1")
    columns = columns_of(options.columns) if options.columns else None
    units = options.time, options.velocity, options.displacement
    records = [laboratory.read_record(Path(f), columns, *units) for f in options.files]
    fit = laboratory.fit_records(records, known, options.window, options.stiffness)
    print(*laboratory.describe(fit), sep="\n")
    path = Path(options.out)
    make_folder(path.parent)
    report.print_pictures(laboratory.draw_fit(fit, path))
    return DONE
