"""Values of an axis: a number, a list, {linspace = [a, b, n]} or {geomspace = [a, b, n]}."""

from collections.abc import Callable
from typing import Any

import numpy as np

from ...errors import UserError
from .checks import integer, number

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
    return tuple(float(f"{value:.12g}") for value in SPACES[kind](first, last, count))
