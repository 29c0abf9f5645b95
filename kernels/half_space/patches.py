"""Patches of contact: samples that touch and are neighbours, round the period."""

import numpy as np

from ..compile.jit import kernel


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
