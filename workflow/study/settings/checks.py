"""Checks of settings: each returns the value or raises one line that names key and value."""

import math
from collections.abc import Callable, Iterable
from typing import Any

import numpy as np

from ...ground import UserError, did_you_mean

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


def checked_values(
    check: Callable[[str, object], float], key: str, spec: object
) -> tuple[float, ...]:
    """Return the values of one axis, each of which ``check`` has passed."""
    return tuple(check(key, value) for value in axis_values(key, spec))


def one_or_several(
    check: Callable[[str, object], float], key: str, spec: object
) -> float | tuple[float, ...]:
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
