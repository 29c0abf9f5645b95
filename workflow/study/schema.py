"""JSON schema of study.toml, derived from the tables of keys."""

from .settings import Schema, schema_of_keys, table_of
from .tables import TABLES
from .variants import COMPARE


def study_schema() -> Schema:
    """Return the schema of a study.toml, JSON schema draft 7."""
    tables = {name: schema_of_keys(keys) for name, keys in TABLES.items()}
    tables["compare"] = _by_name(schema_of_keys(COMPARE), "^[A-Za-z]\\w*$")
    tables["measure"] = {"type": "object"}
    return {
        "$schema": "http://json-schema.org/draft-07/schema#",
        "title": "study.toml of elastomer-friction",
        **table_of(tables | {"scales": _by_name(table_of(tables), ".")}),
    }


def _by_name(table: Schema, pattern: str) -> Schema:
    """Return the schema of a table of tables with names chosen by the user."""
    return {"type": "object", "additionalProperties": False, "patternProperties": {pattern: table}}
