"""What editors and the page of keys are told of study.toml, made of the tables of keys."""

from .settings import TEXT, Schema, schema_of, table_of
from .tables import ALL_TABLES
from .variants import COMPARE


def study_schema() -> Schema:
    """Return the schema of a study.toml, JSON schema draft 7."""
    tables = {name: _table(name) for name in ALL_TABLES if "." not in name}
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
    for key, each in ALL_TABLES[name].items():
        where = f"{name}.{key}"
        if where == "scene.programme":
            found[key] = _programme()
        elif where in ALL_TABLES:
            found[key] = _table(where) | {"description": each.means}
        else:
            found[key] = schema_of(each)
    return table_of(found)


def _programme() -> Schema:
    """Return the schema of a list of segments, each a table of one kind."""
    start = "scene.programme."
    kinds = {
        name.removeprefix(start): _table(name) for name in ALL_TABLES if name.startswith(start)
    }
    segment = table_of({**kinds, "file": TEXT}) | {"minProperties": 1, "maxProperties": 1}
    return {"type": "array", "minItems": 1, "maxItems": 1000, "items": segment}


def _by_name(each: Schema, pattern: str) -> Schema:
    """Return the schema of a table of tables that the user names."""
    return {"type": "object", "additionalProperties": False, "patternProperties": {pattern: each}}
