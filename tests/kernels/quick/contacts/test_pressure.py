"""Friction of listed contacts against the quadrature over the samples of any state."""

import numpy as np
import pytest

from elastomer_friction.kernels import quadrature
from elastomer_friction.kernels.model.contact import indentation_under
from elastomer_friction.kernels.model.friction import elastic_correction
from elastomer_friction.kernels.quick.contacts.pressure import (
    elastic_part,
    friction,
    friction_everywhere,
)
from tests.kernels.quick.contacts.listed import Listed, everywhere


@pytest.mark.parametrize("ratio", [0.3, 1.0, 1.2, 5.0])
@everywhere
def test_friction_is_that_of_the_quadrature(given, ratio):
    listed = Listed(*given)
    line, (w, d), speed = listed.line, listed.state, listed.speed
    there = ratio * speed
    mu, rate, contact = quadrature(line.z, line.slope, w, d, speed, there, listed.total)
    part = listed.at(there)
    steep = np.abs(line.slope).max()
    scale = d + there * steep  # of pressures: what rounding is relative to
    for guess in (d, 0.0, -1e9, 1e9):
        deep, _ = indentation_under(part, listed.total, guess)
        assert deep - d == pytest.approx(rate, abs=1e-13 * scale)
    found, count = friction(part, deep)
    assert found == pytest.approx(mu, abs=steep * (1e-12 + 1e-14 * scale / listed.load))
    assert count / line.z.size == pytest.approx(contact, rel=1e-10)


@everywhere
def test_elastic_part_is_the_correction_of_any_state(given):
    listed = Listed(*given)
    line, (w, d), speed, m = listed.line, listed.state, listed.speed, listed.line.steps_per_spacing
    part = listed.at(speed)
    deep, _ = indentation_under(part, listed.total, d)
    found = elastic_part(part, listed.contacts, deep, float(m))
    expected = elastic_correction(line.z, line.slope, w, d, speed, deep - d, m)
    steep = np.abs(line.slope).max()
    assert found == pytest.approx(expected, abs=1e-12 * steep * (listed.total + speed * steep))


@pytest.mark.parametrize("there", [0.5, 2.0, 3.0])
def test_where_all_is_pressed_the_sums_of_the_line_will_do(there):
    listed = Listed(0.7, 100, 4, 2.0, 60.0)
    part = listed.at(there)
    deep, _ = indentation_under(part, listed.total, listed.state.d)
    mu, count = friction(part, deep)
    assert count == listed.line.z.size
    expected = pytest.approx((mu, deep), rel=1e-13)
    line = listed.line
    assert friction_everywhere(line.z, line.slope, listed.spans, there, listed.total) == expected
