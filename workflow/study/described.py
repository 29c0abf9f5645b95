"""Tables [measure] of the measured studies of this program, with the values of their study.toml."""

import tomllib
from dataclasses import replace
from pathlib import Path
from typing import Any

from .scripts import OWN, load_script
from .settings import as_toml
from .tables import Keys


def described_measures(studies: Path = OWN) -> dict[str, Keys]:
    """Return study -> the keys of its table [measure], for every measured study of a folder.

    Runs the file measure.py of each. Raises KeyError for a key that study.toml has no value for.
    """
    return {path.parent.name: _described(path) for path in sorted(studies.glob("*/measure.py"))}


def _described(path: Path) -> Keys:
    tables = tomllib.loads((path.parent / "study.toml").read_text(encoding="utf-8"))
    keys: Keys = load_script(path).SETTINGS
    return {name: replace(key, usual=_values_of(name, tables)) for name, key in keys.items()}


def _values_of(name: str, tables: dict[str, Any]) -> str:
    """Return in words which value a key has in study.toml, at every scale that has its own."""
    said = [f"required; `{as_toml(tables['measure'][name])}` in its study.toml"]
    for scale, own in tables.get("scales", {}).items():
        if name in own.get("measure", {}):
            said.append(f"`{as_toml(own['measure'][name])}` at scale {scale}")
    return ", ".join(said)
