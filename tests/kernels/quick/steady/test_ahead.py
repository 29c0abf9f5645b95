"""Where steady sliding is guessed at another speed, against where it is."""

import numpy as np
import pytest

from elastomer_friction.kernels import steady_sliding
from elastomer_friction.kernels.quick.steady.ahead import indentation_ahead
from elastomer_friction.kernels.quick.steady.carry import NO_GAPS, carry, decay_of
from elastomer_friction.kernels.quick.steady.contacts import first, room_for
from tests.kernels.quick.steady.given import LINES, LOADS, known, line_of

everywhere = pytest.mark.parametrize(
    "given", [(*point, load) for point in LINES for load in LOADS], ids=str
)


def guessed(given, ratio):
    """Return (d, guess, true d) at a speed and at ``ratio`` times the speed."""
    *what, speed, load = given
    line = line_of(*what)
    total = load * line.z.size
    law, spans, own = known(line, speed)
    (_, d), _ = steady_sliding(law, line.z, total)
    room = room_for(line.slope, speed)
    *_, touching, pieces = carry(decay_of(law), line.z, spans, own.stay, d, room, None, NO_GAPS)
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
