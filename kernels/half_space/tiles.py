"""Sums over the tiles of a map, from which the standard errors of a single map follow.

Dissipated power and the jump of friction are positive quadratic forms of pressures, sum w |p_q|^2.
By Parseval's theorem they are means of a local density: the square of the pressures filtered by
sqrt(w). The density p dz/dx is not local: the forces between distant contacts cancel only in its
sum over the map, so that its scatter between tiles is several times that of friction.
"""

import numpy as np

# Sums of a tile: number of touching samples, normal force and dissipated power at v1, then at v2,
# and the jump. The unit of each is arbitrary: errors are relative.
TILE_SUMS = ("touching", "load", "power", "touching_2", "load_2", "power_2", "jump")


def tile_sums(density: np.ndarray, tiles: int) -> np.ndarray:
    """Return the sums of a density (rows, n) over tiles, shape (tiles, tiles)."""
    rows, columns = (np.arange(tiles) * size // tiles for size in density.shape)
    return np.add.reduceat(np.add.reduceat(1.0 * density, rows, axis=0), columns, axis=1)


def quadratic_density(p: np.ndarray, weight: np.ndarray) -> np.ndarray:
    """Return a density whose mean is sum weight |p_q|^2, shape (rows, n).

    weight : non-negative, for each mode of a real transform, shape (rows, n//2 + 1).
    """
    return np.fft.irfft2(np.fft.rfft2(p) * np.sqrt(weight), p.shape) ** 2
