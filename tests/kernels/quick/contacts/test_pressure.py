"""What touches and what is pressed, listed, against any state sample by sample."""

import numpy as np
import pytest

from elastomer_friction.kernels import quadrature, steady_sliding
from elastomer_friction.kernels.model.contact import indentation_under
from elastomer_friction.kernels.model.friction import _covered, elastic_correction
from elastomer_friction.kernels.quick.contacts.pressed import (
    MovingLine,
    pressed,
    room_for_pressed,
)
from elastomer_friction.kernels.quick.contacts.pressure import (
    elastic_part,
    friction,
)
from elastomer_friction.kernels.quick.contacts.touching import (
    list_touching,
    median_width,
    room_for_all,
    steepest,
)
from elastomer_friction.kernels.quick.steady.carry import carry, decay_of
from elastomer_friction.kernels.quick.steady.contacts import first, room_for
from elastomer_friction.kernels.quick.steady.spans import SPAN
from elastomer_friction.kernels.quick.steady.thresholds import thresholds_of
from elastomer_friction.kernels.scene.samples import samples_per_contact
from tests.kernels.quick.steady.given import everywhere, known, line_of, touching


class Listed:
    """Steady sliding on a random line: (w, d) by the plain solver, and its contacts."""

    def __init__(self, hurst, elements, m, speed, load):
        self.line, self.speed, self.load = line_of(hurst, elements, m), speed, load
        z, slope = self.line.z, self.line.slope
        self.law, self.spans, own = known(self.line, speed)
        self.total = load * z.size
        self.state, _ = steady_sliding(self.law, z, self.total)
        room = room_for(slope, speed)
        self.decay = decay_of(self.law)
        *_, pieces = carry(self.decay, z, self.spans, own.stay, self.state.d, room, None)
        self.contacts = first(room, pieces)
        self.touching = list_touching(z, slope, self.contacts, room_for_all(z.size))

    def at(self, speed, guess=None):
        """Return what touches, at the moment when the speed has become ``speed``.

        guess : of the indentation and its rate; None: the indentation.
        """
        z, slope = self.line.z, self.line.slope
        press = thresholds_of(z, slope, speed, self.law.stiffness).press
        line = MovingLine(z, slope, self.spans, speed, press)
        guess = self.state.d if guess is None else guess
        return pressed(line, self.touching, guess, room_for_pressed(z.size))


@everywhere
def test_every_touching_sample_is_listed_once_as_far_as_contact_covers_it(given):
    listed = Listed(*given)
    line, (w, d) = listed.line, listed.state
    weight = np.zeros(line.z.size)
    at = {height: j for j, height in enumerate(line.z)}
    for covered, height, slope in zip(*listed.touching[:3], strict=True):
        weight[at[height]] += covered
        assert slope == line.slope[at[height]]
    for b in listed.touching.spans:
        weight[b * SPAN : (b + 1) * SPAN] += 1.0
    expected = np.zeros(line.z.size)
    for j in np.flatnonzero(touching(line.z, w, d)):
        expected[j] = _covered(line.z, line.slope, w, d, listed.speed, j)
    np.testing.assert_allclose(weight, expected, rtol=1e-6, atol=1e-9)


@everywhere
def test_widths_and_slopes_are_those_of_the_samples(given):
    listed = Listed(*given)
    line, (w, d) = listed.line, listed.state
    width = median_width(line.z, d, listed.decay, listed.contacts)
    assert width == samples_per_contact(d - (line.z - w))
    expected = np.abs(line.slope[touching(line.z, w, d)]).max()
    assert steepest(listed.spans, listed.touching) == expected


@everywhere
def test_friction_is_the_same_whatever_was_guessed(given):
    listed = Listed(*given)
    d = listed.state.d
    parts = [listed.at(1.2 * listed.speed, guess) for guess in (d, -1e9, 1e9)]
    assert parts[1].spans.size == 0
    assert parts[2].loose.size == 0
    deep, _ = indentation_under(parts[0], listed.total, d)
    found = [friction(part, deep) for part in parts]
    steep = np.abs(listed.line.slope).max()
    for mu, count in found[1:]:
        assert count == pytest.approx(found[0][1], rel=1e-12)
        assert mu == pytest.approx(found[0][0], rel=1e-10, abs=1e-12 * steep)


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
