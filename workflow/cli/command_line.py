"""Command line: elastomer-friction, or python -m workflow, with one command."""

import argparse
import os
import re
import resource
import sys
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, NoReturn

from ..ground import UserError, did_you_mean, lacks_memory
from ..system import TEMPORARY_ERRORS, program, version_of
from .exit_status import DONE, RESUMABLE, WRONG

LAW_FORMATS = ("c", "fortran", "fmu", "json")  # written by `law`
MIN_ADDRESS_BYTES = 700 * 2**20  # address space in which all packages load
MAX_FAILURES = 10  # problems that may fail in a run, by default
PRONY_FORMATS = ("study", "abaqus", "ansys")  # printed by `prony`


def main(arguments: list[str] | None = None) -> int:
    """Run one command and return its exit status."""
    words = sys.argv[1:] if arguments is None else arguments
    interruption = "aborted before the start"
    try:
        if "_ARGCOMPLETE" in os.environ:  # set by a shell that requests completions
            import argcomplete

            argcomplete.autocomplete(command_parser())
        _check_surroundings(words)
        options = command_parser(words).parse_args(words)
        from .commands import ACTIONS  # slow to import and not needed by --help
        from .run_options import resume_line

        interruption = resume_line("aborted") if options.command == "run" else "interrupted"
        return ACTIONS[options.command](options) or DONE
    except UserError as error:
        for part in error.errors:
            print(f"error: {part}{part.place}", file=sys.stderr)
        return WRONG
    except (MemoryError, SystemError, ImportError, OSError) as error:
        if lacks_memory(error):
            problem = "the memory of this machine is full: free some of it, or reduce the grid"
        elif isinstance(error, OSError) and error.errno in TEMPORARY_ERRORS:
            problem = f"{error.filename or 'a file'}: {error.strerror}"
        else:
            raise
        print(f"error: {problem}; what is stored is kept", file=sys.stderr)
        return WRONG
    except KeyboardInterrupt:
        print(interruption, file=sys.stderr)
        return RESUMABLE


def _check_surroundings(words: Sequence[str]) -> None:
    """Raise UserError for non-UTF-8 paths, no folder for temporary files, or too little memory.

    Below MIN_ADDRESS_BYTES OpenBLAS waits forever for memory while it is loaded.
    """
    for text in (*words, str(Path.cwd())):
        try:
            text.encode()
        except UnicodeEncodeError:
            raise UserError(f"{text}: must be UTF-8, as netCDF requires; rename it") from None
    try:
        tempfile.gettempdir()
    except FileNotFoundError as error:
        message = f"TMPDIR: {error.strerror}; set it to a folder that can be written"
        raise UserError(message) from error
    limit, _ = resource.getrlimit(resource.RLIMIT_AS)
    if resource.RLIM_INFINITY != limit < MIN_ADDRESS_BYTES:
        least = f"must be at least {MIN_ADDRESS_BYTES // 1024} KiB; raise it in the shell"
        raise UserError(f"ulimit -v = {limit // 1024}: {least}")


class OneLineParser(argparse.ArgumentParser):
    """A parser that raises a one-line UserError for invalid options."""

    def error(self, message: str) -> NoReturn:
        """Raise UserError; for an unknown command with the most similar one."""
        if unknown := re.match(r"argument command: invalid choice: '(.*?)'", message):
            near = did_you_mean(unknown[1], COMMANDS)
            raise UserError(f"{unknown[1]}: is not a command{near}; see {self.prog} --help")
        raise UserError(f"{message}; see {self.prog} --help")


def command_parser(words: Sequence[str] | None = None) -> argparse.ArgumentParser:
    """Return the parser with the options of all commands, or only of the commands in ``words``.

    The options of some commands depend on packages that are slow to import.
    """
    parser = OneLineParser(prog=program(), description=__doc__)
    version = f"elastomer-friction {version_of('elastomer-friction')}"
    parser.add_argument("--version", action="version", version=version)
    commands = parser.add_subparsers(dest="command", required=True)
    for name, (text, add_options) in COMMANDS.items():
        command = commands.add_parser(name, help=text, description=text)
        if words is None or name in words:
            add_options(command)
    return parser


def _studies(**_: Any) -> list[str]:
    """Return the names of all studies, for shell completion."""
    from ..study import known_studies

    return sorted(known_studies())


def _no_options(command: argparse.ArgumentParser) -> None:
    """Add no options."""


def _study_options(command: argparse.ArgumentParser) -> None:
    """Add the options that select a study and its settings."""
    add: Any = command.add_argument
    named = add("study", help="a name under studies/ or the path of a TOML file")
    named.completer = _studies
    add("--scale", help="one of the study's [scales.NAME] tables")
    text = "override one setting, e.g. grid.hurst=0.7 (repeatable)"
    add("--set", action="append", default=[], metavar="TABLE.KEY=VALUE", help=text)


def _result_options(command: argparse.ArgumentParser) -> None:
    """Add the options that select a result of a study."""
    _study_options(command)
    command.add_argument("--accuracy", help="as --set numerics.accuracy=0.01: 1%% or 0.01")
    text = "folder of results, or path of the .nc file"
    command.add_argument("--out", default="results", help=text)


def _json_options(command: argparse.ArgumentParser) -> None:
    _result_options(command)
    text = "print JSON: names, numbers in SI units, times in s, memory in bytes"
    command.add_argument("--json", action="store_true", help=text)


def _plan_options(command: argparse.ArgumentParser) -> None:
    _json_options(command)
    text = "time random batches for about this time, in s, to estimate the core time"
    command.add_argument("--sample", type=float, metavar="SECONDS", help=text)


def _figure_options(command: argparse.ArgumentParser) -> None:
    _result_options(command)
    text = "script that replaces the study's figure.py"
    command.add_argument("--script", type=Path, help=text)


def _animate_options(command: argparse.ArgumentParser) -> None:
    _study_options(command)
    command.add_argument("--out", help="the .gif or .mp4 file (results/NAME.gif)")


def _explore_options(command: argparse.ArgumentParser) -> None:
    add: Any = command.add_argument
    add("result", metavar="RESULT", help="a result file, NAME.nc, or a study whose result is there")
    add("--scale", help="of the result: one of the study's [scales.NAME] tables")
    add("--out", type=Path, help="the page (NAME.html beside the result)")


def _report_options(command: argparse.ArgumentParser) -> None:
    add = command.add_argument
    add("studies", nargs="*", metavar="STUDY", help="studies to show (all)")
    add("--scale", help="of the results: one of the studies' [scales.NAME] tables")
    add("--out", default="results", help="folder of results")


def _new_options(command: argparse.ArgumentParser) -> None:
    command.add_argument("name", help="name of the study; its folder is created in studies/")


def _verify_options(command: argparse.ArgumentParser) -> None:
    text = "a folder of results, or a study whose results are in --out"
    command.add_argument("what", metavar="FOLDER|STUDY", help=text, nargs="?", default="results")
    command.add_argument("--out", default="results", help="folder of results of the study")


def _merge_options(command: argparse.ArgumentParser) -> None:
    command.add_argument("source", help="folder of results to copy finished work from")
    command.add_argument(
        "target", nargs="?", default="results", help="folder of results to copy it to"
    )
    text = "work without locks of the target's file system: no run may use it"
    command.add_argument("--no-lock", action="store_true", help=text)


def _run_options(command: argparse.ArgumentParser) -> None:
    from ..study import BATCH_SYSTEMS

    _result_options(command)
    add = command.add_argument
    add("--scheduler", help="address of a dask scheduler, tls://host:port")
    for name in BATCH_SYSTEMS:
        text = f"compute in jobs of {name.upper()}, see the table [cluster]"
        add(f"--{name}", action="store_const", const=name, dest="batch_system", help=text)
    add("--dashboard", action="store_true", help="start dask's dashboard and print its address")
    add("--workers", type=int, help="local worker processes (one per core, none for seconds)")
    add("--batch-seconds", type=float, help="predicted length of a batch (1 to 10)")
    add(
        "--max-failures",
        type=int,
        default=MAX_FAILURES,
        help="largest number of failed problems (%(default)s)",
    )
    add("--retry-failed", action="store_true", help="retry problems that failed in earlier runs")
    text = "refuse to mix records of different package versions or processors"
    add("--one-kind", action="store_true", help=text)
    text = "work without locks of the file system: no other run may use the results"
    add("--no-lock", action="store_true", help=text)


def _prony_options(command: argparse.ArgumentParser) -> None:
    from ..study import FREQUENCIES, INCOMPRESSIBLE, MODULI, SHIFT_KEYS

    add = command.add_argument
    add("file", help="text file with frequency, G' and G'' or tan delta, or E; or time and G or E")
    add("--columns", help="their columns, from 0, as 0,1,2 (default: by name or order)")
    # Otherwise argparse would interpret a value such as -20,0,20 as an option.
    command._negative_number_matcher = re.compile(r"-[\d.][\d.,eE+-]*$")
    add("--temperatures", help="of the sweeps in order, as -20,0,20 in °C (default: from the file)")
    add("--reference", type=float, help="reference temperature of the master curve, in °C (middle)")
    add("--law", choices=SHIFT_KEYS, help="law of the shifts (default: the best fit)")
    add("--vertical", action="store_true", help="shift moduli too, by b_T")
    text = "time in s at which a relaxation test begins to count (all above 0)"
    add("--from", dest="start", type=float, metavar="TIME", help=text)
    add("--frequency", choices=FREQUENCIES, help="unit of frequencies (header, else rad/s)")
    add("--modulus", choices=MODULI, help="unit of moduli (header, else Pa)")
    add("--poisson", type=float, default=INCOMPRESSIBLE, help="ratio, for moduli E (0.5)")
    add("--branches", type=int, help="largest number of branches (default: as few as possible)")
    add("--write", choices=PRONY_FORMATS, default="study", help="format of the output (study)")
    add("--out", help="CSV file for the branches, for material.branches_file")
    add("--figure", help="figure of moduli, fit and shifts, as PNG and PDF (none)")


def _spectrum_options(command: argparse.ArgumentParser) -> None:
    add = command.add_argument
    add("file", help="measured lines or a map, as for surface.file")
    add("--columns", help="of positions and heights, from 0 or by name, as 0,1 (from the file)")
    add("--units", help="of positions and heights, as mm,um (from the file)")
    add("--step", type=float, help="distance of samples in m, of a file without positions")
    for key in ("gaps", "spikes", "detrend", "periodic"):
        add(f"--{key}", help=f"as surface.{key}")
    text = "figure, as PNG and PDF (%(default)s)"
    add("--figure", default="results/spectrum.png", help=text)
    add("--out", help="file for surface.spectrum: C(q) of a map up to the cut-off")


def _fit_options(command: argparse.ArgumentParser) -> None:
    add = command.add_argument
    add("files", nargs="+", metavar="FILE", help="text file with time, velocity and friction")
    add("--columns", help="their columns, from 0, as 0,1,2 (default: by name or order)")
    add("--time", metavar="UNIT", help="unit of times, as ms (header, else s)")
    add("--velocity", metavar="UNIT", help="unit of velocities, as mm/min (header, else m/s)")
    add(
        "--displacement",
        metavar="UNIT",
        help="unit of displacements, if given instead of velocities",
    )
    add("--stiffness", type=float, help="of a soft machine, in N/m per N of normal force (1/m)")
    add("--window", type=float, help="longest time after each step in the fit, in s (all)")
    add("--relaxation-time", type=float, help="tau in s, if known")
    add("--hurst", type=float, help="H, if known")
    add("--q-max", type=float, help="q_max in 1/m, if known")
    add("--out", default="results/fit.png", help="figure, as PNG and PDF (results/fit.png)")


def _law_options(command: argparse.ArgumentParser) -> None:
    _study_options(command)
    add = command.add_argument
    add("--results", default="results", help="folder of results of the study")
    add("--group", help="a comparison of the study, instead of the study itself")
    text = "a value on an axis of the grid (repeatable; not needed for axes of one value); for a "
    text += "law, its normal_force or temperature"
    add("--at", action="append", metavar="AXIS=VALUE", help=text)
    add("--states", type=int, help="exponential states, 0 to 5 (2)")
    add("--kind", choices=("states", "rate-state", "lugre"), help="kind of law (states)")
    text = "a result of motions for the stated error, instead of cross-validation (repeatable)"
    add("--held-out", action="append", metavar="FILE", help=text)
    add("--write", choices=LAW_FORMATS, help="format of the written law (default: describe it)")
    add("--out", help="output file (default: standard output)")


# Description of each command and the function that adds its options.
COMMANDS: dict[str, tuple[str, Callable[[argparse.ArgumentParser], None]]] = {
    "plan": ("print what a run would compute and cost, without a run", _plan_options),
    "run": ("compute what is missing and write the result file", _run_options),
    "status": ("print the finished and the missing work", _json_options),
    "figure": ("draw the figure of a finished run", _figure_options),
    "table": ("write all coefficients of a finished run as CSV, with units", _result_options),
    "animate": ("animate one line of a scene as .gif or .mp4", _animate_options),
    "explore": (
        "write an HTML page to explore a result with sliders, without a network",
        _explore_options,
    ),
    "report": (
        "write report.html, or report-SCALE.html: all figures, and the claims of the paper "
        "with the results",
        _report_options,
    ),
    "studies": ("list all studies with their titles", _no_options),
    "new": ("write a commented study.toml as a starting point, to studies/NAME", _new_options),
    "schema": (
        "print the JSON schema of study.toml, for editors that check and complete it",
        _no_options,
    ),
    "prony": (
        "fit a Prony series to measured moduli G' and G'', and print the table [material]",
        _prony_options,
    ),
    "fit": ("fit the kinetic law to measured velocity steps", _fit_options),
    "spectrum": (
        "fit roll-off, cut-off and H to the spectrum of a measured surface, draw it, and print "
        "the keys of random surfaces like it",
        _spectrum_options,
    ),
    "law": (
        "fit a reduced law to the motions of a finished run, or of FILE.nc, and export it; "
        "FILE.json is a fitted law",
        _law_options,
    ),
    "verify": (
        "check every line of a journal, every shard and key, and the results; change nothing",
        _verify_options,
    ),
    "merge": ("copy the finished work of another folder of results", _merge_options),
}
