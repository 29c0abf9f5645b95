"""Steps along a path: whole samples, bisected times, rests and turning points."""

import numpy as np
import pytest

from elastomer_friction.kernels.motion.path import (
    Path,
    along,
    crossed,
    fewest_steps,
    geometric,
    growth,
    oscillating,
    piecewise,
)


def test_crossed_goes_both_ways_and_leaves_out_what_is_near_an_end():
    np.testing.assert_array_equal(crossed(0.0, 3.0), [1.0, 2.0, 3.0])
    np.testing.assert_array_equal(crossed(0.9, 3.1), [2.0, 3.1])
    np.testing.assert_array_equal(crossed(0.5, -2.5), [0.0, -1.0, -2.0, -2.5])
    np.testing.assert_array_equal(crossed(0.0, 1.0 + 1e-12), [1.0])
    np.testing.assert_array_equal(crossed(0.1, 0.2), [0.2])


def test_geometric_steps_fill_the_duration_and_begin_no_later():
    dt = geometric(10.0, 0.1, 1.5)
    assert dt.sum() == pytest.approx(10.0, rel=1e-14)
    np.testing.assert_allclose(dt[1:] / dt[:-1], 1.5)
    assert 0.1 / 1.5 < dt[0] <= 0.1
    assert geometric(0.0, 0.1, 1.5).size == 0
    assert geometric(1.0, 5.0, 1.5).tolist() == [1.0]


def test_refinement_is_that_of_the_samples():
    assert fewest_steps(1) == fewest_steps(4) == 64
    assert fewest_steps(16) == 2 * fewest_steps(8)
    assert growth(8) - 1.0 == 0.5 * (growth(4) - 1.0)


def test_times_of_whole_samples_are_found_to_the_last_bits():
    """X = t^3, which no formula of the module knows."""
    path = Path(lambda t: t**3, np.array([0.0, 4.0]))
    place, dt = along(path, 4, 0.0)
    t = np.cumsum(dt)
    whole = place % 1.0 == 0.0
    assert set(range(1, 65)) <= set(place)
    np.testing.assert_allclose(t[whole], np.cbrt(place[whole]), rtol=1e-14)
    np.testing.assert_allclose(place, t**3, rtol=1e-12)
    assert dt.max() <= 4.0 / 32 + 1e-12


def test_a_path_that_rests_and_comes_back():
    path = piecewise((0.0, 1.0, 2.0, 3.0), (1.0, 0.0, 0.0, -1.0), 4)
    place, dt = along(path, 4, 0.5)
    t = np.cumsum(dt)
    assert place.max() == 2.5
    assert place[-1] == 0.5
    assert np.all(np.diff(place[(t > 1.0) & (t < 2.0 + 1e-9)]) == 0.0)


def test_turning_points_of_an_oscillation_are_breaks():
    path = oscillating(0.5, 2.0, 0.25, 3, 1)
    assert path.breaks.size == 10
    rates = np.array(
        [(path.where(t + 1e-6) - path.where(t - 1e-6))[0] / 2e-6 for t in path.breaks[1:, None]]
    )
    np.testing.assert_allclose(rates[[0, 1, 3, 4, 6, 7]], 0.0, atol=1e-4)
    assert oscillating(50.0, 2.0, 0.25, 3, 1).breaks.tolist() == [0.0, 4.0, 8.0, 12.0]
