"""Codes that stand for a missing value, as -9999 or -32768: numbers far from all others."""

from typing import NamedTuple

import numpy as np

CODES = (-9999.0, 9999.0, -999.0, 999.0, -99999.0, 99999.0, -32768.0, 32767.0, -32767.0, 65535.0)
FAR = 100.0  # spreads of the others from their median


class Code(NamedTuple):
    """One number that stands for a missing value."""

    value: float
    times: int
    spreads: float  # by how many spreads of the other values it is away from them


def missing_code(values: np.ndarray, repeated: bool = True) -> Code | None:
    """Return the code for missing values among finite numbers and NaN, or None where there is none.

    It is a number that is known as one (CODES, or larger than 1e29), or the least or largest value
    where it stands there twice or more, unless ``repeated`` is false; and it lies over FAR spreads
    from the others, the spread being the distance from their 5th to their 95th percentile, or the
    size of equal ones.
    """
    known = values[np.isfinite(values)]
    for value in (known.min(), known.max()) if known.size else ():
        same = known == value
        count, others = int(np.count_nonzero(same)), known[~same]
        if others.size < max(3, count):
            continue
        named = value in CODES or (repeated and count > 1) or abs(value) > 1e29
        low, middle, high = np.percentile(others, (5.0, 50.0, 95.0))
        spread = high - low or abs(middle)
        away = abs(value - middle) / spread if spread else 0.0
        if named and away > FAR:
            return Code(float(value), count, float(away))
    return None
