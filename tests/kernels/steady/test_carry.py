"""A sweep by spans against the sweep over every sample."""

import numpy as np
import pytest

from kernels import Line, steady_sliding
from kernels.friction import _reach
from kernels.steady.carry import carry, decay_of, room_for
from kernels.steady.plain import sweep
from tests.kernels.steady.given import LINES, LOADS, known, line_of, touching

EVERYWHERE = pytest.mark.parametrize(("hurst", "elements", "m", "speed"), LINES)


def both(line, speed, load, scheme="exponential"):
    """Return (d, the plain sweep's w and sums, carry's w, sums and contacts) at the load's d."""
    law, spans, own = known(line, speed, scheme)
    (_, d), _ = steady_sliding(law, line.z, load * line.z.size)
    plain, w = np.empty_like(line.z), np.empty_like(line.z)
    total, slope, count = sweep(law, line.z, d, spans.deepest, plain)
    contacts = room_for(line.slope, speed)
    found = carry(decay_of(law), line.z, spans, own.stay, d, contacts, w)
    expected = law.stiffness * total, law.stiffness * slope, count
    assert found == carry(decay_of(law), line.z, spans, own.stay, d)  # whatever is filled
    return d, plain, expected, w, found, contacts


@pytest.mark.parametrize("scheme", ["exponential", "implicit-euler"])
@pytest.mark.parametrize("load", LOADS)
@EVERYWHERE
def test_state_and_forces_are_those_of_the_plain_sweep(hurst, elements, m, speed, load, scheme):
    line = line_of(hurst, elements, m)
    d, plain, expected, w, (total, slope, count, _), _ = both(line, speed, load, scheme)
    np.testing.assert_allclose(w, plain, rtol=1e-12, atol=1e-150)
    # The plain sum loses digits as the stiffness, m vbar and more: 4000 here at most.
    assert (total, slope) == pytest.approx(expected[:2], rel=1e-10 * (1.0 + 1e-3 * d / load))
    assert count == expected[2]


@pytest.mark.parametrize("load", LOADS)
@EVERYWHERE
def test_pieces_are_the_samples_in_contact(hurst, elements, m, speed, load):
    line = line_of(hurst, elements, m)
    d, plain, _, _, (*_, pieces), contacts = both(line, speed, load)
    z, n = line.z, line.z.size
    touches = touching(z, plain, d)
    seen = np.zeros(n, int)
    for (top, bottom, joined), (ahead, behind, free) in zip(
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
