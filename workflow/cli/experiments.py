"""The commands ``prony``, ``fit`` and ``spectrum``: fits to measurements."""

import argparse
import inspect
import math
import re
import tomllib
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from .. import laboratory, report  # slow to import, which other commands avoid
from ..ground import UserError
from ..study import INCOMPRESSIBLE, Moduli, read_measured_surface, read_moduli
from ..system import write_durably

NUMBERS = {  # of an option
    "--columns": "whole numbers from 0, as 0,1,2",
    "--temperatures": "numbers in °C, as -20,0,20",
}
SURFACE_OPTIONS = ("columns", "units", "step", "gaps", "spikes", "detrend", "periodic")


class FittedMaterial(dict[str, Any]):
    """Keys of the table [material], fitted to measured moduli; ``print`` shows the fit as TOML.

    residual : rms of the relative residual of G*. worst : its largest value.
    """

    def __init__(self, fit: laboratory.PronyFit, comments: list[str], keys: Sequence[str]) -> None:
        """Store a fit. comments : on the measurement and the fit. keys : lines of TOML."""
        self.fit, self.comments = fit, comments
        self.residual, self.worst = fit.rms, fit.worst
        self.keys_text = [f"shear_modulus = {fit.shear_modulus:.6g}", *keys]
        self.rows = [f"{modulus:.6g}, {time:.6g}" for modulus, time in fit.branches]
        listed = "branches = [", *(f"    [{row}]," for row in self.rows), "]"
        self.text = "\n".join([*comments, "[material]", *self.keys_text, *listed])
        super().__init__(tomllib.loads(self.text)["material"])

    def __str__(self) -> str:
        """Return the output of the command ``prony``."""
        return self.text


def fit_moduli(
    file: str | Path,
    *,
    columns: Sequence[int] | None = None,
    temperatures: Sequence[float] | None = None,
    reference: float | None = None,
    law: str | None = None,
    vertical: bool = False,
    start: float | None = None,
    frequency: str | None = None,
    modulus: str | None = None,
    poisson: float = INCOMPRESSIBLE,
    branches: int | None = None,
    figure: str | Path | None = None,
) -> FittedMaterial:
    """Fit a Prony series to measured moduli; return a material for ``scene.run``, a dictionary.

    Printed it is the output of the command ``prony``; its ``residual`` and ``worst`` are the rms
    and the largest residual of G*, relative.

    file, columns, temperatures, reference, law, vertical, frequency, modulus, poisson, branches,
    figure : as the options of the command. start : its option --from, in s.

    Raises UserError for invalid input, and for moduli that no Prony series describes.
    """
    if branches is not None and branches < 1:
        raise UserError(f"--branches {branches}: must be at least 1")
    if not -1.0 < poisson <= INCOMPRESSIBLE:
        raise UserError(f"--poisson {poisson:g}: must lie between -1 and 0.5")
    if start is not None and not 0.0 < start < math.inf:
        raise UserError(f"--from {start:g}: must be greater than zero")
    if columns is not None:
        _check_columns(columns, least=2)
    given = () if temperatures is None else temperatures
    if not all(map(math.isfinite, given)):
        raise _wrong("--temperatures", ",".join(map(str, given)))
    measured = read_moduli(Path(file), frequency, modulus, columns, poisson, given, start)
    shifting = laboratory.Shifting(reference, law, vertical)
    master = _at_one_temperature(str(file), shifting, measured)
    measured, keys = (master.moduli, master.keys) if master else (measured, ())
    fit = laboratory.fit_material(str(file), measured, branches)
    described = laboratory.describe_material(measured, fit, branches)
    if figure:
        (picture,) = report.write_figure(
            lambda: laboratory.figure_of_moduli(measured, fit, master), Path(figure)
        )
        described.append(f"figure: {picture.png}")
    comments = [f"# {line}" for line in (*measured.description, *described)]
    return FittedMaterial(fit, comments, keys)


def run_prony(options: argparse.Namespace) -> None:
    """Fit moduli, print a table [material], and write the branches if requested."""
    out = _output_of(options)
    given = {name: getattr(options, name) for name in inspect.signature(fit_moduli).parameters}
    given["columns"] = _parsed("--columns", options.columns, int)
    given["temperatures"] = _parsed("--temperatures", options.temperatures, float)
    material = fit_moduli(**given)
    printed = laboratory.FORMS[options.write](material.fit)
    if out:
        lines = [*material.comments, f"# {material.keys_text[0]}", "modulus [Pa], time [s]"]
        write_durably(out, "\n".join([*lines, *material.rows, ""]).encode())
        file = f'branches_file = "{_name_for_study(out)}"'
        printed = printed or ["[material]", *material.keys_text, file]
    print("\n".join([*material.comments, *printed]) if printed else material)


def _output_of(options: argparse.Namespace) -> Path | None:
    """Return the path of --out, if given. Raises UserError if it is the file that is read."""
    source, out = Path(options.file), Path(options.out) if options.out else None
    if out and out.exists() and source.exists() and out.samefile(source):
        raise UserError(f"--out {options.out}: is the measurement itself; name another file")
    return out


def _name_for_study(out: Path) -> str:
    """Return the name of a file for a study: relative if its folder is that of a study."""
    folder = out.resolve().parent
    beside = (folder / "study.toml").is_file() or folder.parent.name == "studies"
    return out.name if beside else out.resolve().as_posix()


def _at_one_temperature(
    file: str, shifting: laboratory.Shifting, measured: Moduli
) -> laboratory.MasterCurve | None:
    """Return the moduli shifted to one temperature; None if they are at one already."""
    if measured.temperatures is not None:
        return laboratory.master_curve(file, measured, shifting)
    if shifting != laboratory.Shifting():
        raise UserError(
            f"prony {file}: --reference, --law and --vertical shift sweeps at several "
            "temperatures; it holds one: give --temperatures, or a column of them"
        )
    return None


def _check_columns(columns: Sequence[int], least: int = 3) -> None:
    """Raise UserError unless columns are ``least`` to three whole numbers from 0."""
    whole = all(isinstance(column, int | np.integer) and column >= 0 for column in columns)
    if not whole or not least <= len(columns) <= 3:
        count = "three" if least == 3 else "two or three"
        given = ",".join(map(str, columns))
        raise UserError(f"--columns {given}: must be {count} numbers from 0, as 0,1,2")


def _parsed(option: str, words: str | None, number: type) -> Any:
    """Return the numbers of an option given as 0,1,2; None without it. Raises UserError."""
    try:
        return tuple(map(number, words.split(","))) if words else None
    except ValueError:
        raise _wrong(option, words) from None


def _wrong(option: str, given: object) -> UserError:
    return UserError(f"{option} {given}: must be {NUMBERS[option]}")


def run_fit(options: argparse.Namespace) -> None:
    """Fit the kinetic law to measured records, print and draw the fit."""
    known = laboratory.Known(options.relaxation_time, options.hurst, options.q_max)
    positive = {"--window": options.window, "--q-max": known.q_max}
    positive["--stiffness"] = options.stiffness
    positive["--relaxation-time"] = known.relaxation_time
    for name, value in positive.items():
        if value is not None and not 0.0 < value < float("inf"):
            raise UserError(f"{name} {value:g}: must be greater than zero")
    if known.hurst is not None and not 0.0 <= known.hurst <= 1.0:
        raise UserError(f"--hurst {known.hurst:g}: must lie between 0 and 1")
    columns = _parsed("--columns", options.columns, int)
    if columns:
        _check_columns(columns)
    units = options.time, options.velocity, options.displacement
    records = [laboratory.read_record(Path(f), columns, *units) for f in options.files]
    fit = laboratory.fit_records(records, known, options.window, options.stiffness)
    print(*laboratory.describe(fit), sep="\n")
    pictures = report.write_figure(lambda: laboratory.figure_of_fit(fit), Path(options.out))
    report.print_pictures(pictures)


def run_spectrum(options: argparse.Namespace) -> None:
    """Print and draw the parameters of a measured spectrum."""
    out, words = _output_of(options), options.columns.split(",") if options.columns else None
    given = {
        "file": options.file,
        "columns": words and [int(word) if word.strip().isdecimal() else word for word in words],
        "units": options.units and options.units.split(","),
        **{key: getattr(options, key) for key in SURFACE_OPTIONS[2:]},
    }
    try:
        profile = read_measured_surface({key: value for key, value in given.items() if value})
    except UserError as error:  # it names keys of a study, which are options of this command
        keys = rf"surface\.({'|'.join(SURFACE_OPTIONS)})\b"
        raise UserError(re.sub(keys, r"--\1", str(error))) from None
    spectrum = laboratory.spectrum_of(profile)
    longest = profile.measured_length / (1.5 if options.detrend == "parabola" else 1.0)
    fit = laboratory.fit_rolloff(spectrum, 2.0 * math.pi / longest)
    described = laboratory.describe_spectrum(profile, spectrum, fit)
    if out:
        lines = laboratory.spectrum_rows(spectrum, fit.last_q)
        write_durably(out, "\n".join([*lines, ""]).encode())
        instead = f'spectrum = {{file = "{_name_for_study(out)}", kind = "2D"}}'
        described.append(f"# or, in place of hurst and roughness: {instead}")
    print(*described, "# figure", sep="\n")
    pictures = report.write_figure(
        lambda: laboratory.figure_of_spectrum(spectrum, fit), Path(options.figure)
    )
    report.print_pictures(pictures)
