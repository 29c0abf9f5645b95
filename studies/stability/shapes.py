"""Lines that no spectrum makes. Slopes are those of straight lines between the samples."""

import numpy as np

from elastomer_friction.kernels import Line


def line_through(z, steps_per_spacing: int = 2) -> Line:
    """Return the periodic line through these heights."""
    z = np.asarray(z, dtype=float)
    slope = 0.5 * steps_per_spacing * (np.roll(z, -1) - np.roll(z, 1))
    return Line.from_samples(z, slope, steps_per_spacing)


def shapes(n: int = 48) -> dict[str, Line]:
    """Return name -> line of n samples (n a multiple of 8)."""
    x = np.arange(n)
    quantised = np.round(4.0 * np.random.default_rng(3).normal(size=n)) / 4.0
    heights = {
        "flat": np.zeros(n),
        "spike down": np.where(x == n // 2, -1.0, 1.0),
        "spike up": np.where(x == n // 2, 1.0, -1.0),
        "needle of 1000": np.where(x == n // 2, -1000.0, 0.0),
        "step": np.where(x < n // 2, -1.0, 1.0),
        "comb": np.where(x % 2 == 0, -1.0, 1.0),
        "sawtooth": x % 8 - 3.5,
        "falling sawtooth": 3.5 - x % 8,
        "ties at the bottom": np.where(x % 8 < 3, -2.0, np.sin(x)),
        "quantised": quantised,
        "far from zero": 1e6 + quantised,
        "nearly flat": 1e-12 * np.sin(x),
        "two samples apart by one ulp": np.where(x == 5, 1.0, np.where(x == 9, 1.0 + 2e-16, 2.0)),
    }
    return {name: line_through(z) for name, z in heights.items()}
