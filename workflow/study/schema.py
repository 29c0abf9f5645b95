"""What editors and the page of keys are told of study.toml, made of the tables of keys."""

import tomllib
from dataclasses import replace
from pathlib import Path
from typing import Any

from .scripts import OWN, load_script
from .settings import TEXT, Schema, as_toml, schema_of, table_of
from .tables import EVERY_TABLE, Keys
from .variants import COMPARE


def study_schema() -> Schema:
    """Return the schema of a study.toml, JSON schema draft 7."""
    tables = {name: _table(name) for name in EVERY_TABLE if "." not in name}
    both = {**tables["material"]["properties"], **tables["surface"]["properties"]}
    both |= tables["numerics"]["properties"] | tables["scene"]["properties"]
    compared = table_of({key: both[key] for key in COMPARE})
    tables["compare"] = _by_name(compared, "^[A-Za-z]\\w*$")
    tables["measure"] = {"type": "object"}
    return {
        "$schema": "http://json-schema.org/draft-07/schema#",
        "title": "study.toml of elastomer-friction",
        **table_of(tables | {"scales": _by_name(table_of(tables), ".")}),
    }


def _table(name: str) -> Schema:
    """Return the schema of a table."""
    found = {}
    for key, each in EVERY_TABLE[name].items():
        where = f"{name}.{key}"
        if where == "scene.programme":
            found[key] = _programme()
        elif where in EVERY_TABLE:
            found[key] = _table(where) | {"description": each.means}
        else:
            found[key] = schema_of(each)
    return table_of(found)


def _programme() -> Schema:
    """Return the schema of a list of segments, each a table of one kind."""
    start = "scene.programme."
    kinds = {
        name.removeprefix(start): _table(name) for name in EVERY_TABLE if name.startswith(start)
    }
    segment = table_of({**kinds, "file": TEXT}) | {"minProperties": 1, "maxProperties": 1}
    return {"type": "array", "minItems": 1, "maxItems": 1000, "items": segment}


def _by_name(each: Schema, pattern: str) -> Schema:
    """Return the schema of a table of tables that the user names."""
    return {"type": "object", "additionalProperties": False, "patternProperties": {pattern: each}}


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
