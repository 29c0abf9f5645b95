"""Shortest wave of a map that matters for its contacts and must be resolved.

A measured map has waves down to two samples, but a smooth one hardly uses them. Its rms curvature
over its rms slope is the typical wave number of the slopes. Only the upper half of the heights
counts: the rest does not touch, and may hold the kinks where a map was made periodic.
"""

import numpy as np

from ...kernels.half_space.surface import Surface as SampledMap
from ..study import Surface

# Curvature over slope, in 1/dx, of self-affine maps of H = 0.7 whose shortest wave is 2 dx. The
# shortest wave of any map follows in proportion.
REFERENCE_WAVE_NUMBER = 1.35
ROUGHEST_WAVE = 2.0  # dx


def shortest_wave(surface: Surface, elements: int) -> float:
    """Return the length of the shortest wave that matters, in dx, to two decimals.

    Below 2 dx, the map is rougher than self-affine maps of H = 0.7.
    """
    if surface.profile is None:
        _, last = surface.modes(elements)
        return round(elements / last, 2) if last else ROUGHEST_WAVE
    maps, modes = surface.profile.heights, surface.amplitudes
    if modes is not None:  # random maps with this spectrum are alike
        maps = SampledMap.drawn(np.random.default_rng(0), modes, elements, 1).z[None]
    return round(ROUGHEST_WAVE * REFERENCE_WAVE_NUMBER / _wave_number(maps), 2)


def _wave_number(maps: np.ndarray) -> float:
    """Return the rms curvature over the rms slope where maps are above their mean, in 1/dx."""
    high = maps > maps.mean(axis=(1, 2), keepdims=True)
    slopes, curvatures = np.zeros(maps.shape), np.zeros(maps.shape)
    for axis in (1, 2):
        slope = _forward(maps, axis)
        slopes += slope**2
        for other in (1, 2):
            # Along its own axis, the difference is centred on the sample.
            change = slope - np.roll(slope, 1, axis) if other == axis else _forward(slope, other)
            curvatures += change**2
    return float(np.sqrt(curvatures[high].sum() / slopes[high].sum()))


def _forward(values: np.ndarray, axis: int) -> np.ndarray:
    """Return the differences to the next samples of periodic maps."""
    return np.roll(values, -1, axis) - values
