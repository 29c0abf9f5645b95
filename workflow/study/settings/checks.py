"""Checks of settings: each returns the value or raises one line that names key and value."""

import math
from collections.abc import Iterable
from typing import Any

from ...errors import UserError, did_you_mean

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


def choice(key: str, value: object, known: Iterable[str]) -> str:
    """Return ``value`` if it is one of ``known`` or raise UserError naming the key."""
    if value not in tuple(known):
        near = did_you_mean(value, known)
        raise UserError(f"{key} = {value!r}: must be one of {', '.join(known)}{near}")
    return str(value)
