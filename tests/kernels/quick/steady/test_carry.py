"""A sweep by spans against the sweep over every sample, and the contacts that it lists."""

import numpy as np
import pytest

from elastomer_friction.kernels import Line
from elastomer_friction.kernels.model.friction import _reach
from tests.kernels.quick.steady.given import LOADS, both, line_of, on_every_line, touching


@pytest.mark.parametrize("scheme", ["exponential", "implicit-euler"])
@pytest.mark.parametrize("load", LOADS)
@on_every_line
def test_state_and_forces_are_those_of_the_plain_sweep(hurst, elements, m, speed, load, scheme):
    line = line_of(hurst, elements, m)
    d, plain, expected, w, (total, slope, count, _), _ = both(line, speed, load, scheme)
    np.testing.assert_allclose(w, plain, rtol=1e-12, atol=1e-150)
    # The plain sum loses digits as the stiffness, m vbar and more: 4000 here at most.
    assert (total, slope) == pytest.approx(expected[:2], rel=1e-10 * (1.0 + 1e-3 * d / load))
    assert count == expected[2]


@pytest.mark.parametrize("load", LOADS)
@on_every_line
def test_pieces_are_the_samples_in_contact(hurst, elements, m, speed, load):
    line = line_of(hurst, elements, m)
    d, plain, _, _, (*_, pieces), contacts = both(line, speed, load)
    z, n = line.z, line.z.size
    touches = touching(z, plain, d)
    seen = np.zeros(n, int)
    for (top, bottom, joined), (ahead, behind, free, total) in zip(
        contacts.ends[:pieces], contacts.edges[:pieces], strict=True
    ):
        seen[bottom : top + 1] += 1
        above, below = (top + 1) % n, (bottom - 1) % n
        assert joined == touches[above]
        assert free == pytest.approx(plain[top], rel=1e-12, abs=1e-150)
        reach = [
            0.5 if touches[k] else _reach(z, line.slope, plain, d, speed, j, k)
            for j, k in ((top, above), (bottom, below))
        ]
        assert total == pytest.approx((d - z[bottom : top + 1]).sum(), rel=1e-9, abs=1e-12)
        assert [ahead, behind] == pytest.approx(reach, rel=1e-6, abs=1e-9)
    np.testing.assert_array_equal(seen, touches)


@pytest.mark.parametrize("deepest", [0, 1, 15, 16, 31, 47])
def test_a_line_may_be_deepest_anywhere(deepest):
    """A patch over the end of the array, and over the deepest sample, is cut there."""
    angle = 2.0 * np.pi * (np.arange(48) - deepest) / 48
    z = 1.0 - np.cos(angle) + 0.1 * np.cos(9.0 * angle + 3.0)
    z, slope = z - z.min(), np.gradient(z)
    line = Line(z, slope, 0.0, 1)
    for load in LOADS:
        d, plain, _, w, (*_, count, pieces), contacts = both(line, 4.0, load)
        np.testing.assert_allclose(w, plain, rtol=1e-12)
        ends = contacts.ends[:pieces]
        assert (ends[:, 0] - ends[:, 1] + 1).sum() == count == touching(z, plain, d).sum()
