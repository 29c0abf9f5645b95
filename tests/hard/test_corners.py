"""The corners of the parameter space on lines of any kind: H, Fbar, x, v2/v1, N, both schemes."""

import itertools

import numpy as np
import pytest

from elastomer_friction.kernels import SCHEMES, Case, Line, Quantities, run_case
from elastomer_friction.studies.stability.probe import Motion, probe, random_line, shapes
from tests.hard.bounds import assert_stable
from tests.sizes import PLAIN_PYTHON, size
from tests.support.sweeps import sweep

HURST = (0.0, 1.0)
RATIOS = (1e-3, 101.0)  # dv/v1 = -0.999, +100
CORNERS = list(
    itertools.product(
        (1e-6, 1e-2, 1.0, 1e4),  # Fbar: one asperity, a few, most of the line, full contact
        np.array([1e-4, 1.0, 1e6]) / np.pi,  # speed; x = pi vbar
        RATIOS,
    )
)
RANDOM = itertools.product(HURST, [(8, 1), (8, 4), (64, 1), (50, 3)])
EVERY_FIFTH = 5  # starts differ between lines, so that together they cover every corner
LINES = {
    **{f"H = {h:g}, N = {n}, m = {m}": random_line(h, n, m, 1, 0) for h, (n, m) in RANDOM},
    **{f"{n} samples": Line.from_samples(1.0 * np.arange(n), np.zeros(n), 1) for n in (1, 2, 3)},
    **shapes(size(48, 24)),
}
everywhere = pytest.mark.parametrize("name", LINES)
corners = sweep("every", EVERY_FIFTH, 1)
both_schemes = pytest.mark.parametrize("scheme", SCHEMES)


def some(name, every):
    """Return one in ``every`` corners for a line."""
    return CORNERS[list(LINES).index(name) % every :: every]


@corners
@both_schemes
@everywhere
def test_every_line_is_stable_at_every_corner(name, scheme, every):
    for corner in some(name, every):
        motion = Motion(LINES[name], *corner, scheme)
        assert_stable(motion, probe(motion, size(25, 12)))


@corners
@pytest.mark.parametrize("rigid", [True, False])
@both_schemes
@everywhere
def test_results_are_finite_and_within_the_slopes(name, scheme, rigid, every):
    """Friction is a mean of slopes (eq. 5), and the contact a share of the line."""
    line = LINES[name]
    steepest = np.abs(line.slope).max() * (1.0 + 1e-9)
    kept_steps = np.array([1, 2, 5, 20])
    for load, speed, ratio in some(name, every):
        case = Case(load, speed, (ratio,), (kept_steps,), scheme)
        actual = run_case(line, case, Quantities(indentation_rate=not rigid))
        assert np.all(np.abs([actual.mu_1, actual.mu_2[0]]) <= steepest)
        # These values are differences of two such means, added to a third.
        assert abs(actual.mu_1 + actual.jump[0]) <= 3.0 * steepest
        assert np.all(np.abs(actual.curves[0]) <= 3.0 * steepest)
        assert 0.0 < actual.contact_fraction <= 1.0 + 1e-12
        assert np.isfinite(actual.indentation)


@pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: too many samples")
@sweep("elements", 10**5, 10**6)
@pytest.mark.parametrize(("load", "scheme"), [(1e-6, "exponential"), (1e4, "implicit-euler")])
def test_a_very_long_line_is_stable(load, scheme, elements):
    motion = Motion(random_line(1.0, elements, 1, 1, 0), load, 10.0, 2.0, scheme)
    actual = probe(motion, 2)
    assert_stable(motion, actual)
    assert actual["passes"] <= 20
    assert actual["sweeps"] <= 40


@pytest.mark.parametrize("hurst", HURST)
@pytest.mark.parametrize("speed", [1e-11, 1e-4, 1.0, 1e3])
def test_full_contact_has_no_edge_and_relaxes_nothing(hurst, speed):
    """mu = vbar grad z^2 / Fbar at any speed: zeta = xi = 1."""
    line = random_line(hurst, 64, 2, 1, 0)
    case = Case(1e4, speed, (3.0,), (np.array([1, 10, 100]),), "exponential")
    actual = run_case(line, case, Quantities())
    # mu is of order v / Fbar, from pressures of order Fbar: its relative error is eps Fbar^2 / v.
    lost = 1e-14 * (1.0 + 1e4 / speed)
    expected = speed * np.mean(line.slope**2) / 1e4
    assert actual.contact_fraction == 1.0
    assert actual.mu_1 == pytest.approx(expected, rel=lost)
    assert actual.mu_2[0] == pytest.approx(3.0 * expected, rel=lost)
    assert actual.jump[0] == pytest.approx(2.0 * expected, rel=lost)
    assert np.ptp(actual.curves[0]) <= (lost + 1e-6) * abs(actual.mu_2[0])
