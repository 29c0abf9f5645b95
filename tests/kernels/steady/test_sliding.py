"""The indentation under a load, by spans: the plain solver's, from any guess, in few sweeps."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kernels import steady_sliding
from kernels.steady.carry import decay_of
from kernels.steady.contacts import room_for
from kernels.steady.sliding import elastic_guess, indentation
from tests.kernels.steady.given import LINES, LOADS, known, line_of
from tests.sizes import size


def solved(line, speed, load, guess=None, scheme="exponential"):
    """Return (d, sweeps) by spans, and d of the plain solver."""
    law, spans, own = known(line, speed, scheme)
    total = load * line.z.size
    guess = elastic_guess(line.z, spans.deepest, total) if guess is None else guess
    room = room_for(line.slope, speed)
    d, sweeps, _ = indentation(decay_of(law), line.z, spans, own.stay, total, guess, room)
    (_, expected), _ = steady_sliding(law, line.z, total)
    return d, sweeps, expected


@pytest.mark.parametrize("scheme", ["exponential", "implicit-euler"])
@pytest.mark.parametrize("load", LOADS)
@pytest.mark.parametrize(("hurst", "elements", "m", "speed"), LINES)
def test_indentation_is_that_of_the_plain_solver(hurst, elements, m, speed, load, scheme):
    d, sweeps, expected = solved(line_of(hurst, elements, m), speed, load, None, scheme)
    # The plain balance is known to 1e-15 of d times the stiffness, m vbar and more.
    assert d == pytest.approx(expected, rel=1e-12 + 1e-15 * (1.0 + m * speed) * expected / load)
    assert sweeps <= 6


@settings(max_examples=size(200, 20))
@given(
    st.sampled_from(LINES),
    st.floats(-9.0, 3.0).map(lambda power: 10.0**power),
    st.floats(-12.0, 6.0).map(lambda power: 10.0**power),
)
def test_any_guess_leads_to_the_root(point, load, guess):
    hurst, elements, m, speed = point
    line = line_of(hurst, elements, m)
    d, sweeps, _ = solved(line, speed, load, guess)
    expected, _, _ = solved(line, speed, load)
    assert d == pytest.approx(expected, rel=1e-13)
    assert sweeps <= 12


@pytest.mark.parametrize(("load", "speed"), [(1e-100, 1e-12), (1e-100, 1e12), (1e100, 1.0)])
def test_the_smallest_and_the_largest_loads_end(load, speed):
    d, sweeps, _ = solved(line_of(0.7, 50, 2), speed, load)
    assert np.isfinite(d)
    assert sweeps <= 40
