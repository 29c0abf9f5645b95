"""Rounding as on another processor: LAST_BIT=1 in the environment changes last bits of lines.

Other processors round FFT, exp and sums differently, and no test may depend on that. Heights and
slopes are changed by -1, 0 or 1 units in the last place, in the same way for the same line.
"""

import os

import numpy as np

from elastomer_friction import kernels
from elastomer_friction.kernels.lines import line, self_affine

WANTED = os.environ.get("LAST_BIT")
exact_line = self_affine.sample_line


def perturbed_line(amplitude, phases, elements, steps_per_spacing):
    """Return a line as self_affine.sample_line does, with perturbed last bits."""
    seed = [int(WANTED), elements, steps_per_spacing, *phases.view(np.uint64).tolist()[:4]]
    rng = np.random.default_rng(seed)
    exact = exact_line(amplitude, phases, elements, steps_per_spacing)
    return tuple(values * (1.0 + rng.choice([-2e-16, 0.0, 2e-16], values.size)) for values in exact)


def perturb():
    """Perturb all lines of this process if LAST_BIT is set."""
    if WANTED:
        for module in (kernels, line, self_affine):
            module.sample_line = perturbed_line
