"""What is pressed is the same whatever is guessed, and its sums are those of the samples."""

import numpy as np
import pytest

from elastomer_friction.kernels.model.contact import indentation_under
from elastomer_friction.kernels.quick.contacts.pressed import span_under, weighed_in_fours
from elastomer_friction.kernels.quick.contacts.pressure import friction
from elastomer_friction.kernels.quick.steady.spans import SPAN
from tests.kernels.quick.contacts.listed import Listed, everywhere


@pytest.mark.parametrize("size", [0, 3, 4, 21])
def test_moments_are_those_of_the_pressed_samples(size):
    threshold, weight, slope = np.random.default_rng(4).uniform(-1.0, 1.0, (3, size))
    p = np.maximum(0.2 - threshold, 0.0)
    expected = (weight @ p, (weight * slope) @ p, weight @ (p > 0.0))
    assert weighed_in_fours(threshold, weight, slope, 0.2) == pytest.approx(expected, rel=1e-12)
    assert weighed_in_fours(threshold, weight, None, 0.2)[0] == pytest.approx(weight @ p, rel=1e-12)
    expected = (p.sum(), slope @ p, (p > 0.0).sum())
    assert weighed_in_fours(threshold, None, slope, 0.2) == pytest.approx(expected, rel=1e-12)


def test_a_span_is_its_samples():
    listed = Listed(0.7, 100, 4, 2.0, 2.0)
    line = listed.at(3.0).line
    for b in (0, 7):
        z, slope = (values[b * SPAN : (b + 1) * SPAN] for values in line[:2])
        for deep in (-1e9, float(np.median(z - 3.0 * slope)), 1e9):
            p = np.maximum(deep - (z - 3.0 * slope), 0.0)
            expected = (p.sum(), p @ slope, (p > 0.0).sum())
            assert span_under(line, b, deep) == pytest.approx(expected, rel=1e-12)


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
