"""How any table of the user is read: checks of values, keys, and what keys take, in words.

A key of a table is stated once, as name -> Key: its reader, the JSON schema and the page of
reference follow from it. Knows no table: which keys there are is said where they are used.
"""

import json
import math
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from ..ground import ErrorCollector, UserError, did_you_mean

Schema = dict[str, Any]
REQUIRED = object()
UNBOUNDED = 10**9  # whole numbers have no limit that a user would meet


def as_table(key: str, value: object) -> dict[str, Any]:
    """Return ``value`` if it is a table, or raise UserError naming the key."""
    if not isinstance(value, dict):
        raise UserError(f"{key} = {value!r}: must be a table")
    return value


def as_text(key: str, value: object) -> str:
    """Return ``value`` if it is a string, or raise UserError naming the key."""
    if not isinstance(value, str):
        raise UserError(f"{key} = {value}: must be a string")
    return value


def matching(key: str, value: object, pattern: str, words: str) -> str:
    """Return ``value`` if it is a string of a pattern or raise UserError; words : what is right."""
    text = as_text(key, value)
    if not re.fullmatch(pattern, text):
        raise UserError(f"{key} = {text!r}: must be {words}")
    return text


def flag(key: str, value: object) -> bool:
    """Return ``value`` if it is true or false, or raise UserError naming the key."""
    if not isinstance(value, bool):
        raise UserError(f"{key} = {value!r}: must be true or false")
    return value


def number(key: str, value: object) -> float:
    """Return ``value`` as a finite float or raise UserError naming the key."""
    try:
        if isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value):
            return float(value) + 0.0  # -0.0 is 0.0: one value, one key, one seed
    except OverflowError:  # a whole number beyond every float
        pass
    raise UserError(f"{key} = {value!r:.40}: must be a finite number")


def positive(key: str, value: object) -> float:
    """Return ``value`` as a positive float or raise UserError naming the key."""
    checked = number(key, value)
    if checked <= 0.0:
        raise UserError(f"{key} = {value!r}: must be greater than zero")
    return checked


def within(key: str, value: object, least: float, most: float, hint: str = "") -> float:
    """Return ``value`` as a float from ``least`` to ``most`` or raise UserError naming the key."""
    checked = number(key, value)
    if not least <= checked <= most:
        raise UserError(f"{key} = {checked!r}: must lie between {least:g} and {most:g}{hint}")
    return checked


def integer(key: str, value: object, least: int, most: int = UNBOUNDED) -> int:
    """Return ``value`` as an int from ``least`` to ``most`` or raise UserError naming the key."""
    if isinstance(value, bool) or not isinstance(value, int) or not least <= value <= most:
        limits = f"at least {least}" if most == UNBOUNDED else f"from {least} to {most}"
        raise UserError(f"{key} = {value!r:.40}: must be a whole number, {limits}")
    return value


Check = Callable[[str, object], float]


def two_numbers(key: str, value: object, words: str, *checks: Check) -> tuple[float, float]:
    """Return a list of two numbers, each as its own check has it, or raise UserError."""
    if not isinstance(value, list) or len(value) != 2:
        raise UserError(f"{key} = {value!r:.60}: must be {words}")
    first, second = (check(f"{key}[{i}]", value[i]) for i, check in enumerate(checks))
    return first, second


def choice(key: str, value: object, known: Iterable[str]) -> str:
    """Return ``value`` if it is one of ``known`` or raise UserError naming the key."""
    if value not in tuple(known):
        near = did_you_mean(value, known)
        raise UserError(f"{key} = {value!r}: must be one of {', '.join(known)}{near}")
    return str(value)


MOST_VALUES = 10_000  # on one axis
SPACES: dict[str, Callable[..., np.ndarray]] = {"linspace": np.linspace, "geomspace": np.geomspace}


def axis_values(key: str, spec: object) -> tuple[float, ...]:
    """Return the values of one axis, in the order given, without repetitions.

    Computed values are rounded to 12 digits, so that 0.3 of a linspace is 0.3.
    """
    if isinstance(spec, dict):
        values = _spaced(key, spec)
    elif isinstance(spec, list):
        values = tuple(number(f"{key}[{i}]", v) for i, v in enumerate(spec))
    elif isinstance(spec, str) and "," in spec:
        raise UserError(f"{key} = {spec!r:.40}: must be a number or a list; a list is [0.3, 0.5]")
    else:
        values = (number(key, spec),)
    if not values:
        raise UserError(f"{key} = []: must hold at least one value")
    if len(set(values)) < len(values):
        raise UserError(f"{key} = {spec!r}: holds a value twice")
    return values


def checked_values(check: Check, key: str, spec: object) -> tuple[float, ...]:
    """Return the values of one axis, each of which ``check`` has passed."""
    return tuple(check(key, value) for value in axis_values(key, spec))


def one_or_several(check: Check, key: str, spec: object) -> float | tuple[float, ...]:
    """Return a number, or the values of a list or range, each of which ``check`` has passed."""
    return checked_values(check, key, spec) if isinstance(spec, list | dict) else check(key, spec)


def _spaced(key: str, spec: dict[str, Any]) -> tuple[float, ...]:
    kind = next(iter(spec)) if len(spec) == 1 else ""
    if kind not in SPACES:
        raise UserError(f"{key} = {spec!r}: use {{linspace = [a, b, n]}} or {{geomspace = ...}}")
    args = spec[kind]
    if not isinstance(args, list) or len(args) != 3:
        raise UserError(f"{key}.{kind} = {args!r}: must be [first, last, number of values]")
    first, last = number(f"{key}.{kind}[0]", args[0]), number(f"{key}.{kind}[1]", args[1])
    count = integer(f"{key}.{kind}[2]", args[2], 1, MOST_VALUES)
    if kind == "geomspace" and first * last <= 0.0:
        raise UserError(f"{key}.geomspace = {args!r}: both ends must be of one sign, not zero")
    with np.errstate(over="ignore"):  # what lies beyond any number is refused as infinite
        return tuple(float(f"{value:.12g}") for value in SPACES[kind](first, last, count))


@dataclass(frozen=True)
class Key:
    """One setting: check(key, value) returns what is meant by a value or raises UserError.

    Texts are full sentences. What the check and the default say by themselves, values, usual and
    schema leave out.
    """

    check: Callable[[str, object], Any]
    means: str = ""  # what the key says
    doubled: str = ""  # of a number: what changes when it is doubled
    unit: str = ""
    default: Any = REQUIRED  # where the key is left out
    values: str = ""  # what it may be, in words
    usual: str = ""  # the default, in words
    schema: Mapping[str, Any] | None = None  # what it may be, as JSON schema


def read_table(where: str, table: object, keys: Mapping[str, Key]) -> dict[str, Any]:
    """Return name -> checked value for all ``keys`` of a table; ``where`` is its name.

    Raises UserError for what is no table, an unknown key, a refused value and a missing key.
    """
    return filled(where, checked(where, table, keys), keys)


def checked(where: str, table: object, keys: Mapping[str, Key]) -> dict[str, Any]:
    """Return name -> checked value for what a table holds. Raises UserError likewise."""
    given, complaints, found = as_table(where, table), ErrorCollector(), {}
    for name, value in given.items():
        with complaints:
            check_keys(f"{where}.", [name], keys)
            found[name] = keys[name].check(f"{where}.{name}", value)
    complaints.end()
    return found


def filled(where: str, given: Mapping[str, Any], keys: Mapping[str, Key]) -> dict[str, Any]:
    """Return checked values with the defaults of what was left out. Raises UserError for a gap."""
    complaints = ErrorCollector()
    for name, key in keys.items():
        with complaints:
            if name not in given and key.default is REQUIRED:
                raise UserError(f"{where}.{name}: missing")
    complaints.end()
    return {name: given.get(name, key.default) for name, key in keys.items()}


def check_keys(where: str, table: Iterable[str], known: Iterable[str]) -> None:
    """Raise UserError where a table holds a key that is not known; ``where`` goes before it."""
    for key in table:
        if key not in known:
            raise UserError(
                f"{where}{key}: unknown key; known are {', '.join(known)}{did_you_mean(key, known)}"
            )


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
    """Return in words what a key takes. Raises KeyError as ``schema_of`` does."""
    return key.values or _taken(key.check)[1]


def _taken(check: Callable[..., Any]) -> tuple[Schema, str]:
    """Return what a check takes. Raises KeyError for a check that is not known here."""
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
    if check.func is matching:
        return TEXT | {"pattern": f"^{given['pattern']}$"}, given["words"]
    if check.func is choice:
        *others, last = (f'`"{known}"`' for known in given["known"])
        return {"enum": list(given["known"])}, f"{', '.join(others)} or {last}"
    if check.func not in (checked_values, one_or_several):
        raise KeyError(check)
    one, words = _taken(check.args[0])
    return values_of_axis(one), f"{words}, or a list or range"


def default_of(key: Key) -> str:
    """Return the default of a key in words or as TOML has it; "none" where it is empty."""
    if key.usual:
        return key.usual
    if key.default is REQUIRED:
        return "required"
    if key.default in (None, "", ()):
        return "none"
    if isinstance(key.default, bool):
        return f"`{str(key.default).lower()}`"
    told = f"{key.default:g}" if isinstance(key.default, float) else json.dumps(key.default)
    return f"`{told}`" if isinstance(key.default, str) else told
