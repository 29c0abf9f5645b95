"""Patches of contact: samples that touch and are neighbours, round the period; and their area.

To count the samples that touch is to count too many at edges: by (pi - 1 + ln 2)/24 of a sample for
every side of one that does not touch its neighbour, in the mean over edges of all directions.
Source: V. A. Yastrebov, G. Anciaux, J.-F. Molinari, Tribol. Int. 114, 161 (2017),
doi:10.1016/j.triboint.2017.04.023.
"""

import math

import numpy as np

from ..compile.jit import kernel

EDGE = (math.pi - 1.0 + math.log(2.0)) / 24.0


def real_contact(p: np.ndarray, sudden: float) -> float:
    """Return the real contact area over L^2.

    p : pressures, shape (rows, n), periodic; in one row only what is sudden is corrected. sudden :
    share of the leading edges at which pressure jumps, as behind a dashpot: there a sample counts
    for the whole step in which it is touched, half a sample too many.
    """
    touching = p > 0.0
    along = float(np.count_nonzero(touching != np.roll(touching, 1, axis=1)))
    across = float(np.count_nonzero(touching != np.roll(touching, 1, axis=0)))
    edges = EDGE * (along + across) if p.shape[0] > 1 else 0.0
    return float(np.count_nonzero(touching) - edges - 0.25 * sudden * along) / p.size


def samples_per_patch(p: np.ndarray) -> float:
    """Return how many samples a patch of contact has in the mean; 0 where nothing touches.

    p : pressures, shape (rows, n), periodic. A patch is connected by sides, not by corners.
    """
    touching = p > 0.0
    patches = _count_patches(touching)
    return float(touching.sum()) / patches if patches else 0.0


@kernel
def _count_patches(touching):
    """Return the number of patches: samples less the links between them, by union of trees."""
    rows, n = touching.shape
    root = np.arange(rows * n)
    patches = 0
    for y in range(rows):
        for x in range(n):
            if not touching[y, x]:
                continue
            patches += 1
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
    """Return the sample that stands for the patch of sample i, and shorten the way to it."""
    while root[i] != i:
        root[i] = root[root[i]]
        i = root[i]
    return i
