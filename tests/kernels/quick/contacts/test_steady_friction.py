"""Friction of steady sliding: on the line where contacts are wide, on finer samples elsewhere."""

import numpy as np
import pytest

from elastomer_friction.kernels import Line, amplitudes, draw_phases
from elastomer_friction.kernels.quick.contacts.refined import NARROW
from tests.kernels.quick.contacts.one_load import one_load

ELEMENTS = 200


def slide(speed, load, steps=8, scheme="exponential"):
    """Return steady sliding on a random line, at vbar and Fbar."""
    phases = draw_phases(np.random.default_rng(4), ELEMENTS)
    line = Line.self_affine(amplitudes(0.7, ELEMENTS), phases, ELEMENTS, steps)
    others = (1.2 * speed, 0.8 * speed, speed)
    return line, one_load(line, speed, scheme, load * line.z.size, others)


def test_wide_contacts_are_seen_on_the_line_itself():
    _, found = slide(0.1, 3.0)
    assert found.samples == found.samples_seen >= NARROW
    assert found.seen is None


def test_narrow_contacts_are_seen_on_finer_samples_of_a_part_of_the_line():
    line, found = slide(100.0, 1e-3)
    assert found.seen.fold > 1
    assert found.samples_seen == found.seen.samples == found.seen.fold * found.samples
    assert found.samples < NARROW
    assert found.updates > line.z.size
    assert found.seen.updates < 0.1 * line.z.size * found.seen.fold
    assert 0.0 < found.contact < 0.01


@pytest.mark.parametrize(("speed", "load"), [(0.1, 3.0), (100.0, 1e-3)])
def test_jump_has_the_sign_of_the_step_and_vanishes_with_it(speed, load):
    _, found = slide(speed, load)
    faster, slower, same = found.jumps
    assert faster > 0.0 > slower
    assert same == pytest.approx(0.0, abs=1e-12)


def test_few_samples_that_are_refined_agree_with_many():
    few, many = slide(30.0, 1e-2, 4)[1], slide(30.0, 1e-2, 64)[1]
    assert few.mu == pytest.approx(many.mu, rel=0.02)
    assert few.indentation == pytest.approx(many.indentation, rel=0.02)
    assert few.contact == pytest.approx(many.contact, rel=0.05)


def test_rigid_shapes_of_samples_alone_are_never_refined():
    z = np.abs(np.linspace(-1.0, 1.0, 64, endpoint=False))
    slope = np.sign(np.linspace(-1.0, 1.0, 64, endpoint=False)) / 32.0
    line = Line.from_samples(z, slope, 8)
    assert not line.band_limited
    assert one_load(line, 10.0, "exponential", 1e-3 * z.size).seen is None
