"""Command line: elastomer-friction, or python -m workflow, with one command."""

import argparse
import json
import os
import sys
from pathlib import Path
from typing import Any

from .. import report
from ..errors import UserError
from ..result import check_result, result_file
from ..study import AnyStudy, find_study, known_studies, read_study
from ..system import program, version_of
from .animate import add_animate_options, run_animate
from .fit import add_fit_options, run_fit
from .kinds import KINDS
from .new import add_new_options, run_new, run_schema, run_studies
from .prony import add_prony_options, run_prony
from .run import DONE, RESUMABLE, add_run_options, resume_line
from .stores import add_merge_options, add_verify_options, run_merge, run_verify


def main(arguments: list[str] | None = None) -> int:
    """Run one command; return the exit status.

    0 done, 2 wrong input or surroundings, 3 done but for problems that failed, 130 interrupted.
    """
    command = ""  # not known yet
    try:
        options = _options(arguments)
        command = options.command
        return COMMANDS[command](options)
    except UserError as error:
        for each in error.errors:
            print(f"error: {each}{each.place}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        said = resume_line("aborted") if command == "run" else "interrupted"
        print(said, file=sys.stderr)
        return RESUMABLE


def _options(arguments: list[str] | None) -> argparse.Namespace:
    """Return what the command line asks for."""
    parser = command_parser()
    if "_ARGCOMPLETE" in os.environ:  # a shell asks what could be typed next
        import argcomplete

        argcomplete.autocomplete(parser)
    return parser.parse_args(arguments)


def command_parser() -> argparse.ArgumentParser:
    """Return the parser of the command line, with all commands."""
    parser = argparse.ArgumentParser(prog=program(), description=__doc__)
    version = f"elastomer-friction {version_of('elastomer-friction')}"
    parser.add_argument("--version", action="version", version=version)
    commands = parser.add_subparsers(dest="command", required=True)
    texts = {
        "plan": "say what a run would do and cost; compute nothing",
        "run": "compute what is missing and write the result file",
        "status": "say what is done and what is missing",
        "figure": "draw the figure of a finished run",
        "table": "write all coefficients of a finished run as CSV, with units",
        "animate": "draw one line of a scene on its way, as .gif or .mp4",
    }
    for name, text in texts.items():
        command = commands.add_parser(name, help=text, description=text)
        text = "a name under studies/ or the path of a TOML file"
        named: Any = command.add_argument("study", help=text)
        named.completer = lambda **_: sorted(known_studies())
        command.add_argument("--scale", help="one of the study's [scales.NAME] tables")
        command.add_argument(
            "--set",
            action="append",
            default=[],
            metavar="TABLE.KEY=VALUE",
            help="override one setting, e.g. grid.hurst=0.7 (repeatable)",
        )
        if name == "animate":
            add_animate_options(command)
            continue
        command.add_argument("--accuracy", help="as --set numerics.accuracy=0.01: 1%% or 0.01")
        command.add_argument(
            "--out", default="results", help="folder of results, or path of the .nc file"
        )
        if name == "run":
            add_run_options(command)
        if name == "figure":
            command.add_argument(
                "--script", type=Path, help="draws instead of the study's figure.py"
            )
        if name in ("plan", "status"):
            text = "print it as JSON: names, numbers in SI units, times in s, memory in bytes"
            command.add_argument("--json", action="store_true", help=text)
    text = (
        "write report.html, or report-SCALE.html: all figures, and the claims of the paper beside "
        "the results"
    )
    page = commands.add_parser("report", help=text, description=text)
    page.add_argument("studies", nargs="*", metavar="STUDY", help="studies to show (all)")
    page.add_argument("--scale", help="of the results: one of the studies' [scales.NAME] tables")
    page.add_argument("--out", default="results", help="folder of results")
    text = "list the studies that can be named, with their titles"
    commands.add_parser("studies", help=text, description=text)
    text = "write a commented study.toml to start from, in studies/NAME of the working folder"
    add_new_options(commands.add_parser("new", help=text, description=text))
    text = "print the JSON schema of study.toml, for editors that check and complete it"
    commands.add_parser("schema", help=text, description=text)
    text = "fit a Prony series to measured moduli G' and G'', and print the table [material]"
    add_prony_options(commands.add_parser("prony", help=text, description=text))
    text = "fit the kinetic law to measured velocity steps, and say what they determine of it"
    add_fit_options(commands.add_parser("fit", help=text, description=text))
    text = "check every line of a journal, every shard and every key in it; change nothing"
    add_verify_options(commands.add_parser("verify", help=text, description=text))
    text = "take over the finished work of another folder of results"
    add_merge_options(commands.add_parser("merge", help=text, description=text))
    return parser


def _study(options: argparse.Namespace) -> tuple[AnyStudy, Path]:
    settings = list(options.set)
    if options.accuracy is not None:
        settings.append(f"numerics.accuracy={_share(options.accuracy)!r}")
    study = read_study(options.study, options.scale, settings)
    return study, result_file(Path(options.out), study)


def _share(text: str) -> float:
    """Return 0.01 for 1% and for 0.01."""
    try:
        return float(text.removesuffix("%")) / (100.0 if text.endswith("%") else 1.0)
    except ValueError:
        raise UserError(f"--accuracy {text}: must be a number such as 1% or 0.01") from None


def _lines(options: argparse.Namespace) -> int:
    """Print what the commands plan and status say."""
    study, result = _study(options)
    lines, facts = KINDS[study.kind][options.command](study, result)
    settings = str(find_study(options.study).resolve())
    if options.json:
        head = {"study": study.name, "title": study.title, "result": str(result)}
        print(json.dumps(head | facts | {"settings": settings}, indent=1))
    else:
        print("\n".join([*lines, f"settings    {settings}"]))
    return DONE


def _run(options: argparse.Namespace) -> int:
    study, result = _study(options)
    return KINDS[study.kind]["run"](options, study, result)


def _figure(options: argparse.Namespace) -> int:
    print(*report.draw_figure(*_checked(options), options.script), sep="\n")
    return DONE


def _table(options: argparse.Namespace) -> int:
    study, result = _checked(options)
    print(*KINDS[study.kind]["table"](study, result), sep="\n")
    return DONE


def _checked(options: argparse.Namespace) -> tuple[AnyStudy, Path]:
    """Return the study and its result, which has been found to be one."""
    study, result = _study(options)
    check_result(study, result, asked=bool(options.scale or options.set or options.accuracy))
    return study, result


def _report(options: argparse.Namespace) -> int:
    print(report.write_report(Path(options.out), options.studies, options.scale))
    return DONE


COMMANDS = {
    "plan": _lines,
    "run": _run,
    "status": _lines,
    "figure": _figure,
    "table": _table,
    "report": _report,
    "animate": run_animate,
    "studies": run_studies,
    "new": run_new,
    "schema": run_schema,
    "prony": run_prony,
    "fit": run_fit,
    "verify": run_verify,
    "merge": run_merge,
}
