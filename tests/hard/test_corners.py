"""The corners of the parameter space: H, Fbar, x, v2/v1, N, both schemes, residual by residual."""

import itertools

import numpy as np
import pytest

from kernels import SCHEMES, Case, Line, Quantities, amplitudes, draw_phases, run_case
from studies.stability.probe import Motion, probe
from tests.hard.bounds import assert_stable
from tests.sizes import PLAIN_PYTHON, size

HURST = (0.0, 1.0)
LOADS = (1e-6, 1e-2, 1e4)  # one asperity, a few, full contact
X = (1e-4, 1.0, 1e6)  # x = pi vbar
RATIOS = (1e-3, 101.0)  # dv/v1 = -0.999, +100
STEPS = size(60, 25)


def random_line(elements, hurst, m, seed=1):
    """Return a random line."""
    phases = draw_phases(np.random.default_rng(seed), elements)
    return Line.self_affine(amplitudes(hurst, elements), phases, elements, m)


def corners():
    """Return all corners of load, speed and ratio."""
    return itertools.product(LOADS, X, RATIOS)


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("hurst", HURST)
@pytest.mark.parametrize(("elements", "m"), [(8, 1), (8, 4), (64, 1), (50, 3)])
def test_every_corner_is_stable(scheme, hurst, elements, m):
    line = random_line(elements, hurst, m)
    for load, x, ratio in corners():
        motion = Motion(line, load, x / np.pi, ratio, scheme)
        assert_stable(motion, probe(motion, STEPS))


@pytest.mark.parametrize("rigid", [True, False])
@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("hurst", HURST)
def test_every_corner_gives_finite_results_within_the_slopes(scheme, hurst, rigid):
    """Friction is a mean of slopes (eq. 5), the contact a share of the line."""
    line = random_line(16, hurst, 2)
    steepest = np.abs(line.slope).max() * (1.0 + 1e-9)
    kept_steps = np.array([1, 2, 5, 20])
    for load, x, ratio in corners():
        case = Case(load, x / np.pi, (ratio,), (kept_steps,), scheme)
        found = run_case(line, case, Quantities(indentation_rate=not rigid))
        assert np.all(np.abs([found.mu_1, found.mu_2[0]]) <= steepest)
        # Differences of two such means, added to a third.
        assert abs(found.mu_1 + found.jump[0]) <= 3.0 * steepest
        assert np.all(np.abs(found.curves[0]) <= 3.0 * steepest)
        assert 0.0 < found.contact_fraction <= 1.0 + 1e-12
        assert np.isfinite(found.indentation)


@pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: too many samples")
@pytest.mark.parametrize(("load", "scheme"), [(1e-6, "exponential"), (1e4, "implicit-euler")])
def test_a_line_of_a_million_elements_is_stable(load, scheme):
    motion = Motion(random_line(10**6, 1.0, 1), load, 10.0, 2.0, scheme)
    found = probe(motion, 2)
    assert_stable(motion, found)
    assert found["passes"] <= 20
    assert found["sweeps"] <= 40


@pytest.mark.parametrize("load", [1e-6, 1e-3])
@pytest.mark.parametrize("hurst", HURST)
def test_the_lightest_load_rests_on_one_asperity(hurst, load):
    """There d is small against the heights, and the touching elements are neighbours."""
    line = random_line(64, hurst, 4)
    motion = Motion(line, load, 1e-4, 1.0, "exponential")
    (w, d), _ = motion.steady(SCHEMES["exponential"](1e3))
    touching = np.flatnonzero(line.z - w < d)
    assert touching.size == touching[-1] - touching[0] + 1
    assert touching.size <= 8


@pytest.mark.parametrize("hurst", HURST)
@pytest.mark.parametrize("speed", [1e-11, 1e-4, 1.0, 1e3])
def test_full_contact_has_no_edge_and_relaxes_nothing(hurst, speed):
    """mu = vbar grad z^2 / Fbar at any speed: zeta = xi = 1."""
    line = random_line(64, hurst, 2)
    kept_steps = np.array([1, 10, 100])
    case = Case(1e4, speed, (3.0,), (kept_steps,), "exponential")
    found = run_case(line, case, Quantities())
    # mu is of order v / Fbar, summed from pressures of order Fbar: eps Fbar^2 / v is lost.
    lost = 1e-14 * (1.0 + 1e4 / speed)
    expected = speed * np.mean(line.slope**2) / 1e4
    assert found.contact_fraction == 1.0
    assert found.mu_1 == pytest.approx(expected, rel=lost)
    assert found.mu_2[0] == pytest.approx(3.0 * expected, rel=lost)
    assert found.jump[0] == pytest.approx(2.0 * expected, rel=lost)
    assert np.ptp(found.curves[0]) <= (lost + 1e-6) * abs(found.mu_2[0])
