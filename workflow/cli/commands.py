"""Command line: elastomer-friction, or python -m workflow, with one command."""

import argparse
import contextlib
import json
import os
import re
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple, NoReturn

from .. import report, scene
from ..errors import UserError, printable
from ..result import check_result, result_file
from ..run import result_line, status_lines
from ..store import Verified, holds_a_store, merge_into, store_folder
from ..study import (
    AnyStudy,
    find_study,
    known_studies,
    load_tables,
    read_scene,
    read_study,
    study_schema,
)
from ..system import make_folder, program, version_of, write_durably
from .experiments import add_fit_options, add_prony_options, run_fit, run_prony
from .law_command import add_law_options, run_law
from .outline import outline_grid, outline_measured
from .run_options import (
    DONE,
    FAILED,
    RESUMABLE,
    add_run_options,
    resume_line,
    run_grid,
    run_measured_study,
)

SHOWN = ["trace", "snapshots"]  # what an animation is drawn from
TEMPLATE = Path(__file__).with_name("study.toml")
NO_TITLE = "(its study.toml cannot be read)"

# Of each kind of study what `plan` and `status` print, as lines and as data for --json, and what
# `run` does and returns as exit status; each takes the study and its result file.
KINDS: dict[str, dict[str, Callable[..., Any]]] = {
    "grid": {
        "plan": outline_grid,
        "run": run_grid,
        "status": lambda study, result: status_lines(study, result, store_folder(result)),
    },
    "measured": {
        "plan": outline_measured,
        "run": run_measured_study,
        "status": lambda study, result: ([result_line(result)], {"written": result.is_file()}),
    },
}


def main(arguments: list[str] | None = None) -> int:
    """Run one command; return the exit status.

    0 done, 2 wrong input or surroundings, 3 done but for problems that failed, 130 interrupted.
    """
    command = ""  # not known yet
    try:
        parser = command_parser()
        if "_ARGCOMPLETE" in os.environ:  # a shell asks what could be typed next
            import argcomplete

            argcomplete.autocomplete(parser)
        options = parser.parse_args(arguments)
        command = options.command
        return COMMANDS[command].run(options)
    except UserError as error:
        for each in error.errors:
            print(f"error: {each}{each.place}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        said = resume_line("aborted") if command == "run" else "interrupted"
        print(said, file=sys.stderr)
        return RESUMABLE


class OneLineParser(argparse.ArgumentParser):
    """Says in one line what is wrong with the options, as with any other input."""

    def error(self, message: str) -> NoReturn:
        """Raise UserError."""
        raise UserError(f"{message}; see {self.prog} --help")


def command_parser() -> argparse.ArgumentParser:
    """Return the parser of the command line, with all commands."""
    parser = OneLineParser(prog=program(), description=__doc__)
    version = f"elastomer-friction {version_of('elastomer-friction')}"
    parser.add_argument("--version", action="version", version=version)
    commands = parser.add_subparsers(dest="command", required=True)
    for name, (text, add_options, _) in COMMANDS.items():
        add_options(commands.add_parser(name, help=text, description=text))
    return parser


def _no_options(command: argparse.ArgumentParser) -> None:
    """Add nothing."""


def _study_options(command: argparse.ArgumentParser) -> None:
    """Add what says which study is meant, and with which settings."""
    add: Any = command.add_argument
    named = add("study", help="a name under studies/ or the path of a TOML file")
    named.completer = lambda **_: sorted(known_studies())
    add("--scale", help="one of the study's [scales.NAME] tables")
    text = "override one setting, e.g. grid.hurst=0.7 (repeatable)"
    add("--set", action="append", default=[], metavar="TABLE.KEY=VALUE", help=text)


def _result_options(command: argparse.ArgumentParser) -> None:
    """Add what says which result of which study is meant."""
    _study_options(command)
    command.add_argument("--accuracy", help="as --set numerics.accuracy=0.01: 1%% or 0.01")
    text = "folder of results, or path of the .nc file"
    command.add_argument("--out", default="results", help=text)


def _json_options(command: argparse.ArgumentParser) -> None:
    _result_options(command)
    text = "print it as JSON: names, numbers in SI units, times in s, memory in bytes"
    command.add_argument("--json", action="store_true", help=text)


def _run_options(command: argparse.ArgumentParser) -> None:
    _result_options(command)
    add_run_options(command)


def _figure_options(command: argparse.ArgumentParser) -> None:
    _result_options(command)
    text = "draws instead of the study's figure.py"
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


def _law_options(command: argparse.ArgumentParser) -> None:
    _study_options(command)
    add_law_options(command)


def _new_options(command: argparse.ArgumentParser) -> None:
    command.add_argument("name", help="of the study; its folder is made in studies/")


def _verify_options(command: argparse.ArgumentParser) -> None:
    text = "a folder of results, or a study whose results are in --out"
    command.add_argument("what", metavar="FOLDER|STUDY", help=text, nargs="?", default="results")
    command.add_argument("--out", default="results", help="folder of results of the study")


def _merge_options(command: argparse.ArgumentParser) -> None:
    command.add_argument("source", help="folder of results whose finished work is taken over")
    command.add_argument("target", nargs="?", default="results", help="folder that takes it over")
    text = "go on where the file system of the target has no locks: no run may use it"
    command.add_argument("--no-lock", action="store_true", help=text)


def _study(options: argparse.Namespace) -> tuple[AnyStudy, Path]:
    settings = list(options.set)
    if (text := options.accuracy) is not None:
        try:
            share = float(text.removesuffix("%")) / (100.0 if text.endswith("%") else 1.0)
        except ValueError:
            message = f"--accuracy {text}: must be a number such as 1% or 0.01"
            raise UserError(message) from None
        settings.append(f"numerics.accuracy={share!r}")
    study = read_study(options.study, options.scale, settings)
    return study, result_file(Path(options.out), study)


def _lines(options: argparse.Namespace) -> int:
    """Print what the commands plan and status say."""
    study, result = _study(options)
    lines, facts = KINDS[study.kind][options.command](study, result)
    settings = str(find_study(options.study).resolve())
    if options.json:
        head = {"study": study.name, "title": study.title, "result": str(result)}
        print(json.dumps(head | facts | {"settings": settings}, indent=1))
    else:
        print("\n".join(map(printable, [*lines, f"settings    {settings}"])))
    return DONE


def _run(options: argparse.Namespace) -> int:
    study, result = _study(options)
    return KINDS[study.kind]["run"](options, study, result)


def _figure(options: argparse.Namespace) -> int:
    print(*report.draw_figure(*_checked(options), options.script), sep="\n")
    return DONE


def _table(options: argparse.Namespace) -> int:
    print(*report.write_table(*_checked(options)), sep="\n")
    return DONE


def _checked(options: argparse.Namespace) -> tuple[AnyStudy, Path]:
    """Return the study and its result, which has been found to be one."""
    study, result = _study(options)
    check_result(study, result, asked=bool(options.scale or options.set or options.accuracy))
    return study, result


def _report(options: argparse.Namespace) -> int:
    print(report.write_report(Path(options.out), options.studies, options.scale))
    return DONE


def _explore(options: argparse.Namespace) -> int:
    result = Path(options.result)
    if result.suffix != ".nc":
        study = read_study(options.result, options.scale)
        result = result_file(Path("results"), study)
        check_result(study, result, asked=bool(options.scale))
    print(report.write_explorer(result, options.out))
    return DONE


def _animate(options: argparse.Namespace) -> int:
    """Compute the first line of a scene in this process and draw it."""
    study = read_scene(options.study, options.scale, options.set, SHOWN)
    path = Path(options.out or f"results/{study.name}.gif")
    report.check_animation(path)
    make_folder(path.parent)
    print(report.animate(scene.computed(study), path))
    return DONE


def _studies(_: argparse.Namespace) -> int:
    """Print name and title of every study that can be named."""
    known = known_studies()
    width = max(map(len, known))
    for name, path in sorted(known.items()):
        title = NO_TITLE
        with contextlib.suppress(UserError, RecursionError, LookupError, TypeError):
            title = str(load_tables(path, None, [])[0]["study"]["title"])
        print(printable(f"{name:{width}}  {title}"))
    return DONE


def _schema(_: argparse.Namespace) -> int:
    print(json.dumps(study_schema(), indent=1, ensure_ascii=False))
    return DONE


def _new(options: argparse.Namespace) -> int:
    """Write a study.toml to start from."""
    name = options.name
    if not re.fullmatch(r"[A-Za-z][\w-]*", name, re.ASCII):
        raise UserError(f"new {name!r}: name it by letters, digits, hyphens and underscores")
    path = Path("studies") / name.replace("-", "_") / "study.toml"
    known = known_studies().get(path.parent.name)
    if path.exists() or known:
        raise UserError(f"new {name}: there is such a study already, {known or path}")
    make_folder(path.parent)
    text = TEMPLATE.read_text(encoding="utf-8").replace("NAME", name)
    write_durably(path, text.encode())
    print(f"{path}: edit it, then: {program()} plan {name}")
    return DONE


def _verify(options: argparse.Namespace) -> int:
    """Check a store; return the exit status: 3 where a fault is found."""
    folder = options.what
    if not Path(folder).is_dir():
        folder = store_folder(result_file(Path(options.out), read_study(options.what)))
    found = Verified(_store_in(str(folder)))
    print("\n".join(found.lines()))
    return FAILED if found.faults else DONE


def _merge(options: argparse.Namespace) -> int:
    target = Path(options.target)
    into = target if holds_a_store(target) else target / "store"
    print("\n".join(merge_into(_store_in(options.source), into, no_lock=options.no_lock)))
    return DONE


def _store_in(name: str) -> Path:
    """Return the store that a folder of results has, or that it is. Raises UserError."""
    for folder in (Path(name) / "store", Path(name)):
        if holds_a_store(folder):
            return folder
    raise UserError(f"{name}: holds no store of finished work")


class Command(NamedTuple):
    """What a command is for, what adds its options, and what does it and returns the status."""

    text: str
    add_options: Callable[[argparse.ArgumentParser], None]
    run: Callable[[argparse.Namespace], int]


COMMANDS = {
    "plan": Command("say what a run would do and cost; compute nothing", _json_options, _lines),
    "run": Command("compute what is missing and write the result file", _run_options, _run),
    "status": Command("say what is done and what is missing", _json_options, _lines),
    "figure": Command("draw the figure of a finished run", _figure_options, _figure),
    "table": Command(
        "write all coefficients of a finished run as CSV, with units", _result_options, _table
    ),
    "animate": Command(
        "draw one line of a scene on its way, as .gif or .mp4", _animate_options, _animate
    ),
    "explore": Command(
        "write one page of HTML on which a result is looked through, with sliders and no network",
        _explore_options,
        _explore,
    ),
    "report": Command(
        "write report.html, or report-SCALE.html: all figures, and the claims of the paper beside "
        "the results",
        _report_options,
        _report,
    ),
    "studies": Command(
        "list the studies that can be named, with their titles", _no_options, _studies
    ),
    "new": Command(
        "write a commented study.toml to start from, in studies/NAME of the working folder",
        _new_options,
        _new,
    ),
    "schema": Command(
        "print the JSON schema of study.toml, for editors that check and complete it",
        _no_options,
        _schema,
    ),
    "prony": Command(
        "fit a Prony series to measured moduli G' and G'', and print the table [material]",
        add_prony_options,
        run_prony,
    ),
    "fit": Command(
        "fit the kinetic law to measured velocity steps, and say what they determine of it",
        add_fit_options,
        run_fit,
    ),
    "law": Command(
        "fit a reduced law to the motions of a finished run, or of FILE.nc, and write it for "
        "others; FILE.json is a law already",
        _law_options,
        run_law,
    ),
    "verify": Command(
        "check every line of a journal, every shard and key, and the results; change nothing",
        _verify_options,
        _verify,
    ),
    "merge": Command(
        "take over the finished work of another folder of results", _merge_options, _merge
    ),
}
