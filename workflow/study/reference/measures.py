"""Tables [measure] of the measured studies of this program, with what is said of their keys."""

import tomllib
from pathlib import Path
from typing import Any

from ..scripts import OWN, load_script
from ..settings import Key
from .tables import Table, described
from .values import as_toml


def described_measures(studies: Path = OWN) -> dict[str, Table]:
    """Return study -> the keys of its table [measure], described, for every study of a folder.

    Runs the file measure.py of each. Raises KeyError for a key without a text, a text without a
    key, and a key that the study.toml has no value for.
    """
    return {path.parent.name: _described(path) for path in sorted(studies.glob("*/measure.py"))}


def _described(path: Path) -> Table:
    script = load_script(path)
    tables = tomllib.loads((path.parent / "study.toml").read_text(encoding="utf-8"))
    keys = {name: Key(check) for name, check in script.SETTINGS.items()}
    texts = {
        name: text._replace(default=_values_of(name, tables)) for name, text in script.TEXTS.items()
    }
    return described(f"{path.parent.name}: measure", keys, texts)


def _values_of(name: str, tables: dict[str, Any]) -> str:
    """Return in words which value a key has in study.toml, at every scale that has its own."""
    said = [f"required; `{as_toml(tables['measure'][name])}` in its study.toml"]
    for scale, own in tables.get("scales", {}).items():
        if name in own.get("measure", {}):
            said.append(f"`{as_toml(own['measure'][name])}` at scale {scale}")
    return ", ".join(said)
