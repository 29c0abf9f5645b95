"""The Fourier shift against the modes of a band-limited line themselves."""

import numpy as np
import pytest

from elastomer_friction.kernels import amplitudes, draw_phases, sample_line
from elastomer_friction.kernels.lines.self_affine import mode_numbers
from elastomer_friction.kernels.motion.fourier import Shifted


@pytest.mark.parametrize("fraction", [0.3, 0.5, 1.0])
@pytest.mark.parametrize(("elements", "m"), [(16, 1), (16, 3), (15, 1)])
def test_the_shift_is_that_of_every_mode(elements, m, fraction):
    """With one sample to a spacing an even line has a wave of two samples."""
    phases = draw_phases(np.random.default_rng(1), elements)
    amplitude = amplitudes(0.5, elements)
    q = 2.0 * np.pi * mode_numbers(elements) / elements
    at = np.outer((np.arange(elements * m) - fraction) / m, q) + phases
    z, slope = Shifted(*sample_line(amplitude, phases, elements, m), m).by(fraction)
    np.testing.assert_allclose(z, np.cos(at) @ amplitude, atol=1e-13)
    np.testing.assert_allclose(slope, -np.sin(at) @ (amplitude * q), atol=1e-13)


def test_the_energy_of_a_line_does_not_depend_on_the_fraction():
    rng = np.random.default_rng(2)
    z = rng.normal(size=63)
    shifted = Shifted(z, np.zeros_like(z), 1)
    sums = [np.sum(shifted.by(f)[0] ** 2) for f in (0.0, 0.25, 0.5, 0.9)]
    np.testing.assert_allclose(sums, np.sum(z**2), rtol=1e-13)
