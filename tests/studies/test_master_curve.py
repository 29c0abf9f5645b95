"""The study of the master curve: the rule of its shifts on known laws, and its physics."""

import numpy as np
import pytest

from elastomer_friction.studies.master_curve.collapse import (
    ALONG_BOTH,
    ALONG_SPEED,
    MIN_POINTS,
    UNSHIFTED,
    Curve,
    collapse,
    remaining,
    resolved,
    thermal,
)
from elastomer_friction.workflow.study.read import read_study

pytestmark = pytest.mark.exhaustive  # its scenes compile kernels of their own

SHORT = ("grid.spacing=[2e-5, 1e-5]", "grid.normal_force={geomspace=[1e-3, 3e-2, 4]}")
STUDY = ("master_curve", *SHORT)
X = np.linspace(-6.0, 3.0, 19)


def bell(x, along=0.0, lift=0.0, noise=0.0):
    """Return a curve that these shifts bring onto that without any."""
    y = -1.0 - 0.1 * (x + along) ** 2 - lift
    rng = np.random.default_rng(1)
    return Curve(x, y + noise * rng.standard_normal(x.size), np.full(x.size, noise))


def test_known_shifts_come_back():
    curves = [bell(X), bell(X, along=1.37), bell(X, along=-0.82, lift=0.4)]
    actual = collapse(curves, curves[0], ALONG_BOTH)
    assert [shift.along_speed for shift in actual.shifts] == pytest.approx([0.0, 1.37, -0.82])
    assert [s.along_friction for s in actual.shifts] == pytest.approx([0.0, 0.0, 0.4], abs=0.01)
    assert actual.rms < 0.01
    assert actual.left_out == 3 + 2  # beyond the ends of the reference
    assert collapse(curves, curves[0], ALONG_SPEED).rms > 10.0 * actual.rms
    assert collapse(curves, curves[0], UNSHIFTED).rms > 0.3


def test_error_of_a_shift_is_its_scatter():
    shifts = []
    for seed in range(40):
        noisy = bell(X, along=0.7)
        scatter = 0.02 * np.random.default_rng(seed).standard_normal(X.size)
        shifts += collapse([noisy._replace(y=noisy.y + scatter)], bell(X), ALONG_SPEED).shifts
    scatter = np.std([shift.along_speed for shift in shifts])
    assert np.mean([shift.speed_error for shift in shifts]) == pytest.approx(scatter, rel=0.5)


def test_a_curve_without_overlap_is_left_out():
    far = bell(X[:MIN_POINTS] + 40.0)
    actual = collapse([far], bell(X), ALONG_BOTH)
    assert actual.left_out == MIN_POINTS
    assert np.isnan(actual.rms)


@pytest.fixture(scope="module")
def found(result):
    """Return how the curves of the rubber collapse, at given forces and indentations."""
    return remaining(resolved(result[""])[0])


@pytest.mark.parametrize("pressed", ["force", "indentation"])
def test_shifts_bring_the_curves_together(found, pressed):
    modes = found[pressed].collapses
    assert modes[ALONG_BOTH].rms < modes[ALONG_SPEED].rms < 0.6 * modes[UNSHIFTED].rms
    assert modes[ALONG_BOTH].rms < 0.1


def test_indentation_is_the_robust_parameter(found):
    """Popov et al. (2018), arXiv:1604.03407: contacts follow the indentation, not the force."""
    for mode in (ALONG_SPEED, ALONG_BOTH):
        assert found["indentation"].collapses[mode].rms < 0.8 * found["force"].collapses[mode].rms


def test_temperature_shifts_as_wlf_says(found):
    material = read_study("master_curve").material
    temperature, shift, _ = thermal(found["indentation"])
    assert temperature.size >= 4
    known = [np.log10(material.shift(t)) for t in temperature]
    np.testing.assert_allclose(shift, known, atol=0.15)
