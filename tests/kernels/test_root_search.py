"""The search for roots: against roots in closed form and scipy, and its limits."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import brentq

from elastomer_friction.kernels.compile.jit import kernel
from elastomer_friction.kernels.root_search import (
    MAX_EVALUATIONS,
    new_search,
    new_secant_search,
    next_guess,
    next_secant_guess,
    root_between,
)

LAST_STEP = 1e-8
ROOTS = st.floats(-0.99, 0.99)
INCREASING = {  # name: value, slope and second derivative at the distance from the root
    "linear": lambda x: (3.0 * x, 3.0, 0.0),
    "convex": lambda x: (math.expm1(5.0 * x), 5.0 * math.exp(5.0 * x), 25.0 * math.exp(5.0 * x)),
    "concave": lambda x: (-math.expm1(-5.0 * x), 5.0 * math.exp(-5.0 * x), -25 * math.exp(-5 * x)),
    "steep": lambda x: (math.tanh(30.0 * x), 30.0 / math.cosh(30.0 * x) ** 2, 0.0),
    "kinked": lambda x: (x, 1.0, 0.0) if x < 0.0 else (50.0 * x, 50.0, 0.0),
}
ANY_FUNCTION = pytest.mark.parametrize("name", INCREASING)
ANY_METHOD = pytest.mark.parametrize("halley", [0.0, 1.0], ids=["Newton", "Halley"])


def searched(function, start, low, high, tolerance=0.0, halley=0.0):
    """Search for a root with derivatives; return the last RootSearch and the places evaluated."""
    search, places = new_search(start, low, high, math.inf), []
    while not search.ended:
        value, slope, bend = function(search.x)
        places.append(search.x)
        search = next_guess(search, search.x, value, slope, halley * bend, tolerance, LAST_STEP)
        assert search.low <= search.x <= search.high
    return search, places


@ANY_METHOD
@ANY_FUNCTION
@given(root=ROOTS, start=ROOTS)
def test_a_simple_root_is_found(name, halley, root, start):
    def function(x):
        return INCREASING[name](x - root)

    search, places = searched(function, start, -1.0, 1.0, halley=halley)
    assert search.x == pytest.approx(root, abs=1e-12)
    assert search.evaluations == len(places) <= 60


@ANY_FUNCTION
@given(root=ROOTS)
def test_secants_find_the_root_that_scipy_finds(name, root):
    def value(x):
        return INCREASING[name](x - root)[0]

    assert root_between(value, -1.0, 1.0) == pytest.approx(
        brentq(value, -1.0, 1.0, xtol=1e-15, rtol=1e-15), abs=4e-15
    )


@given(root=st.floats(-1e6, 1e6), start=st.floats(-1e6, 1e6), slope=st.floats(0.0, 1e10))
def test_a_root_is_found_without_a_bracket(root, start, slope):
    """Steps of limited length lead to it, however wrong the estimate of the slope."""
    secants = new_secant_search(start, 0.5, slope)
    while not secants.search.ended:
        x = secants.search.x
        secants = next_secant_guess(secants, x, math.asinh(x - root), 1e-9, 1e-6)
    assert abs(x - root) < 1.01e-6
    assert secants.search.x == x or abs(secants.search.x - root) < 1e-6


@pytest.mark.parametrize("power", [3, 5, 7])
@given(root=ROOTS)
def test_a_flat_root_is_found_to_the_order_of_the_last_step(power, root):
    def function(x):
        return (x - root) ** power, power * (x - root) ** (power - 1), 0.0

    search, _ = searched(function, 0.5, -1.0, 1.0)
    assert abs(search.x - root) <= power * LAST_STEP


@pytest.mark.parametrize("end", [-1.0, 1.0])
def test_a_root_at_an_end_is_found(end):
    search, _ = searched(lambda x: (x - end, 1.0, 0.0), 0.1, -1.0, 1.0)
    assert search.x == pytest.approx(end, abs=1e-15)


@pytest.mark.parametrize(("value", "end"), [(1.0, -1.0), (-1.0, 1.0)])
def test_without_a_change_of_sign_the_search_approaches_an_end(value, end):
    search, _ = searched(lambda _: (value, 0.0, 0.0), 0.3, -1.0, 1.0)
    assert search.x == pytest.approx(end, abs=1e-15)
    assert root_between(lambda _: value, -1.0, 1.0) == pytest.approx(end, abs=1e-15)


def test_a_jump_through_zero_is_bracketed_to_the_last_bit():
    assert root_between(lambda x: -1.0 if x < 0.3 else 2.0, 0.0, 1.0) == pytest.approx(
        0.3, abs=2e-16
    )


def test_a_search_without_end_is_cut_off():
    search, places = searched(lambda _: (-1.0, 1e-3, 0.0), 0.0, -math.inf, math.inf)
    assert search.evaluations == len(places) == MAX_EVALUATIONS


def test_a_value_within_the_tolerance_ends_the_search_at_its_place():
    search, places = searched(INCREASING["convex"], 0.7, -1.0, 1.0, tolerance=1e-3)
    assert search.x == places[-1]
    assert 0.0 < abs(INCREASING["convex"](search.x)[0]) <= 1e-3


def test_a_value_that_is_not_a_number_ends_the_search():
    search, places = searched(lambda _: (math.nan, 1.0, 0.0), 0.3, -1.0, 1.0)
    assert (search.x, places) == (0.3, [0.3])
    with pytest.raises(ValueError, match="not a number at"):
        root_between(lambda _: math.nan, 1.0, 2.0)


def test_newton_needs_few_evaluations_near_a_simple_root():
    """Errors fall as their squares, or as their cubes by Halley's method."""
    _, newton = searched(INCREASING["convex"], 0.1, -1.0, 1.0)
    _, halley = searched(INCREASING["convex"], 0.1, -1.0, 1.0, halley=1.0)
    assert len(newton) <= 6
    assert len(halley) <= 4


@kernel
def compiled_root(start, low, high, root):
    """Return the root of expm1(5 (x - root)) by Newton's method."""
    search = new_search(start, low, high, np.inf)
    while not search.ended:
        value, slope = math.expm1(5.0 * (search.x - root)), 5.0 * math.exp(5.0 * (search.x - root))
        search = next_guess(search, search.x, value, slope, 0.0, 0.0, LAST_STEP)
    return search.x


def test_kernels_search_as_python_does():
    for root in (-0.9, 0.0, 0.31):
        search, _ = searched(lambda x, at=root: INCREASING["convex"](x - at), 0.4, -1.0, 1.0)
        assert compiled_root(0.4, -1.0, 1.0, root) == pytest.approx(search.x, abs=1e-15)
