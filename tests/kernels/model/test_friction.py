"""Friction of a state: its jump on a parabola, its elastic part at low speeds.

The order of steady friction is tested in tests/hard/test_convergence.py. All friction is tested
against exact arithmetic in tests/independent/test_exact.py.

On the parabola contact is 4.8 spacings wide, v tau = 1.5, and memory decays by e^-32 in a period.
"""

from functools import partial

import numpy as np
import pytest

from elastomer_friction.kernels import SCHEMES, quadrature, steady_sliding
from elastomer_friction.kernels.model.friction import elastic_correction
from tests.convergence import observed_order
from tests.lines import parabola, random_line
from tests.references import parabola_forces, parabola_jump, slow_sliding
from tests.sizes import size

ELEMENTS, RADIUS, SPEED, DEPTH = 48, 1.0, 1.5, 4.5
REFINEMENTS = np.array([16, 32, 64, 128, 256])[: size(5, 4)]
FINEST = REFINEMENTS[-1]
OFFSETS = (0.0, 0.17, 0.31, 0.5, 0.73, 0.9)


def steady_state(z, load, speed, m):
    """Return (w, d) of steady sliding. load : Fbar."""
    return steady_sliding(SCHEMES["exponential"](1.0 / (m * speed)), z, load * z.size)[0]


def jump(z, slope, load, speed, m, ratio):
    """Return mu(t0+) - mu_1."""
    w, d = steady_state(z, load, speed, m)
    mu = [quadrature(z, slope, w, d, speed, v, load * z.size)[0] for v in (speed, ratio * speed)]
    return mu[1] - mu[0]


def slow(z, slope, load, speed, m):
    """Return mu of steady sliding with its elastic part corrected. load : Fbar."""
    w, d = steady_state(z, load, speed, m)
    mu, rate, _ = quadrature(z, slope, w, d, speed, speed, load * z.size)
    return mu + elastic_correction(z, slope, w, d, speed, rate, m) / (load * z.size)


def parabola_errors(speed, estimate, exact):
    """Return relative errors of an estimate on the parabola, shape (refinements, offsets)."""
    load = parabola_forces(DEPTH, RADIUS, speed)[0] / ELEMENTS
    lines = {(m, o): parabola(ELEMENTS, m, o, RADIUS) for m in REFINEMENTS for o in OFFSETS}
    actual = [estimate(*line, load, speed, m) / exact - 1.0 for (m, _), line in lines.items()]
    return np.array(actual).reshape(len(REFINEMENTS), len(OFFSETS))


# Twice the measured errors are allowed. After a slow-down they scatter with the offset.
@pytest.mark.parametrize(
    ("ratio", "order", "allowed"),
    [(1.2, 1.9, 0.8 / FINEST**2), (2.0, 1.9, 0.8 / FINEST**2), (0.9, 1.8, 1.2 / FINEST)],
)
def test_jump_of_the_parabola_is_second_order(ratio, order, allowed):
    exact = parabola_jump(DEPTH, RADIUS, SPEED, ratio)
    errors = parabola_errors(SPEED, partial(jump, ratio=ratio), exact)
    assert observed_order(REFINEMENTS, errors) > order
    assert np.abs(errors[-1]).max() < allowed


@pytest.mark.parametrize("load", [1e-3, 0.05, 1.0])
@pytest.mark.parametrize("speed", [1e-3, 1e-6, 1e-11])
def test_corrected_friction_keeps_its_accuracy_at_any_low_speed(load, speed):
    """The error is that of the contact's extent; that of a sum over samples would grow as 1 / v."""
    m = 16
    z, slope = random_line(60, 1.0, m, seed=2)
    fine = random_line(60, 1.0, 64 * m, seed=2)
    expected = speed * slow_sliding(*fine, load)
    # The edges of a contact are known to a fraction of a sample; the widest has 200 samples.
    assert slow(z, slope, load, speed, m) == pytest.approx(expected, rel=0.05)


def test_an_edge_that_is_not_resolved_is_not_corrected():
    """mu is the slope of the only touching sample, which disagrees with the heights around it."""
    z, slope = np.array([9.0, 9.0, 0.0, 9.0, 9.0]), np.array([0.0, -500.0, -500.0, 0.0, 0.0])
    w, d = np.zeros(5), 1e-6
    mu, rate, _ = quadrature(z, slope, w, d, 0.01, 0.01, 1e-6)
    assert mu == pytest.approx(-500.0, rel=1e-15)
    assert elastic_correction(z, slope, w, d, 0.01, rate, 1) == 0.0
