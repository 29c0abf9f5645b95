"""What keys take as JSON schema: the pieces of which the schema of a study.toml is made."""

from collections.abc import Callable
from functools import partial
from typing import Any

from .checks import (
    MOST_VALUES,
    SPACES,
    UNBOUNDED,
    as_text,
    checked_values,
    choice,
    flag,
    integer,
    number,
    one_or_several,
    positive,
    within,
)
from .key import Key

Schema = dict[str, Any]

NUMBER: Schema = {"type": "number"}
POSITIVE: Schema = {"type": "number", "exclusiveMinimum": 0}
NOT_ZERO: Schema = {"type": "number", "not": {"const": 0}}
TEXT: Schema = {"type": "string"}
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
    ends = [NUMBER, NUMBER, {"type": "integer", "minimum": 1, "maximum": MOST_VALUES}]
    spaced = {"type": "array", "items": ends, "minItems": 3, "maxItems": 3}
    ranges = [table_of({kind: spaced}) | {"minProperties": 1} for kind in SPACES]
    return {"anyOf": [one, several, *ranges]}


def schema_of(key: Key) -> Schema:
    """Return what a key takes, with what it means.

    Raises KeyError for a check of its own whose key has no schema.
    """
    unit = f" Unit: {key.unit}." if key.unit else ""
    taken = _taken(key.check) if key.schema is None else dict(key.schema)
    return taken | {"description": key.means + unit}


def _taken(check: Callable[..., Any]) -> Schema:
    """Return what a check takes. Raises KeyError for one that is not among PLAIN."""
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
    several = {checked_values: values_of_axis, one_or_several: values_of_axis}
    return several[check.func](_taken(check.args[0]))
