"""Keys of user tables: checks of their values, and descriptions of the accepted values.

Each key of a table is defined once, as name -> Key. The reader, the JSON schema and the reference
page are derived from it. The tables themselves are defined in the modules that use them.
"""

import datetime
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
SHIFT_KEYS = ("wlf", "arrhenius", "shifts")  # keys of [material]; here, where no package is loaded
MAX_INTEGER = 10**9  # largest accepted; messages state it only for larger values


def toml_text(value: object) -> str:
    """Return a value as Python writes it, but true, false, lists and dates as TOML does."""
    if isinstance(value, bool | datetime.date | datetime.time):
        return str(value).lower()
    return repr(list(value) if isinstance(value, tuple) else value)


def refuse_keys(where: str, given: Mapping[str, Any], refused: Iterable[str], reason: str) -> None:
    """Raise UserError for the first given key that is refused."""
    for key in given:
        if key in refused:
            raise UserError(f"{where}.{key} = {toml_text(given[key]):.40}: {reason}")


def as_table(key: str, value: object) -> dict[str, Any]:
    """Return ``value`` if it is a table, or raise UserError naming the key."""
    if not isinstance(value, dict):
        raise UserError(f"{key} = {toml_text(value)}: must be a table")
    return value


def as_text(key: str, value: object) -> str:
    """Return ``value`` if it is a string, or raise UserError naming the key."""
    if not isinstance(value, str):
        raise UserError(f"{key} = {toml_text(value)}: must be a string")
    return value


def matching(key: str, value: object, pattern: str, words: str) -> str:
    """Return ``value`` if it is a string that matches a pattern, or raise UserError.

    words : description of the pattern for the message.
    """
    text = as_text(key, value)
    if not re.fullmatch(pattern, text):
        raise UserError(f"{key} = {text!r}: must be {words}")
    return text


def flag(key: str, value: object) -> bool:
    """Return ``value`` if it is true or false, or raise UserError naming the key."""
    if not isinstance(value, bool):
        raise UserError(f"{key} = {toml_text(value)}: must be true or false")
    return value


def number(key: str, value: object) -> float:
    """Return ``value`` as a finite float or raise UserError naming the key."""
    try:
        if isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value):
            return float(value) + 0.0  # -0.0 becomes 0.0, so that both give the same key and seed
    except OverflowError:  # an integer too large for a float
        pass
    raise UserError(f"{key} = {toml_text(value):.40}: must be a finite number")


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


def integer(key: str, value: object, least: int, most: int = MAX_INTEGER) -> int:
    """Return ``value`` as an int from ``least`` to ``most`` or raise UserError naming the key."""
    if isinstance(value, bool) or not isinstance(value, int) or not least <= value <= most:
        open_end = most == MAX_INTEGER and not (isinstance(value, int | float) and value > most)
        limits = f"at least {least}" if open_end else f"from {least} to {most}"
        raise UserError(f"{key} = {toml_text(value):.40}: must be a whole number, {limits}")
    return value


Check = Callable[[str, object], float]


def two_numbers(key: str, value: object, words: str, *checks: Check) -> tuple[float, float]:
    """Return the two numbers of a list, each checked by its own check, or raise UserError."""
    if not isinstance(value, list) or len(value) != 2:
        raise UserError(f"{key} = {toml_text(value):.60}: must be {words}")
    first, second = (check(f"{key}[{i}]", value[i]) for i, check in enumerate(checks))
    return first, second


def choice(key: str, value: object, known: Iterable[str]) -> str:
    """Return ``value`` if it is one of ``known`` or raise UserError naming the key."""
    if value not in tuple(known):
        near = did_you_mean(value, known)
        raise UserError(f"{key} = {toml_text(value)}: must be one of {', '.join(known)}{near}")
    return str(value)


MAX_AXIS_VALUES = 10_000
SPACES: dict[str, Callable[..., np.ndarray]] = {"linspace": np.linspace, "geomspace": np.geomspace}


def axis_values(key: str, spec: object) -> tuple[float, ...]:
    """Return the distinct values of one axis in the given order.

    The values of a range are rounded to 12 digits, so that a linspace contains 0.3 exactly.
    """
    if isinstance(spec, dict):
        values = _spaced(key, spec)
    elif isinstance(spec, list):
        values = tuple(number(f"{key}[{i}]", v) for i, v in enumerate(spec))
    elif isinstance(spec, str) and "," in spec:
        raise UserError(f"{key} = {spec!r:.40}: must be a number or a list such as [0.3, 0.5]")
    else:
        values = (number(key, spec),)
    if not values:
        raise UserError(f"{key} = []: must hold at least one value")
    if len(set(values)) < len(values):
        raise UserError(f"{key} = {spec!r}: must not contain a value twice")
    return values


def checked_values(check: Check, key: str, spec: object) -> tuple[float, ...]:
    """Return the values of one axis, each checked by ``check``."""
    return tuple(check(key, value) for value in axis_values(key, spec))


def one_or_several(check: Check, key: str, spec: object) -> float | tuple[float, ...]:
    """Return a number, or the values of a list or range, each checked by ``check``."""
    return checked_values(check, key, spec) if isinstance(spec, list | dict) else check(key, spec)


def _spaced(key: str, spec: dict[str, Any]) -> tuple[float, ...]:
    kind = next(iter(spec)) if len(spec) == 1 else ""
    if kind not in SPACES:
        raise UserError(
            f"{key} = {spec!r}: must be {{linspace = [a, b, n]}} or {{geomspace = [a, b, n]}}"
        )
    args = spec[kind]
    if not isinstance(args, list) or len(args) != 3:
        raise UserError(f"{key}.{kind} = {args!r}: must be a list [first, last, number of values]")
    first, last = number(f"{key}.{kind}[0]", args[0]), number(f"{key}.{kind}[1]", args[1])
    count = integer(f"{key}.{kind}[2]", args[2], 1, MAX_AXIS_VALUES)
    if kind == "geomspace" and first * last <= 0.0:
        raise UserError(f"{key}.geomspace = {args!r}: both ends must have one sign, not zero")
    with np.errstate(over="ignore"):  # the check refuses an infinite value
        return tuple(float(f"{value:.12g}") for value in SPACES[kind](first, last, count))


@dataclass(frozen=True)
class Key:
    """Definition of one setting; check(key, value) returns the parsed value or raises UserError.

    Texts are full sentences. ``values``, ``usual`` and ``schema`` are given only if they cannot be
    derived from the check and the default.
    """

    check: Callable[[str, object], Any]
    means: str = ""  # meaning of the key
    doubled: str = ""  # effect of doubling a number
    unit: str = ""
    default: Any = REQUIRED  # value of an omitted key
    values: str = ""  # description of the accepted values
    usual: str = ""  # description of the default
    schema: Mapping[str, Any] | None = None  # JSON schema of the accepted values


OPTIONAL = partial(Key, default=None)
FILE_NAME = partial(Key, as_text, values="the name of a file")


def read_table(where: str, table: object, keys: Mapping[str, Key]) -> dict[str, Any]:
    """Return name -> checked value for all ``keys`` of the table named ``where``.

    Raises UserError for a value that is not a table, an unknown key, a refused value and a missing
    key.
    """
    return filled(where, checked(where, table, keys), keys)


def inline_table(key: str, value: object, keys: Mapping[str, Key], make: Any = dict) -> Any:
    """Return ``make`` of the checked values of an inline table. Raises UserError."""
    return make(**read_table(key, value, keys))


def checked(where: str, table: object, keys: Mapping[str, Key]) -> dict[str, Any]:
    """Return name -> checked value of the given keys. Raises UserError as ``read_table`` does."""
    given, errors, values = as_table(where, table), ErrorCollector(), {}
    for name, value in given.items():
        with errors:
            check_keys(f"{where}.", [name], keys)
            values[name] = keys[name].check(f"{where}.{name}", value)
    errors.raise_collected()
    return values


def filled(where: str, given: Mapping[str, Any], keys: Mapping[str, Key]) -> dict[str, Any]:
    """Return checked values with defaults added. Raises UserError for a missing required key."""
    errors = ErrorCollector()
    for name, key in keys.items():
        with errors:
            if name not in given and key.default is REQUIRED:
                raise UserError(f"{where}.{name}: missing")
    errors.raise_collected()
    return {name: given.get(name, key.default) for name, key in keys.items()}


def check_keys(where: str, table: Iterable[str], known: Iterable[str]) -> None:
    """Raise UserError for a key that is not known; ``where`` precedes it in the message."""
    for key in table:
        if key not in known:
            raise UserError(
                f"{where}{key}: unknown key; known are {', '.join(known)}{did_you_mean(key, known)}"
            )


NUMBER: Schema = {"type": "number"}
POSITIVE: Schema = {"type": "number", "exclusiveMinimum": 0}
NOT_ZERO: Schema = {"type": "number", "not": {"const": 0}}
TEXT: Schema = {"type": "string"}
SCHEMA_OF_CHECK: dict[Callable[..., Any], tuple[Schema, str]] = {
    positive: (POSITIVE, "a number above 0"),
    number: (NUMBER, "a number"),
    flag: ({"type": "boolean"}, "`true` or `false`"),
    as_text: (TEXT, "text"),
}


def table_of(properties: dict[str, Schema]) -> Schema:
    """Return the schema of a table with exactly these keys."""
    return {"type": "object", "additionalProperties": False, "properties": properties}


def schema_of_keys(keys: Mapping[str, Key]) -> Schema:
    """Return the schema of a table with these keys."""
    return table_of({name: schema_of(key) for name, key in keys.items()})


def pair(first: Schema, second: Schema) -> Schema:
    """Return the schema of a list of two values."""
    return {"type": "array", "items": [first, second], "minItems": 2, "maxItems": 2}


def values_of_axis(single: Schema) -> Schema:
    """Return the schema of a value, a list of them, or a range."""
    several = {"type": "array", "items": single, "minItems": 1, "uniqueItems": True}
    ends = [NUMBER, NUMBER, {"type": "integer", "minimum": 1, "maximum": MAX_AXIS_VALUES}]
    spaced = {"type": "array", "items": ends, "minItems": 3, "maxItems": 3}
    ranges = [table_of({kind: spaced}) | {"minProperties": 1} for kind in SPACES]
    return {"anyOf": [single, several, *ranges]}


def schema_of(key: Key) -> Schema:
    """Return the JSON schema of a key with its meaning.

    Raises KeyError if the key has no schema and its check is not one of this module.
    """
    unit = f" Unit: {key.unit}." if key.unit else ""
    schema = dict(key.schema) if key.schema is not None else _accepted(key.check)[0]
    return schema | {"description": key.means + unit}


def values_of(key: Key) -> str:
    """Return a description of the accepted values. Raises KeyError as ``schema_of`` does."""
    return key.values or _accepted(key.check)[1]


def _accepted(check: Callable[..., Any]) -> tuple[Schema, str]:
    """Return schema and description of the accepted values. Raises KeyError for other checks."""
    if not isinstance(check, partial):
        return SCHEMA_OF_CHECK[check]
    given = check.keywords
    if "keys" in given:  # a table in the table
        words = f"`{{{', '.join(f'{name} = …' for name in given['keys'])}}}`"
        return schema_of_keys(given["keys"]), words
    if check.func is within:
        least, most = given["least"], given["most"]
        schema = {"type": "number", "minimum": least, "maximum": most}
        return schema, f"a number from {least:g} to {most:g}"
    if check.func is integer:
        least, most = given["least"], given.get("most", MAX_INTEGER)
        schema = {"type": "integer", "minimum": least}
        if most == MAX_INTEGER:
            return schema, f"a whole number, at least {least}"
        return schema | {"maximum": most}, f"a whole number from {least} to {most}"
    if check.func is matching:
        return TEXT | {"pattern": f"^{given['pattern']}$"}, given["words"]
    if check.func is choice:
        *others, last = (f'`"{known}"`' for known in given["known"])
        return {"enum": list(given["known"])}, f"{', '.join(others)} or {last}"
    if check.func not in (checked_values, one_or_several):
        raise KeyError(check)
    single, words = _accepted(check.args[0])
    return values_of_axis(single), f"{words}, or a list or range"


def default_of(key: Key) -> str:
    """Return the default of a key, described or in TOML notation; "none" for an empty value."""
    if key.usual:
        return key.usual
    if key.default is REQUIRED:
        return "required"
    if key.default in (None, "", ()):
        return "none"
    if isinstance(key.default, bool):
        return f"`{str(key.default).lower()}`"
    text = f"{key.default:g}" if isinstance(key.default, float) else json.dumps(key.default)
    return f"`{text}`" if isinstance(key.default, str) else text
