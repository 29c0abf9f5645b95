"""Friction over pieces of contact against the quadrature over the samples of any state."""

import numpy as np
import pytest

from kernels import quadrature, steady_sliding
from kernels.friction import elastic_correction
from kernels.patches.pieces import (
    COLUMNS,
    balance,
    elastic_part,
    forces,
    median_width,
    press_pieces,
    steepest,
    sum_pieces,
)
from kernels.patches.samples import samples_per_contact
from kernels.steady.carry import carry, decay_of, first, room_for
from kernels.steady.spans import thresholds_of
from tests.kernels.steady.given import LINES, LOADS, known, line_of, touching


class Listed:
    """The contacts of a steady state, as pieces and as a state of every sample."""

    def __init__(self, hurst, elements, m, speed, load):
        self.line, self.speed, self.load = line_of(hurst, elements, m), speed, load
        z, slope = self.line.z, self.line.slope
        self.law, self.spans, own = known(self.line, speed)
        self.total = load * z.size
        self.state, _ = steady_sliding(self.law, z, self.total)
        room = room_for(slope, speed)
        self.decay = decay_of(self.law)
        *_, pieces = carry(self.decay, z, self.spans, own.stay, self.state.d, room)
        self.contacts = first(room, pieces)
        self.table = np.empty((pieces, COLUMNS))
        sum_pieces(z, slope, self.spans, self.contacts, self.table)

    def at(self, speed):
        """Return (d + d', forces) at the moment when the speed has become ``speed``."""
        z, slope = self.line.z, self.line.slope
        press = thresholds_of(z, slope, speed, self.law.stiffness).press
        press_pieces(z, slope, press, self.contacts, speed, self.table)
        deep = balance(z, slope, self.contacts, self.table, speed, self.total)
        return deep, forces(z, slope, self.contacts, self.table, speed, deep)


STATES = [(*point, load) for point in LINES for load in LOADS]
everywhere = pytest.mark.parametrize("given", STATES)


@pytest.mark.parametrize("ratio", [0.3, 1.0, 1.2, 5.0])
@everywhere
def test_friction_is_that_of_the_quadrature(given, ratio):
    listed = Listed(*given)
    line, (w, d), speed = listed.line, listed.state, listed.speed
    there = ratio * speed
    mu, rate, contact = quadrature(line.z, line.slope, w, d, speed, there, listed.total)
    deep, force = listed.at(there)
    steep = np.abs(line.slope).max()
    scale = d + there * steep  # of pressures: what rounding is relative to
    assert deep - d == pytest.approx(rate, abs=1e-13 * scale)
    assert force.normal == pytest.approx(listed.total, rel=1e-13 * scale / listed.load)
    assert force.tangential / force.normal == pytest.approx(
        mu, abs=steep * (1e-12 + 1e-14 * scale / listed.load)
    )
    assert force.contact / line.z.size == pytest.approx(contact, rel=1e-10)


@everywhere
def test_elastic_part_is_the_correction_of_any_state(given):
    listed = Listed(*given)
    line, (w, d), speed, m = listed.line, listed.state, listed.speed, listed.line.steps_per_spacing
    deep, force = listed.at(speed)
    found = elastic_part(line.z, line.slope, listed.contacts, force, deep, speed, float(m))
    expected = elastic_correction(line.z, line.slope, w, d, speed, deep - d, m)
    steep = np.abs(line.slope).max()
    assert found == pytest.approx(expected, abs=1e-12 * steep * (listed.total + speed * steep))


@everywhere
def test_widths_and_slopes_are_those_of_the_samples(given):
    listed = Listed(*given)
    line, (w, d) = listed.line, listed.state
    width = median_width(line.z, d, listed.decay, listed.contacts, listed.table)
    assert width == samples_per_contact(d - (line.z - w))
    expected = np.abs(line.slope[touching(line.z, w, d)]).max()
    assert steepest(line.slope, listed.spans, listed.contacts) == expected
