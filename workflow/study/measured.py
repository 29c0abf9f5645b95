"""Measured studies: no grid of problems; the folder's measure.py says what is measured."""

import json
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType

from workflow.errors import UserError
from workflow.study.checks import as_table, as_text, check_keys, integer
from workflow.study.scripts import load_script


@dataclass(frozen=True)
class Measured:
    """A checked measured study: no grid; its measure.py says what is measured (measured.py)."""

    name: str
    folder: Path  # where study.toml, measure.py and figure.py are
    text: str  # the settings in force, after scale and --set, as JSON
    title: str
    seed: int
    settings: dict[str, object]  # of the table [measure]
    script: ModuleType  # measure.py


TABLES = ("study", "measure")


def read_measured(name: str, folder: Path, tables: dict) -> Measured:
    """Return the checked study. Raises UserError, one line, for what a user can get wrong."""
    check_keys("", tables, TABLES)
    head = as_table("study", tables.get("study", {}))
    check_keys("study.", head, ("title", "seed"))
    script = load_script(folder / "measure.py")
    given = as_table("measure", tables["measure"])
    check_keys("measure.", given, tuple(script.SETTINGS))
    settings = {}
    for key, check in script.SETTINGS.items():
        if key not in given:
            raise UserError(f"measure.{key}: missing")
        settings[key] = check(f"measure.{key}", given[key])
    return Measured(
        name=name,
        folder=folder,
        text=json.dumps(tables, indent=1, sort_keys=True, default=str),
        title=as_text("study.title", head.get("title", name)),
        seed=integer("study.seed", head.get("seed", 0), 0),
        settings=settings,
        script=script,
    )
