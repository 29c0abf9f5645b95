"""Oscillation about rest: the small response is the complex modulus, the large one saturates."""

import numpy as np
import pytest

from elastomer_friction.studies.oscillation.figure import modulus, motions, unit
from elastomer_friction.studies.style import shift_factors

pytestmark = pytest.mark.exhaustive  # its scenes compile kernels of their own

STUDY = ("oscillation",)


@pytest.fixture(scope="module")
def found(groups):
    """Return, by name, the data, G*/G - 1 and the measured response in its units."""
    named = {}
    for name, data in groups.items():
        omega = 2.0 * np.pi * motions(data)[-1].frequency * shift_factors(data)
        response = data.mu_in_phase.values + 1j * data.mu_quadrature.values
        named[name] = data, modulus(data, name, omega), response / unit(data)
    return named


@pytest.mark.parametrize("name", ["", "rubber"])
def test_the_small_response_is_the_complex_modulus(found, name):
    data, expected, response = found[name]
    error = np.hypot(data.mu_quadrature_error, data.mu_in_phase_error).values / unit(data)
    assert (abs(response - expected) < 3.5 * error + 0.02 * abs(expected)).all()
    assert (error < 0.15 * abs(expected)).all()


@pytest.mark.parametrize("name", ["", "rubber"])
def test_all_frequencies_see_the_same_contact(found, name):
    """Lines scatter, but alike at all temperatures: one real factor, and no phase.

    In phase there is, besides, the force that samples leave of a line at rest: 0.1 % of G.
    """
    _, expected, response = found[name]
    factor = (response / expected).real.mean()
    assert (abs(response / factor - expected) < 0.01 * abs(expected) + 2e-3).all()


def test_the_large_response_of_cold_rubber_saturates(found):
    for data, _, _ in found.values():
        large, small = motions(data)
        peaks = [
            abs(data.trace_mu.where(data.trace_segment == motion.segment)).max("event")
            for motion in (large, small)
        ]
        linear = peaks[1] * large.amplitude / small.amplitude
        assert peaks[0][0] < 0.2 * linear[0]
        assert (peaks[0] < 3.0 * data.rms_slope).all()
