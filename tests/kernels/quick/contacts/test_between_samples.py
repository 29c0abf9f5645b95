"""Contacts followed between samples, against the model on fine samples and against a parabola."""

from functools import partial
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp
from scipy.optimize import brentq

from elastomer_friction.kernels import (
    SCHEMES,
    Line,
    amplitudes,
    draw_phases,
    quadrature,
    steady_sliding,
)
from elastomer_friction.kernels.body.patch_width import samples_per_contact
from elastomer_friction.kernels.lines.polynomials import (
    sample_derivatives,
    septic_coefficients,
    septic_height,
    septic_slope,
)
from elastomer_friction.kernels.quick.contacts.between_samples import slide_between
from elastomer_friction.kernels.quick.contacts.smooth_line import smooth_line
from elastomer_friction.kernels.quick.contacts.steady_friction import (
    FOLLOWED_SAMPLES,
    LineSet,
    SpeedConstants,
    follow_contacts,
    steady_friction,
)
from tests.references import parabola_forces
from tests.sizes import size


def one_load(line, speed, scheme, load, others=()):
    """Return steady sliding under one load, followed between the samples if possible."""
    constants = SpeedConstants.of(scheme, line.steps_per_spacing, speed, others)
    line_set = LineSet.of([line])
    sliding = steady_friction(line_set, constants, np.array([load]), line_set.smooth)
    if line_set.smooth:
        follow_contacts(sliding)
    names = ("followed", "d", "mu", "contact", "indentation", "updates", "full", "samples")
    return SimpleNamespace(
        **{name: getattr(sliding, name)[0, 0] for name in names},
        jumps=sliding.results.jumps[0, 0],
        effective_samples=sliding.effective_samples(0, 0),
    )


# Forces are integers, whose sums are exact. In the example a sum over patches equals half of the
# load, where rounding would otherwise decide the median.
FORCES = hnp.arrays(float, st.integers(1, 40), elements=st.integers(-9, 9))


@pytest.mark.parametrize(
    ("force", "samples"),
    [
        ([0.0, 0.0], 0.0),
        ([1.0, 2.0, 3.0], 3.0),  # full contact
        ([-1.0, 5.0, -1.0, 1.0, 1.0, 0.0], 1.0),  # the narrow patch carries more than half
        ([-1.0, 1.0, -1.0, 2.0, 2.0, 0.0], 2.0),
        ([1.0, 0.0, 0.0, 1.0], 2.0),  # one patch round the end of the line
    ],
)
def test_the_median_over_the_load(force, samples):
    assert samples_per_contact(np.array(force)) == samples


@example(np.array([-1.0, 0.75, 0.75, 0.75, 0.0, 0.75, 0.0, 0.75, 0.0, 0.75]), 26, 4)
@given(FORCES, st.integers(0, 39), st.integers(1, 4))
def test_samples_per_contact_scale_with_refinement_and_ignore_the_origin(force, shift, fold):
    finer = samples_per_contact(np.roll(np.repeat(force, fold), shift))
    assert finer == fold * samples_per_contact(force)


HURST, ELEMENTS, LOAD = 0.7, 500, 1e-3  # the light load of figures 5, 6 and grid6d


def line_of(steps, index=0, hurst=HURST, elements=ELEMENTS):
    """Return a random line with ``steps`` samples per spacing."""
    phases = draw_phases(np.random.default_rng(index), elements)
    return Line.self_affine(amplitudes(hurst, elements), phases, elements, steps)


def slide(line, x, load=LOAD):
    """Return steady sliding at x = v tau q_max under Fbar = load, with the jump to 1.2 v."""
    speed = x / np.pi
    return one_load(line, speed, "exponential", load * line.z.size, (1.2 * speed,))


@pytest.mark.parametrize("x", [1e5, 1e7])
def test_the_highest_peak_alone_is_a_parabola(x):
    actual, fine = slide(line_of(8), x), line_of(128)
    peak = int(np.argmin(fine.z))
    radius = 1.0 / sample_derivatives(fine.z, fine.slope, 1.0 / fine.steps_per_spacing)[0, peak]
    forces, load = partial(parabola_forces, radius=radius, speed=x / np.pi), LOAD * ELEMENTS
    d = brentq(lambda d: forces(d)[0] - load, 1e-9, 10.0)
    assert actual.samples < 1.0
    assert actual.mu == pytest.approx(forces(d)[1] / load, rel=0.01)


def fine(line, smooth, fold):
    """Return (heights over the deepest one, slopes, its height) on a ``fold`` times finer grid."""
    t = 1.0 - np.arange(fold) / fold
    parts = [
        septic_coefficients(line.z, line.slope, smooth.bend, smooth.spacing, j)
        for j in range(line.z.size)
    ]
    z = np.concatenate([septic_height(c, t) for c in parts])
    slope = np.concatenate([-septic_slope(c, t) / smooth.spacing for c in parts])
    return z - z.min(), slope, z.min()


@settings(max_examples=size(60, 12))
@example(0.3, 10.0**0.96875, 10.0**2.0625, 5.0, 52)  # an exact zero
@given(
    st.sampled_from([0.0, 0.3, 1.0]),
    st.floats(-6.0, 3.0).map(lambda power: 10.0**power),
    st.floats(-0.5, 3.0).map(lambda power: 10.0**power),
    st.sampled_from([1.2, 0.5, 5.0]),
    st.integers(0, 99),
)
def test_contacts_are_those_of_the_model_on_fine_samples_of_the_line(hurst, load, x, ratio, index):
    """The plain model uses no patches, bounds or events. This holds for any load and speed."""
    line, v = line_of(4, index, hurst, 30), x / np.pi
    smooth = smooth_line(line.z, line.slope, 0.25)
    guess = np.array([steady_sliding(SCHEMES["exponential"](0.25 / v), line.z, 120.0 * load)[0].d])
    table, jumps, rates = slide_between(
        smooth, v, np.array([ratio * v]), np.array([120.0 * load]), guess
    )
    d, mu, length, median, events = table[0]
    fold = int(np.clip(64.0 / median, 16, size(4096, 1024)))
    z, slope, lowest = fine(line, smooth, fold)
    total, law = load * z.size, SCHEMES["exponential"](0.25 / (fold * v))
    w, near = steady_sliding(law, z, total)[0]
    one, _, share = quadrature(z, slope, w, near, v, v, total)
    other, rate, _ = quadrature(z, slope, w, near, v, ratio * v, total)
    patch = samples_per_contact(near - (z - w))
    close = 0.02 + 60.0 / patch**2  # relative error of the quadrature on these samples
    assert events > 0.0
    assert d == pytest.approx(near + lowest, abs=1e-3 * (near + 1e-3))
    assert mu == pytest.approx(one, rel=close)
    assert jumps[0, 0] == pytest.approx(other - one, rel=3.0 * close, abs=1e-9)
    assert rates[0, 0] == pytest.approx(rate, abs=3.0 * close * abs(ratio - 1.0) * v * one)
    assert length == pytest.approx(30.0 * share, rel=0.05 + 20.0 / patch**2)


def test_a_smooth_line_is_the_line():
    fold, coarse = 8, line_of(4)
    actual, _, lowest = fine(coarse, smooth_line(coarse.z, coarse.slope, 0.25), fold)
    z = line_of(4 * fold)
    order = int(np.argmin(np.abs(z.z + z.datum - coarse.z[0] - coarse.datum)))
    expected = np.roll(z.z, -order) + z.datum - coarse.datum
    np.testing.assert_allclose(actual + lowest, expected, atol=2e-8)


# 12 of 12 000 such comparisons differ by more: a patch appears, or another patch is the median.
@settings(max_examples=size(40, 10), derandomize=True)
@given(st.floats(-3.0, 0.5), st.floats(-1.0, 3.0), st.floats(0.0, 1.0))
def test_the_number_of_samples_does_not_matter(power, fast, hurst):
    """At m = 12 every third sample is used, at m = 13 every sample."""
    load, x = 10.0**power, 10.0**fast
    few, every_third, every = (slide(line_of(m, 2, hurst, 100), x, load) for m in (4, 12, 13))
    for m, actual in ((12, every_third), (13, every)):
        assert actual.followed or actual.full
        if few.followed and actual.followed:
            assert few.mu == pytest.approx(actual.mu, rel=1e-5)
            assert few.jumps[0] == pytest.approx(actual.jumps[0], rel=1e-4)
            assert few.contact == pytest.approx(actual.contact, rel=2e-3)
            assert few.samples == pytest.approx(4 / m * actual.samples, rel=1e-2)


def test_friction_under_the_lightest_loads_is_a_slope_of_the_line():
    """Near the deepest point, where a turn ends, rounding decides where an element leaves."""
    rng = np.random.default_rng(1)
    for index in range(size(100, 8)):
        line, speed = line_of(4, index, rng.uniform(), 30), 10.0 ** rng.uniform(0.0, 7.0)
        for load in 10.0 ** rng.uniform(-11.0, -3.0, 4):
            actual = one_load(line, speed, "exponential", load * line.z.size, (1.2 * speed,))
            assert 0.0 < actual.mu < 1.1 * np.abs(line.slope).max()
            assert abs(actual.jumps[0]) < actual.mu


def test_depths_at_rounding_level_use_the_samples():
    line = line_of(4)
    actual = one_load(line, 1.0, "exponential", 1e-60)
    assert not actual.followed
    assert actual.mu > 0.0


def slide_with_jumps(speed, load, steps=8, scheme="exponential"):
    """Return a random line and steady sliding on it, at vbar and Fbar, with three jumps."""
    line, others = line_of(steps, 4, elements=200), (1.2 * speed, 0.8 * speed, speed)
    return line, one_load(line, speed, scheme, load * line.z.size, others)


def test_full_contact_is_computed_from_the_samples():
    line, actual = slide_with_jumps(0.1, 10.0)
    assert actual.full
    assert not actual.followed
    assert actual.samples == actual.effective_samples == line.z.size


@pytest.mark.parametrize(
    ("speed", "load", "least", "most"), [(100.0, 1e-3, 0.0, 0.01), (0.1, 1.0, 0.5, 1.0)]
)
def test_partial_contacts_are_followed_between_the_samples(speed, load, least, most):
    line, actual = slide_with_jumps(speed, load)
    assert actual.followed
    assert actual.effective_samples == max(actual.samples, FOLLOWED_SAMPLES)
    assert actual.updates > line.z.size
    assert least < actual.contact < most


def test_lines_that_are_not_band_limited_are_never_followed():
    z = np.abs(np.linspace(-1.0, 1.0, 64, endpoint=False))
    slope = np.sign(np.linspace(-1.0, 1.0, 64, endpoint=False)) / 32.0
    line = Line.from_samples(z, slope, 8)
    assert not line.band_limited
    assert not one_load(line, 10.0, "exponential", 1e-3 * z.size).followed
