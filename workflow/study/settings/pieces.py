"""What keys take, as JSON schema and in words, said once for each check."""

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
PLAIN: dict[Callable[..., Any], tuple[Schema, str]] = {
    positive: (POSITIVE, "a number above 0"),
    number: (NUMBER, "a number"),
    flag: ({"type": "boolean"}, "`true` or `false`"),
    as_text: (TEXT, "text"),
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
    schema = dict(key.schema) if key.schema is not None else _taken(key.check)[0]
    return schema | {"description": key.means + unit}


def values_of(key: Key) -> str:
    """Return in words what a key takes; "" for a check of its own whose key does not say it."""
    try:
        return key.values or _taken(key.check)[1]
    except KeyError:
        return ""


def _taken(check: Callable[..., Any]) -> tuple[Schema, str]:
    """Return what a check takes. Raises KeyError for one that is none of those of checks.py."""
    if not isinstance(check, partial):
        return PLAIN[check]
    given = check.keywords
    if check.func is within:
        least, most = given["least"], given["most"]
        schema = {"type": "number", "minimum": least, "maximum": most}
        return schema, f"a number from {least:g} to {most:g}"
    if check.func is integer:
        least, most = given["least"], given.get("most", UNBOUNDED)
        schema = {"type": "integer", "minimum": least}
        if most == UNBOUNDED:
            return schema, f"a whole number, at least {least}"
        return schema | {"maximum": most}, f"a whole number from {least} to {most}"
    if check.func is choice:
        *others, last = (f'`"{known}"`' for known in given["known"])
        return {"enum": list(given["known"])}, f"{', '.join(others)} or {last}"
    if check.func not in (checked_values, one_or_several):
        raise KeyError(check)
    one, words = _taken(check.args[0])
    return values_of_axis(one), f"{words}, or a list or range"
