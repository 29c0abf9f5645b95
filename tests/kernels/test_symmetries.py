"""Symmetries of a realization: scales, cyclic shifts, the mirror image."""

import numpy as np
import pytest

from kernels import SCHEMES, Line, Quantities, amplitudes, draw_phases, run_case
from tests.cases import ALL, CASE, ELEMENTS, KEPT, M, line_of
from tests.reference_march import Elements, constants, relaxation, steady


def numbers(outcome):
    """Return every physical number of an outcome in one array."""
    scalars = [outcome.mu_1, outcome.indentation, outcome.contact_fraction]
    return np.concatenate([scalars, outcome.mu_2, outcome.jump, *outcome.curves])


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("power", [-20, 1, 33])
def test_heights_scale_bit_for_bit_by_powers_of_two(scheme, power):
    """h and F_N enter only as F_N / h, mu in proportion to h (DESIGN section 2)."""
    s = 2.0**power
    line, case = line_of(), CASE._replace(scheme=scheme)
    scaled = Line(s * line.z, s * line.slope, s * line.datum, M)
    one = run_case(line, case, ALL)
    other = run_case(scaled, case._replace(load=s * case.load), ALL)
    expected = s * numbers(one)
    expected[2] = one.contact_fraction  # the one number that does not scale
    np.testing.assert_array_equal(numbers(other), expected)


@pytest.mark.parametrize("scheme", SCHEMES)
def test_lengths_scale_bit_for_bit_by_powers_of_two(scheme):
    """The same samples on a spacing twice as wide: half the dimensionless speed, slopes twice."""
    line, case = line_of(), CASE._replace(scheme=scheme)
    wide = Line(line.z, 2.0 * line.slope, line.datum, 2 * M)
    one = run_case(line, case, ALL)
    other = run_case(wide, case._replace(speed=0.5 * case.speed), ALL)
    assert other.indentation == one.indentation
    assert other.mu_1 == 2.0 * one.mu_1
    np.testing.assert_array_equal(other.jump, 2.0 * one.jump)
    np.testing.assert_array_equal(other.curves, 2.0 * np.array(one.curves))


@pytest.mark.parametrize("shift", [1, 17])
def test_cyclic_shifts_change_nothing(shift):
    """Phases turned by q times the shift: the same line, samples rounded differently."""
    amplitude = amplitudes(0.7, ELEMENTS)
    phases = draw_phases(np.random.default_rng(1), ELEMENTS)
    q = 2.0 * np.pi * np.arange(1, phases.size + 1) / ELEMENTS
    shifted = Line.self_affine(amplitude, phases + q * shift, ELEMENTS, M)
    one, other = run_case(line_of(), CASE, ALL), run_case(shifted, CASE, ALL)
    np.testing.assert_allclose(numbers(other), numbers(one), rtol=1e-10, atol=1e-10)


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("load", [0.02, 0.5])
def test_mirror_image_moving_the_other_way_is_the_same(scheme, load):
    line = line_of()
    outcome = run_case(line, CASE._replace(load=load, scheme=scheme), ALL)
    mirrored, falling = line.z[::-1].copy(), -line.slope[::-1]
    dt = 1.0 / (M * CASE.speed)
    u, _, d = steady(mirrored, load, constants(scheme, dt)[0], direction=-1)
    assert outcome.indentation == pytest.approx(d + line.datum, rel=1e-10, abs=1e-10)
    step = constants(scheme, dt / 1.2)
    elements = Elements(mirrored, falling, u, d, load, step, direction=-1)
    mu, _, _ = relaxation(elements, KEPT[-1])
    # The curve carries the constant mu_2 - (steady step average): compare its course.
    course = outcome.curves[1] - outcome.curves[1][-1]
    np.testing.assert_allclose(course, -(mu[KEPT - 1] - mu[-1]), atol=1e-10)


def test_the_indentation_rate_is_an_effect_of_the_relaxation_alone():
    line = line_of()
    full = run_case(line, CASE, ALL)
    without = run_case(line, CASE, Quantities(indentation_rate=False))
    np.testing.assert_array_equal(without.mu_2, full.mu_2)
    np.testing.assert_array_equal(without.jump, full.jump)
    assert not np.allclose(without.curves, full.curves, rtol=1e-3, atol=0.0)
