"""JSON schema of study.toml, for editors: made of the tables of keys and of their texts."""

from collections.abc import Callable
from functools import partial
from typing import Any

from ..effects import QUANTITIES
from ..settings import (
    UNBOUNDED,
    as_text,
    checked_values,
    choice,
    flag,
    integer,
    number,
    positive,
    within,
)
from ..variants import COMPARE
from .tables import PAIRS

Schema = dict[str, Any]

NUMBER: Schema = {"type": "number"}
POSITIVE: Schema = {"type": "number", "exclusiveMinimum": 0}
NOT_ZERO: Schema = {"type": "number", "not": {"const": 0}}
TEXT: Schema = {"type": "string"}
WORD: Schema = {"type": "string", "pattern": r"^[\w.,:@%+/=-]*$"}
PLAIN: dict[Callable[..., Any], Schema] = {
    positive: POSITIVE,
    number: NUMBER,
    flag: {"type": "boolean"},
    as_text: TEXT,
}


def table_of(properties: dict[str, Schema]) -> Schema:
    """Return the schema of a table with these keys and no others."""
    return {"type": "object", "additionalProperties": False, "properties": properties}


def pair(first: Schema, second: Schema) -> Schema:
    """Return the schema of a list of two."""
    return {"type": "array", "items": [first, second], "minItems": 2, "maxItems": 2}


def values_of_axis(one: Schema) -> Schema:
    """Return the schema of a value, a list of them, or a range."""
    several = {"type": "array", "items": one, "minItems": 1, "uniqueItems": True}
    ends = [NUMBER, NUMBER, {"type": "integer", "minimum": 1, "maximum": 10_000}]
    spaced = {"type": "array", "items": ends, "minItems": 3, "maxItems": 3}
    ranges = [table_of({kind: spaced}) | {"minProperties": 1} for kind in ("linspace", "geomspace")]
    return {"anyOf": [one, several, *ranges]}


# What checks of their own take, by table and key.
OWN: dict[str, Schema] = {
    "grid.velocity_step": values_of_axis({"type": "number", "exclusiveMinimum": -1}),
    "numerics.steps_per_spacing": {"anyOf": [{"const": "auto"}, {"type": "integer", "minimum": 1}]},
    "material.branches": {
        "type": "array",
        "maxItems": 200,
        "items": pair(POSITIVE, {"type": "number", "minimum": 1e-30, "maximum": 1e30}),
    },
    "material.temperature": values_of_axis(NUMBER),
    "surface.columns": {"type": "array", "minItems": 2, "items": {"type": ["integer", "string"]}},
    "surface.units": pair(TEXT, TEXT),
    "scene.quantities": {"type": "array", "minItems": 1, "items": {"enum": list(QUANTITIES)}},
    "scene.programme.slide.velocity": NOT_ZERO,
    "scene.programme.slide.ratio": NOT_ZERO,
    "scene.programme.ramp.velocity": pair(NUMBER, NUMBER),
    "scene.programme.ramp.ratio": pair(NUMBER, NUMBER),
    "cluster.where": {"type": "string", "pattern": "^(local|slurm)$|://"},
    "cluster.memory": {"type": "string", "pattern": "^[0-9.]+ ?[kMGT]i?B$"},
    "cluster.walltime": {"type": "string", "pattern": "^([0-9]+-)?[0-9]+(:[0-9]+){0,2}$"},
    "cluster.prologue": {"type": ["string", "array"], "items": TEXT},
}
OWN |= {f"cluster.{key}": WORD for key in ("queue", "account", "interface")}
OWN |= {f"cluster.{key}": TEXT for key in ("log_folder", "tls_ca_file", "tls_cert", "tls_key")}


def schema_of(where: str, check: Callable[..., Any]) -> Schema:
    """Return what a check takes, as a schema; ``where`` is table and key.

    Raises KeyError for a check of its own that is not among OWN.
    """
    if where in OWN:
        return OWN[where]
    if not isinstance(check, partial):
        return PLAIN[check]
    given = check.keywords
    if check.func is within:
        return {"type": "number", "minimum": given["least"], "maximum": given["most"]}
    if check.func is integer:
        most = {"maximum": given["most"]} if given.get("most", UNBOUNDED) != UNBOUNDED else {}
        return {"type": "integer", "minimum": given["least"], **most}
    if check.func is choice:
        return {"enum": list(given["known"])}
    return {checked_values: values_of_axis}[check.func](schema_of(where, check.args[0]))


def study_schema() -> Schema:
    """Return the schema of a study.toml, JSON schema draft 7."""
    tables = {name: _table(name) for name in PAIRS if "." not in name}
    both = {**tables["material"]["properties"], **tables["surface"]["properties"]}
    both |= tables["numerics"]["properties"]
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
    keys, texts = PAIRS[name]
    found = {}
    for key, each in keys.items():
        where = f"{name}.{key}"
        if where == "scene.programme":
            found[key] = _programme()
        else:
            own = _table(where) if where in PAIRS else schema_of(where, each.check)
            unit = f" Unit: {texts[key].unit}." if texts[key].unit else ""
            found[key] = own | {"description": texts[key].means + unit}
    return table_of(found)


def _programme() -> Schema:
    """Return the schema of a list of segments, each a table of one kind."""
    start = "scene.programme."
    kinds = {name.removeprefix(start): _table(name) for name in PAIRS if name.startswith(start)}
    segment = table_of({**kinds, "file": TEXT}) | {"minProperties": 1, "maxProperties": 1}
    return {"type": "array", "minItems": 1, "maxItems": 1000, "items": segment}


def _by_name(each: Schema, pattern: str) -> Schema:
    """Return the schema of a table of tables that the user names."""
    return {"type": "object", "additionalProperties": False, "patternProperties": {pattern: each}}
