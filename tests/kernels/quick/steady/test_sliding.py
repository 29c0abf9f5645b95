"""The indentation under loads, by spans: the plain solver's, from any guess, in few sweeps."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from elastomer_friction.kernels import steady_sliding
from elastomer_friction.kernels.quick.steady.carry import NO_GAPS, decay_of
from elastomer_friction.kernels.quick.steady.contacts import room_for
from elastomer_friction.kernels.quick.steady.sliding import (
    POWER_STEPS,
    STEPS,
    approach,
    elastic_guess,
    indentation,
)
from tests.kernels.quick.steady.given import LINES, LOADS, known, line_of
from tests.sizes import size


def solved(line, speed, load, guess=None, scheme="exponential"):
    """Return d by spans, and the number of sweeps."""
    law, spans, own = known(line, speed, scheme)
    total, decay = load * line.z.size, decay_of(law)
    steps = STEPS if guess is None else POWER_STEPS
    guess = elastic_guess(line.z, spans.deepest, total) if guess is None else guess
    to = decay, line.z, spans, own.stay
    (near,) = approach(*to, np.array([total]), np.array([guess]), steps, NO_GAPS)
    d, after, _, _ = indentation(*to, total, near, room_for(line.slope, speed), NO_GAPS)
    return d, steps + after


def plain(line, speed, load, scheme="exponential"):
    """Return d of the plain solver."""
    return steady_sliding(known(line, speed, scheme)[0], line.z, load * line.z.size)[0].d


@pytest.mark.parametrize("scheme", ["exponential", "implicit-euler"])
@pytest.mark.parametrize("load", LOADS)
@pytest.mark.parametrize(("hurst", "elements", "m", "speed"), LINES)
def test_indentation_is_that_of_the_plain_solver(hurst, elements, m, speed, load, scheme):
    line = line_of(hurst, elements, m)
    d, sweeps = solved(line, speed, load, None, scheme)
    expected = plain(line, speed, load, scheme)
    # The plain balance is known to 1e-15 of d times the stiffness, m vbar and more.
    assert d == pytest.approx(expected, rel=1e-12 + 1e-15 * (1.0 + m * speed) * expected / load)
    assert sweeps <= 7


@settings(max_examples=size(200, 20))
@given(
    st.sampled_from(LINES),
    st.floats(-9.0, 3.0).map(lambda power: 10.0**power),
    st.floats(-12.0, 6.0).map(lambda power: 10.0**power),
)
def test_any_guess_leads_to_the_root(point, load, guess):
    hurst, elements, m, speed = point
    line = line_of(hurst, elements, m)
    d, sweeps = solved(line, speed, load, guess)
    assert d == pytest.approx(solved(line, speed, load)[0], rel=1e-13)
    assert sweeps <= 16


@pytest.mark.parametrize(("load", "speed"), [(1e-100, 1e-12), (1e-100, 1e12), (1e100, 1.0)])
def test_the_smallest_and_the_largest_loads_end(load, speed):
    d, sweeps = solved(line_of(0.7, 50, 2), speed, load)
    assert np.isfinite(d)
    assert sweeps <= 40


def test_what_is_found_under_a_load_depends_on_no_other_load():
    line = line_of(0.0, 500, 1)
    law, spans, own = known(line, 30.0)
    loads = line.z.size * np.geomspace(0.3, 10.0, 20)
    guesses = np.array([elastic_guess(line.z, spans.deepest, load) for load in loads])
    to = decay_of(law), line.z, spans, own.stay
    together = approach(*to, loads, guesses, STEPS, NO_GAPS)
    for some in (slice(0, 1), slice(3, 7), slice(2, 20), slice(None, None, -1)):
        found = approach(*to, loads[some].copy(), guesses[some].copy(), STEPS, NO_GAPS)
        np.testing.assert_array_equal(found, together[some])
