"""Checks of single settings: each returns the value or raises one line that names the key."""

import math
from collections.abc import Callable
from typing import Any

from workflow.errors import UserError


def number(key: str, value: object) -> float:
    """Return ``value`` as a finite float or raise UserError naming the key."""
    try:
        known = isinstance(value, int | float) and not isinstance(value, bool)
        if known and math.isfinite(value):
            return float(value)
    except OverflowError:  # a whole number beyond every float
        pass
    raise UserError(f"{key} = {value!r:.40}: must be a finite number")


def integer(key: str, value: object, least: int, most: int = 10**9) -> int:
    """Return ``value`` as an int from ``least`` to ``most`` or raise UserError naming the key."""
    if isinstance(value, bool) or not isinstance(value, int) or not least <= value <= most:
        limits = f"at least {least}" if most == 10**9 else f"from {least} to {most}"
        raise UserError(f"{key} = {value!r:.40}: must be a whole number, {limits}")
    return value


def choice(key: str, value: object, known: tuple[str, ...]) -> str:
    """Return ``value`` if it is one of ``known`` or raise UserError naming the key."""
    if value not in known:
        raise UserError(f"{key} = {value!r}: must be one of {', '.join(known)}")
    return str(value)


def positive(key: str, value: object) -> float:
    """Return ``value`` as a positive float or raise UserError naming the key."""
    checked = number(key, value)
    if checked <= 0.0:
        raise UserError(f"{key} = {value!r}: must be greater than zero")
    return checked


def as_table(key: str, value: Any) -> dict:
    """Return ``value`` if it is a table, or raise UserError naming the key."""
    if not isinstance(value, dict):
        raise UserError(f"{key} = {value!r}: must be a table")
    return value


def as_text(key: str, value: Any) -> str:
    """Return ``value`` if it is a string, or raise UserError naming the key."""
    if not isinstance(value, str):
        raise UserError(f"{key} = {value}: must be a string")
    return value


def check_keys(where: str, table: dict, known: tuple[str, ...]) -> None:
    """Raise UserError where a table holds a key that is not known; ``where`` goes before it."""
    for key in table:
        if key not in known:
            raise UserError(f"{where}{key}: unknown key; known are {', '.join(known)}")


def _required(tables: dict, table: str, key: str, check: Callable[[str, object], Any]) -> Any:
    values = tables.get(table, {})
    if key not in values:
        raise UserError(f"{table}.{key}: missing")
    return check(f"{table}.{key}", values[key])


def _flag(key: str, table: dict, default: bool) -> bool:
    value = table.get(key.rpartition(".")[2], default)
    if not isinstance(value, bool):
        raise UserError(f"{key} = {value!r}: must be true or false")
    return value
