"""Grid axes: a number, a list, {linspace = [a, b, n]} or {geomspace = [a, b, n]}."""

import math
from collections.abc import Iterator

import numpy as np

from workflow.errors import UserError

MOST_VALUES = 10_000  # on one axis
SPACES = {"linspace": np.linspace, "geomspace": np.geomspace}


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


def axis_values(key: str, spec: object) -> tuple[float, ...]:
    """Return the values of one grid axis, in the order given, without repetitions.

    Computed values are rounded to 12 digits, so that 0.3 of a linspace is 0.3.
    """
    if isinstance(spec, dict):
        values = _spaced(key, spec)
    elif isinstance(spec, list):
        values = tuple(number(f"{key}[{i}]", v) for i, v in enumerate(spec))
    else:
        values = (number(key, spec),)
    if not values:
        raise UserError(f"{key} = []: must hold at least one value")
    if len(set(values)) < len(values):
        raise UserError(f"{key} = {spec!r}: holds a value twice")
    return values


def _spaced(key: str, spec: dict) -> tuple[float, ...]:
    kind = next(iter(spec)) if len(spec) == 1 else None
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


def snapped_spacing(length: float, spacings: tuple[float, ...]) -> tuple[float, ...]:
    """Return the nearest spacings that divide ``length`` into a number of elements 2^a 3^b 5^c.

    Such numbers are quick for the FFT; two spacings may fall on one.
    """
    elements = [_nearest_smooth(length / spacing) for spacing in spacings]
    return tuple(length / count for count in dict.fromkeys(elements))


def _nearest_smooth(target: float) -> int:
    return min(_smooth_even(2.0 * target + 8.0), key=lambda n: (abs(math.log(n / target)), n))


def _smooth_even(limit: float) -> Iterator[int]:
    fives = 1
    while 2 * fives <= limit:
        threes = fives
        while 2 * threes <= limit:
            twos = 2 * threes
            while twos <= limit:
                yield twos
                twos *= 2
            threes *= 3
        fives *= 5
