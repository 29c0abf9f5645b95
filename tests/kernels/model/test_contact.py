"""The contact step: the exact root from any guess, in few passes."""

import numpy as np
import pytest

from elastomer_friction.kernels import solve_indentation
from tests.references import sorted_root

EPS = 2.0**-52  # distance from 1.0 to the next number


def force(c, d):
    """Return the left side of the load balance."""
    return np.maximum(0.0, d - c).sum()


@pytest.mark.parametrize("n", [1, 2, 7, 8, 9, 16, 17, 100, 1003])
@pytest.mark.parametrize("mean_load", [1e-4, 0.1, 3.0, 100.0])
def test_any_guess_leads_to_the_root_of_the_sorted_sums(n, mean_load):
    c = np.random.default_rng(n).normal(size=n)
    for guess in (-1e6, -2.0, 0.0, 0.3, 2.0, 1e6):
        d, passes = solve_indentation(c, mean_load * n, guess)
        # Sums of n terms in different orders differ by at most n eps of the largest term.
        assert d == pytest.approx(sorted_root(c, mean_load * n), rel=1e-13, abs=1e-14)
        assert passes <= 12  # nested sets shrink fast


def test_a_set_that_repeats_ends_the_search_at_the_second_pass():
    """Iterating until d stops falling, by rounding, would sometimes cost a third pass."""
    for seed in range(200):
        c = np.random.default_rng(seed).normal(size=30)
        root = sorted_root(c, 20.0)
        assert solve_indentation(c, 20.0, root * (1.0 + 1e-9))[1] == 2
        assert solve_indentation(c, 20.0, root * (1.0 + 1e-9), np.ones(30))[1] == 2
        assert solve_indentation(c, 20.0, root * (1.0 - 1e-6))[1] <= 4


TIES = np.array([0.0, 0.0, 0.0, 1.0, 1.0, 5.0, 5.0])
KNOWN = [
    *[(np.full(n, 0.7), 0.3 * n, 0.0, 1.0) for n in (1, 3, 8, 21)],
    *[(TIES, load, guess, d) for load, d in ((1.5, 0.5), (8.0, 2.0)) for guess in (9.0, -9.0)],
    *[(TIES, 3.0, guess, 1.0) for guess in (9.0, -9.0)],  # the root is a tie
    (np.array([0.4, 0.8, 0.0, 0.3, 0.3, 0.9, 0.0, 0.1, 0.5, 0.6]), 0.8, 0.9, 0.3),
    (np.array([0.0, 1e-9, 2.0]), 1e-8, 1e9, 5.5e-9),  # a guess far above hides no small load
]


@pytest.mark.parametrize(("c", "load", "guess", "root"), KNOWN)
def test_ties_share_their_load_and_end_the_search(c, load, guess, root):
    assert solve_indentation(c, load, guess)[0] == pytest.approx(root, rel=1e-14)


@pytest.mark.parametrize("guess", [-50.0, -1.0, 0.2, 50.0])
@pytest.mark.parametrize("load", [0.01, 3.0, 1e3])
def test_weighted_root_balances_the_load(load, guess):
    rng = np.random.default_rng(8)
    c, stiffness = rng.normal(size=57), rng.uniform(0.5, 40.0, 57)
    d, _ = solve_indentation(c, load, guess, stiffness)
    assert np.sum(stiffness * np.maximum(0.0, d - c)) == pytest.approx(load, rel=1e-11)
    equal, _ = solve_indentation(c, 2.0 * load, guess, np.full(57, 2.0))
    assert equal == pytest.approx(sorted_root(c, load), rel=1e-13)


def test_weighted_ties_at_the_root_end_too():
    c = np.array([0.4, 0.4, 0.9, 1.1, 0.5, 0.5, 0.3, 0.5, 1.1, 0.4])
    stiffness = np.array([0.5, 0.5, 0.5, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.2])
    load = np.sum(stiffness * np.maximum(0.9 - c, 0.0))
    assert solve_indentation(c, load, -c.min(), stiffness)[0] == pytest.approx(0.9, rel=1e-13)


def test_quantised_heights_end_for_every_root_on_a_tie():
    """Measured heights are multiples of the resolution, and the root may be one, too."""
    rng = np.random.default_rng(0)
    for _ in range(2000):
        c = rng.integers(0, 10, rng.integers(1, 12)) / 10
        root = rng.integers(1, 12) / 10
        target = force(c, root)
        if target > 1e-12:
            d, _ = solve_indentation(c, target, rng.choice([root, c.min(), c.max(), 0.55]))
            assert d == pytest.approx(root, rel=1e-14)


@pytest.mark.parametrize(("guess", "passes"), [(0.5, 2), (1.0, 1), (1.5, 2), (1e9, 3)])
@pytest.mark.parametrize("stiffness", [(), (np.array([3.0, 1.0]),)])
def test_a_load_below_rounding_is_carried_by_the_lowest_element(guess, passes, stiffness):
    actual = solve_indentation(np.array([1.0, 2.0]), 1e-17, guess, *stiffness)
    assert actual == (1.0 + EPS, passes)  # it touches: friction must not become 0/0


def test_rounding_below_every_threshold_does_not_go_round_for_ever():
    """Newton's method used to fall below the ties at 1, be lifted above the others, and repeat."""
    c = np.array([1.0, 1.0, 1.0, 1.0, 1.0 + EPS, 1.0 + EPS, 1.0 + EPS])
    d, passes = solve_indentation(c, 2.0 * EPS, 1.0 + 2.0 * EPS)
    assert d == 1.0 + EPS
    assert passes <= 2 * c.size + 3


@pytest.mark.parametrize("stiffness", [(), (np.ones(3),)])
@pytest.mark.parametrize(("load", "guess"), [(np.nan, 0.5), (np.nan, 5.0), (1.0, np.nan)])
def test_what_is_no_number_stays_so_and_ends(load, guess, stiffness):
    d, passes = solve_indentation(np.array([0.0, 1.0, 2.0]), load, guess, *stiffness)
    assert np.isnan(d)
    assert passes <= 3


@pytest.mark.parametrize("n", [5, 20, 60])
def test_passes_stay_below_their_bound_where_each_frees_one_element(n):
    """With c_k = (k + 1)!, the mean of the lowest k thresholds lies below the last of them only."""
    c = np.cumprod(np.arange(1.0, n + 1))
    d, passes = solve_indentation(c, 1e-3, 2.0 * c[-1])
    assert d == pytest.approx(1.001, rel=1e-15)
    assert n <= passes <= 2 * n + 3
