"""Functions that execute the commands; `command_line.py` defines their options."""

import argparse
import contextlib
import json
import math
import re
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

from .. import report, scene
from ..ground import UserError, printable
from ..result import check_result, result_file
from ..run import result_line, status_lines
from ..store import Verification, holds_a_store, merge_into, store_folder
from ..study import (
    AnyStudy,
    find_study,
    known_studies,
    load_tables,
    read_scene,
    read_study,
    study_schema,
)
from ..system import make_folder, program, write_durably
from .exit_status import DONE, FAILED
from .experiments import run_fit, run_prony, run_spectrum
from .law_command import run_law
from .outline import outline_grid, outline_measured
from .run_options import run_grid, run_measured_study

ANIMATED_QUANTITIES = ["trace", "snapshots"]
STUDY_TEMPLATE = Path(__file__).with_name("study.toml")
NO_TITLE = "(its study.toml cannot be read)"

# Functions for each kind of study and each command. Those for `plan` and `status` take a study and
# its result file, and return lines and data for --json. Those for `run` return the exit status.
STUDY_ACTIONS: dict[str, dict[str, Callable[..., Any]]] = {
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


def _lines(options: argparse.Namespace) -> None:
    """Print the output of the commands plan and status."""
    study, result = _study(options)
    outline = STUDY_ACTIONS[study.kind][options.command]
    if options.command == "plan":
        if options.sample is not None and not 0.0 < options.sample < math.inf:
            raise UserError(f"--sample {options.sample}: must be a positive number of seconds")
        outline = partial(outline, sample_seconds=options.sample)
    lines, facts = outline(study, result)
    settings = str(find_study(options.study).resolve())
    if options.json:
        head = {"study": study.name, "title": study.title, "result": str(result)}
        print(json.dumps(head | facts | {"settings": settings}, indent=1))
    else:
        print("\n".join(map(printable, [*lines, f"settings    {settings}"])))


def _run(options: argparse.Namespace) -> int:
    study, result = _study(options)
    return STUDY_ACTIONS[study.kind]["run"](options, study, result)


def _figure(options: argparse.Namespace) -> None:
    report.print_pictures(report.draw_figure(*_checked(options), options.script))


def _table(options: argparse.Namespace) -> None:
    print(*report.write_table(*_checked(options)), sep="\n")


def _checked(options: argparse.Namespace) -> tuple[AnyStudy, Path]:
    """Return the study and its result file. Raises UserError if they do not match."""
    study, result = _study(options)
    check_result(study, result, strict=bool(options.scale or options.set or options.accuracy))
    return study, result


def _report(options: argparse.Namespace) -> None:
    print(report.write_report(Path(options.out), options.studies, options.scale))


def _explore(options: argparse.Namespace) -> None:
    result = Path(options.result)
    if result.suffix != ".nc":
        study = read_study(options.result, options.scale)
        result = result_file(Path("results"), study)
        check_result(study, result, strict=bool(options.scale))
    print(report.write_explorer(result, options.out))


def _animate(options: argparse.Namespace) -> None:
    """Compute the first line of a scene in this process and animate it."""
    study = read_scene(options.study, options.scale, options.set, ANIMATED_QUANTITIES)
    path = Path(options.out or f"results/{study.name}.gif")
    report.check_animation(path)
    make_folder(path.parent)
    print(report.animate(scene.compute(study), path))


def _studies(_: argparse.Namespace) -> None:
    """Print the names and titles of all studies."""
    known = known_studies()
    width = max(map(len, known))
    for name, path in sorted(known.items()):
        title = NO_TITLE
        with contextlib.suppress(UserError, RecursionError, LookupError, TypeError):
            title = str(load_tables(path, None, [])[0]["study"]["title"])
        print(printable(f"{name:{width}}  {title}"))


def _schema(_: argparse.Namespace) -> None:
    print(json.dumps(study_schema(), indent=1, ensure_ascii=False))


def _new(options: argparse.Namespace) -> None:
    """Create a study from the template."""
    name = options.name
    if not re.fullmatch(r"[A-Za-z][\w-]*", name, re.ASCII):
        raise UserError(f"new {name!r}: must be letters, digits, - and _, with a letter first")
    path = Path("studies") / name.replace("-", "_") / "study.toml"
    known = known_studies().get(path.parent.name)
    if path.exists() or known:
        raise UserError(
            f"new {name}: the study exists already, {known or path}; choose another name"
        )
    make_folder(path.parent)
    text = STUDY_TEMPLATE.read_text(encoding="utf-8").replace("NAME", name)
    write_durably(path, text.encode())
    print(f"{path}: edit it, then: {program()} plan {name}")


def _verify(options: argparse.Namespace) -> int:
    """Verify a store; return exit status 3 if a fault is found."""
    folder = options.what
    if not Path(folder).is_dir():
        try:
            find_study(folder)
        except UserError as error:
            raise UserError(f"verify {folder}: is not a folder of results, and {error}") from None
        folder = store_folder(result_file(Path(options.out), read_study(options.what)))
    verification = Verification(_store_in(str(folder)))
    print("\n".join(verification.lines()))
    return FAILED if verification.faults else DONE


def _merge(options: argparse.Namespace) -> None:
    target = Path(options.target)
    into = target if holds_a_store(target) else target / "store"
    print("\n".join(merge_into(_store_in(options.source), into, no_lock=options.no_lock)))


def _store_in(name: str) -> Path:
    """Return the store in a folder, or the folder itself if it is a store; else raise UserError."""
    for folder in (Path(name) / "store", Path(name)):
        if holds_a_store(folder):
            return folder
    raise UserError(f"{name}: holds no store of finished work")


# Functions of the commands; one without a value ends with DONE.
ACTIONS: dict[str, Callable[[argparse.Namespace], int | None]] = {
    "plan": _lines,
    "run": _run,
    "status": _lines,
    "figure": _figure,
    "table": _table,
    "animate": _animate,
    "explore": _explore,
    "report": _report,
    "studies": _studies,
    "new": _new,
    "schema": _schema,
    "prony": run_prony,
    "fit": run_fit,
    "law": run_law,
    "spectrum": run_spectrum,
    "verify": _verify,
    "merge": _merge,
}
