"""Lines shared by several tests."""

import numpy as np

from elastomer_friction.kernels import amplitudes, draw_phases, sample_line


def random_line(elements: int, hurst: float, steps_per_spacing: int, seed: int):
    """Return heights and slopes of a random line; the highest sample is first, the lowest is 0."""
    phases = draw_phases(np.random.default_rng(seed), elements)
    z, slope = sample_line(amplitudes(hurst, elements), phases, elements, steps_per_spacing)
    top = int(np.argmax(z))
    return np.roll(z, -top) - z.min(), np.roll(slope, -top)


def parabola(elements: int, steps_per_spacing: int, offset: float, radius: float):
    """Return heights and slopes of z = x^2 / (2 R). offset : of the vertex from a sample."""
    samples = elements * steps_per_spacing
    x = (np.arange(samples) - samples // 2 + offset) / steps_per_spacing
    return x**2 / (2.0 * radius), x / radius
