"""Contact patches (connected sets of touching samples on a periodic map) and their area.

The number of touching samples overestimates the area. The excess, averaged over the directions of
edges, is (pi - 1 + ln 2)/24 of a sample for each side between a touching sample and one that does
not touch.
Source: V. A. Yastrebov, G. Anciaux, J.-F. Molinari, Tribol. Int. 114, 161 (2017),
doi:10.1016/j.triboint.2017.04.023.
"""

import math

import numpy as np

from ..compile.jit import kernel

AREA_PER_EDGE = (math.pi - 1.0 + math.log(2.0)) / 24.0


def real_contact(p: np.ndarray, sudden: float) -> float:
    """Return the real contact area over L^2.

    p : pressures, shape (rows, n), periodic. sudden : share of the leading edges at which the
    pressure jumps, as with a dashpot. Samples there count for the whole step in which they are
    touched, which is half a sample too much. For a single row this is the only correction.
    """
    touching = p > 0.0
    along = float(np.count_nonzero(touching != np.roll(touching, 1, axis=1)))
    across = float(np.count_nonzero(touching != np.roll(touching, 1, axis=0)))
    edges = AREA_PER_EDGE * (along + across) if p.shape[0] > 1 else 0.0
    return float(np.count_nonzero(touching) - edges - 0.25 * sudden * along) / p.size


def samples_per_patch(p: np.ndarray) -> float:
    """Return the mean number of samples in a contact patch; 0 without contact.

    p : pressures, shape (rows, n), periodic. Samples are connected by sides, not by corners.
    """
    touching = p > 0.0
    patches = _count_patches(touching)
    return float(touching.sum()) / patches if patches else 0.0


@kernel
def _count_patches(touching):
    """Return the number of patches, by union-find."""
    rows, n = touching.shape
    root = np.arange(rows * n)
    for y in range(rows):
        for x in range(n):
            if not touching[y, x]:
                continue
            here = y * n + x
            for side in range(2):
                y1, x1 = ((y + 1) % rows, x) if side == 0 else (y, (x + 1) % n)
                if touching[y1, x1]:
                    a, b = _root(root, here), _root(root, y1 * n + x1)
                    if a != b:
                        root[a] = b
    patches = 0
    for i in range(rows * n):
        if touching[i // n, i % n] and root[i] == i:
            patches += 1
    return patches


@kernel
def _root(root, i):
    """Return the root of the patch that contains sample i, and shorten the path to it."""
    while root[i] != i:
        root[i] = root[root[i]]
        i = root[i]
    return i
