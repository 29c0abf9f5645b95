"""JSON schema of study.toml, derived from the tables of keys."""

from .effects import EFFECT_TABLES, compared_effect_schema
from .settings import TEXT, Schema, schema_of, table_of
from .tables import ALL_TABLES
from .variants import COMPARE


def study_schema() -> Schema:
    """Return the schema of a study.toml, JSON schema draft 7."""
    tables = {name: _table(name) for name in ALL_TABLES if "." not in name}
    properties = {**tables["material"]["properties"], **tables["surface"]["properties"]}
    properties |= tables["numerics"]["properties"] | tables["scene"]["properties"]
    properties |= {name: compared_effect_schema(properties[name]) for name in EFFECT_TABLES}
    compared = table_of({key: properties[key] for key in COMPARE})
    tables["compare"] = _by_name(compared, "^[A-Za-z]\\w*$")
    tables["measure"] = {"type": "object"}
    return {
        "$schema": "http://json-schema.org/draft-07/schema#",
        "title": "study.toml of elastomer-friction",
        **table_of(tables | {"scales": _by_name(table_of(tables), ".")}),
    }


def _table(name: str) -> Schema:
    """Return the schema of a table."""
    properties = {}
    for name_of_key, key in ALL_TABLES[name].items():
        where = f"{name}.{name_of_key}"
        if where == "scene.programme":
            properties[name_of_key] = _programme()
        elif where in ALL_TABLES:
            properties[name_of_key] = _table(where) | {"description": key.means}
        else:
            properties[name_of_key] = schema_of(key)
    return table_of(properties)


def _programme() -> Schema:
    """Return the schema of a segment, a table with one key, its kind, or of a list of them."""
    prefix = "scene.programme."
    kinds = {
        name.removeprefix(prefix): _table(name) for name in ALL_TABLES if name.startswith(prefix)
    }
    segment = table_of({**kinds, "file": TEXT}) | {"minProperties": 1, "maxProperties": 1}
    return {
        "anyOf": [{"type": "array", "minItems": 1, "maxItems": 1000, "items": segment}, segment]
    }


def _by_name(table: Schema, pattern: str) -> Schema:
    """Return the schema of a table of tables with names chosen by the user."""
    return {"type": "object", "additionalProperties": False, "patternProperties": {pattern: table}}
