"""The commands ``studies``, ``new`` and ``schema``: what there is, and how to begin a study."""

import argparse
import json
import re
import tomllib
from pathlib import Path

from ..errors import UserError
from ..study import known_studies, study_schema
from ..system import make_folder, program, write_durably

DONE = 0
TEMPLATE = Path(__file__).with_name("study.toml")
NO_TITLE = "(its study.toml cannot be read)"


def add_new_options(command: argparse.ArgumentParser) -> None:
    """Add what the command ``new`` is told."""
    command.add_argument("name", help="of the study; its folder is made in studies/")


def run_studies(options: argparse.Namespace) -> int:
    """Print name and title of every study that can be named; return the exit status."""
    del options
    known = known_studies()
    width = max(map(len, known))
    for name, path in sorted(known.items()):
        print(f"{name:{width}}  {_title(path)}")
    return DONE


def _title(path: Path) -> str:
    """Return the title of a study."""
    try:
        return str(tomllib.loads(path.read_text(encoding="utf-8"))["study"]["title"])
    except (OSError, ValueError, LookupError, TypeError):
        return NO_TITLE


def run_schema(options: argparse.Namespace) -> int:
    """Print the schema of study.toml; return the exit status."""
    del options
    print(json.dumps(study_schema(), indent=1, ensure_ascii=False))
    return DONE


def run_new(options: argparse.Namespace) -> int:
    """Write a study.toml to start from; return the exit status. Raises UserError."""
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
