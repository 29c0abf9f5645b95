"""The commands ``prony``, ``fit`` and ``spectrum``: fits to measurements."""

import argparse
import math
from pathlib import Path
from typing import NamedTuple

from .. import laboratory, report  # slow to import, which other commands avoid
from ..ground import UserError
from ..study import INCOMPRESSIBLE, Moduli, read_measured_surface, read_moduli
from ..system import make_folder, write_durably
from .exit_status import DONE


class MaterialTable(NamedTuple):
    """Material fitted to moduli, and its lines of TOML."""

    fit: laboratory.PronyFit
    comments: list[str]  # the measurement, the fit and its quality
    keys: list[str]  # of [material], without the branches
    branches: list[str]  # modulus (Pa) and time (s)

    def listed(self) -> list[str]:
        """Return the key ``branches``, one branch a line."""
        return ["branches = [", *(f"    [{row}]," for row in self.branches), "]"]


def material_table(options: argparse.Namespace) -> MaterialTable:
    """Fit the options' file of moduli. Raises UserError for invalid options."""
    if options.branches is not None and options.branches < 1:
        raise UserError(f"--branches {options.branches}: must be at least 1")
    if not -1.0 < options.poisson <= INCOMPRESSIBLE:
        raise UserError(f"--poisson {options.poisson:g}: must lie between -1 and 0.5")
    if options.start is not None and not 0.0 < options.start < math.inf:
        raise UserError(f"--from {options.start:g}: must be greater than zero")
    source = Path(options.file)
    units = options.frequency, options.modulus
    columns = columns_of(options.columns, (2, 3)) if options.columns else None
    temperatures = _temperatures(options.temperatures) if options.temperatures else ()
    measured = read_moduli(source, *units, columns, options.poisson, temperatures, options.start)
    master = _at_one_temperature(options, measured)
    measured, keys = (master.moduli, master.keys) if master else (measured, ())
    fit = laboratory.fit_material(options.file, measured, options.branches)
    described = laboratory.describe_material(measured, fit, options.branches)
    if options.figure:
        path = Path(options.figure)
        make_folder(path.parent)
        (picture,) = laboratory.draw_moduli(measured, fit, master, path)
        described.append(f"figure: {picture.png}")
    comments = [f"# {line}" for line in (*measured.description, *described)]
    rows = [f"{modulus:.6g}, {time:.6g}" for modulus, time in fit.branches]
    modulus = f"shear_modulus = {fit.shear_modulus:.6g}"
    return MaterialTable(fit, comments, [modulus, *keys], rows)


def run_prony(options: argparse.Namespace) -> int:
    """Fit moduli, print a table [material], write the branches if requested; return the status."""
    out = _output_of(options)
    table = material_table(options)
    listed = table.listed()
    if out:
        lines = [*table.comments, f"# {table.keys[0]}", "modulus [Pa], time [s]", *table.branches]
        write_durably(out, "\n".join([*lines, ""]).encode())
        listed = [f'branches_file = "{_name_for_study(out)}"']
    printed = laboratory.FORMS[options.write](table.fit) or ["[material]", *table.keys, *listed]
    print(*table.comments, *printed, sep="\n")
    return DONE


def _output_of(options: argparse.Namespace) -> Path | None:
    """Return the path of --out, if given. Raises UserError if it is the file that is read."""
    source, out = Path(options.file), Path(options.out) if options.out else None
    if out and out.exists() and source.exists() and out.samefile(source):
        raise UserError(f"--out {options.out}: is the measurement itself; name another file")
    return out


def _name_for_study(out: Path) -> str:
    """Return the name of a file for a study: relative to a study beside it, else absolute."""
    beside = (out.parent / "study.toml").is_file()
    return out.name if beside else out.resolve().as_posix()


def _at_one_temperature(
    options: argparse.Namespace, measured: Moduli
) -> laboratory.MasterCurve | None:
    """Return the moduli shifted to one temperature; None if they are at one already."""
    requested = laboratory.Shifting(options.reference, options.law, options.vertical)
    if measured.temperatures is not None:
        return laboratory.master_curve(options.file, measured, requested)
    if requested != laboratory.Shifting():
        raise UserError(
            f"prony {options.file}: --reference, --law and --vertical shift sweeps at several "
            "temperatures; it holds one: give --temperatures, or a column of them"
        )
    return None


def columns_of(words: str, counts: tuple[int, ...] = (3,)) -> tuple[int, ...]:
    """Parse column numbers given as 0,1,2; raise UserError unless their number is in ``counts``."""
    fields = words.split(",")
    if len(fields) not in counts or not all(word.strip().isdecimal() for word in fields):
        raise UserError(f"--columns {words}: must be three numbers from 0, as 0,1,2")
    return tuple(map(int, fields))


def _temperatures(words: str) -> tuple[float, ...]:
    """Parse temperatures in °C given as -20,0,20. Raises UserError for other text."""
    try:
        temperatures = tuple(map(float, words.split(",")))
    except ValueError:
        temperatures = (math.nan,)
    if not all(map(math.isfinite, temperatures)):
        raise UserError(f"--temperatures {words}: must be numbers in °C, as -20,0,20")
    return temperatures


def run_fit(options: argparse.Namespace) -> int:
    """Fit the kinetic law to measured records, print and draw the fit; return the exit status."""
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


def run_spectrum(options: argparse.Namespace) -> int:
    """Print and draw the parameters of a measured spectrum; return the exit status."""
    out, words = _output_of(options), options.columns.split(",") if options.columns else None
    given = {
        "file": options.file,
        "columns": words and [int(word) if word.strip().isdecimal() else word for word in words],
        "units": options.units and options.units.split(","),
        **{key: getattr(options, key) for key in ("step", "gaps", "spikes", "detrend", "periodic")},
    }
    profile = read_measured_surface({key: value for key, value in given.items() if value})
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
    path = Path(options.figure)
    make_folder(path.parent)
    report.print_pictures(laboratory.draw_spectrum(spectrum, fit, path))
    return DONE
