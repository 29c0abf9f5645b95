"""Detection of missing-value codes such as -9999 or -32768: numbers far from all others."""

from typing import NamedTuple

import numpy as np

CODES = (-9999.0, 9999.0, -999.0, 999.0, -99999.0, 99999.0, -32768.0, 32767.0, -32767.0, 65535.0)
MIN_CODE_DISTANCE = 100.0  # from the median of the other values, in spreads


class Code(NamedTuple):
    """A number that marks missing values."""

    value: float
    times: int  # number of occurrences
    spreads: float  # distance from the median of the other values, in their spreads


def missing_code(values: np.ndarray, repeated: bool = True) -> Code | None:
    """Return the missing-value code of an array, or None if it contains no code.

    The smallest and the largest finite value are examined. Either is a code if it is listed in
    CODES, exceeds 1e29 in magnitude or, with ``repeated``, occurs at least twice. It must
    also lie more than MIN_CODE_DISTANCE spreads from the median of the other values. The spread
    is the distance from their 5th to their 95th percentile or, if that is zero, their magnitude.
    """
    finite = values[np.isfinite(values)]
    for value in (finite.min(), finite.max()) if finite.size else ():
        equal = finite == value
        count, others = int(np.count_nonzero(equal)), finite[~equal]
        if others.size < max(3, count):
            continue
        plausible = value in CODES or (repeated and count > 1) or abs(value) > 1e29
        low, middle, high = np.percentile(others, (5.0, 50.0, 95.0))
        spread = high - low or abs(middle)
        with np.errstate(over="ignore"):  # infinite beside a spread near zero
            distance = abs(value - middle) / spread if spread else 0.0
        if plausible and distance > MIN_CODE_DISTANCE:
            return Code(float(value), count, float(distance))
    return None
