"""Numbers with standard errors as text."""

import math


def with_error(value: float, error: float) -> str:
    """Return text such as "0.3012 ± 0.0023": the error with two digits, the value to match.

    Without a finite error the value has three digits and "(error unknown)" follows.
    """
    if not math.isfinite(error):
        return f"{value:.3g} (error unknown)"
    if error <= 1e-9 * abs(value):
        return f"{value:.6g}"
    size = math.floor(math.log10(max(abs(value), error)))
    last = math.floor(math.log10(error)) - 1  # place of the second digit of the error
    if -4 <= size < 6 and last <= 0:
        return f"{value:.{-last}f} ± {error:.{-last}f}"
    unit = 10.0**size
    places = max(size - last, 0)
    return f"({value / unit:.{places}f} ± {error / unit:.{places}f})e{size}"
