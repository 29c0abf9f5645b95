"""Rounding as on another processor: with LAST_BIT=1 in the environment lines differ by it.

Other processors round FFT, exp and sums otherwise. No test may depend on that; here heights and
slopes go up, down or stay by one unit in the last place, the same for the same line.
"""

import os

import numpy as np

from elastomer_friction import kernels
from elastomer_friction.kernels.lines import line, self_affine

WANTED = os.environ.get("LAST_BIT")
exact_line = self_affine.sample_line


def perturbed_line(amplitude, phases, elements, steps_per_spacing):
    """Return a line as self_affine.sample_line does, rounded otherwise."""
    seed = [int(WANTED), elements, steps_per_spacing, *phases.view(np.uint64).tolist()[:4]]
    rng = np.random.default_rng(seed)
    found = exact_line(amplitude, phases, elements, steps_per_spacing)
    return tuple(values * (1.0 + rng.choice([-2e-16, 0.0, 2e-16], values.size)) for values in found)


def perturb():
    """Let all lines of this process be rounded otherwise, where that is asked for."""
    if WANTED:
        for module in (kernels, line, self_affine):
            module.sample_line = perturbed_line
