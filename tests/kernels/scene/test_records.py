"""What is kept of a step, against plain numpy."""

import itertools

import numpy as np
import pytest

from elastomer_friction.kernels.scene.records import (
    Film,
    Lengths,
    Trace,
    count_lengths,
    keep_frame,
    keep_trace,
)

RNG = np.random.default_rng(4)


def test_a_trace_is_friction_force_and_contact_at_the_moment_the_force_acts():
    before, now = RNG.normal(size=(2, 40))
    p = np.maximum(0.0, RNG.normal(size=40))
    trace = Trace(*np.zeros((8, 3)))
    keep_trace(trace, 1, 0.3, before, now, 2.0, 1.0, p)
    acting = 0.7 * now + 0.3 * before
    assert trace.mu[1] == pytest.approx(p @ acting / p.sum())
    assert trace.friction_force[1] == pytest.approx(np.mean(p * acting))
    assert trace.normal_force[1] == pytest.approx(p.mean())
    assert trace.contact_fraction[1] == np.mean(p > 0.0)
    assert trace.indentation[1] == pytest.approx(1.3)
    for values in trace:
        assert values[0] == values[2] == 0.0


def test_friction_is_not_a_number_where_nothing_touches():
    trace = Trace(*np.zeros((8, 1)))
    keep_trace(trace, 0, 0.3, np.ones(4), np.ones(4), 1.0, 1.0, np.zeros(4))
    assert np.isnan(trace.mu[0])
    assert trace.friction_force[0] == trace.normal_force[0] == trace.contact_fraction[0] == 0.0


@pytest.mark.parametrize("share", [0.1, 0.5, 0.9])
def test_lengths_are_those_of_runs_round_the_period(share):
    pressed = RNG.random(200) < share
    free = int(np.argmin(pressed))
    turned = np.roll(pressed, -free)
    runs = [len(list(run)) for touching, run in itertools.groupby(turned) if touching]
    for shift in (0, 1, 57):
        lengths = Lengths(np.array([1.0, 2.0, 4.0, 8.0, 300.0]), np.zeros(4))
        count_lengths(lengths, np.roll(pressed, shift).astype(float))
        np.testing.assert_array_equal(lengths.counts, np.histogram(runs, lengths.edges)[0])


def test_full_contact_is_one_and_none_is_none():
    lengths = Lengths(np.array([0.0, 9.5, 20.0]), np.zeros(2))
    count_lengths(lengths, np.ones(10))
    count_lengths(lengths, np.zeros(10))
    np.testing.assert_array_equal(lengths.counts, [0.0, 1.0])


def test_a_frame_is_the_line_over_the_foundation_and_the_elements():
    film = Film(*np.zeros((2, 2, 5)))
    z, u = RNG.normal(size=(2, 5))
    keep_frame(film, 1, z, 0.5, u)
    np.testing.assert_array_equal(film.height, [np.zeros(5), z - 0.5])
    np.testing.assert_array_equal(film.displacement, [np.zeros(5), u])
