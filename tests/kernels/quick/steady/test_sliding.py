"""The indentation under loads, by spans: the plain solver's, from any guess, in few sweeps."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from elastomer_friction.kernels import steady_sliding
from elastomer_friction.kernels.quick.steady.ahead import indentation_ahead
from elastomer_friction.kernels.quick.steady.carry import carry, decay_of
from elastomer_friction.kernels.quick.steady.contacts import first, room_for
from elastomer_friction.kernels.quick.steady.sliding import (
    POWER_STEPS,
    STEPS,
    approach,
    elastic_guess,
    indentation,
)
from tests.kernels.quick.steady.given import LINES, LOADS, everywhere, known, line_of, on_every_line
from tests.sizes import size


def solved(line, speed, load, guess=None, scheme="exponential"):
    """Return d by spans, and the number of sweeps."""
    law, spans, own = known(line, speed, scheme)
    total, decay = load * line.z.size, decay_of(law)
    steps = STEPS if guess is None else POWER_STEPS
    guess = elastic_guess(line.z, spans.deepest, total) if guess is None else guess
    to = decay, line.z, spans, own.stay
    (near,) = approach(*to, np.array([total]), np.array([guess]), steps)
    d, after, _, _ = indentation(*to, total, near, room_for(line.slope, speed))
    return d, steps + after


def plain(line, speed, load, scheme="exponential"):
    """Return d of the plain solver."""
    return steady_sliding(known(line, speed, scheme)[0], line.z, load * line.z.size)[0].d


@pytest.mark.parametrize("scheme", ["exponential", "implicit-euler"])
@pytest.mark.parametrize("load", LOADS)
@on_every_line
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
    together = approach(*to, loads, guesses, STEPS)
    for some in (slice(0, 1), slice(3, 7), slice(2, 20), slice(None, None, -1)):
        found = approach(*to, loads[some].copy(), guesses[some].copy(), STEPS)
        np.testing.assert_array_equal(found, together[some])


def guessed(given, ratio):
    """Return (d, guess, true d) at a speed and at ``ratio`` times the speed."""
    *what, speed, load = given
    line = line_of(*what)
    total = load * line.z.size
    law, spans, own = known(line, speed)
    (_, d), _ = steady_sliding(law, line.z, total)
    room = room_for(line.slope, speed)
    *_, touching, pieces = carry(decay_of(law), line.z, spans, own.stay, d, room, None)
    later = known(line, ratio * speed)[0]
    once = decay_of(later).once
    guess = indentation_ahead(once, line.z, d, total, touching, first(room, pieces))
    return d, guess, steady_sliding(later, line.z, total)[0].d


@everywhere
def test_at_the_same_speed_it_is_the_same_indentation(given):
    d, guess, _ = guessed(given, 1.0)
    assert guess == pytest.approx(d, rel=1e-12)


@everywhere
def test_it_is_exact_while_the_same_samples_touch(given):
    d, guess, true = guessed(given, 1.0 + 1e-7)
    assert guess == pytest.approx(true, rel=1e-12, abs=max(1e-15, 1e-4 * abs(true - d)))


@pytest.mark.parametrize("ratio", [0.8, 1.2])
def test_far_off_it_is_nearer_than_where_one_comes_from(ratio):
    """Over many lines, loads and speeds the error is of second order in the change."""
    moved, missed = [], []
    for hurst, elements, m, speed in (
        (0.3, 400, 4, 2.0),
        (0.7, 400, 4, 20.0),
        (1.0, 400, 4, 200.0),
    ):
        for load in (0.01, 0.1, 1.0):
            d, guess, true = guessed((hurst, elements, m, speed, load), ratio)
            moved.append(abs(true - d))
            missed.append(abs(guess - true))
    assert np.all(np.array(missed) < 0.5 * np.array(moved))
    assert np.median(np.array(missed) / np.array(moved)) < 0.2
