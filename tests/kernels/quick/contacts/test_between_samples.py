"""Narrow contacts, between samples: the model on fine samples, the parabola's closed form."""

from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from elastomer_friction.kernels import (
    SCHEMES,
    Line,
    amplitudes,
    draw_phases,
    quadrature,
    rms_slope,
    steady_sliding,
)
from elastomer_friction.kernels.lines.polynomials import curvatures, height, quintic, steepness
from elastomer_friction.kernels.lines.self_affine import mode_numbers
from elastomer_friction.kernels.quick.contacts.between_samples import NARROW, slide_between
from elastomer_friction.kernels.quick.contacts.smooth_line import first_zero, smooth_line
from elastomer_friction.kernels.quick.contacts.steady_friction import (
    AtSpeed,
    Grounds,
    follow_narrow,
    steady_friction,
)
from elastomer_friction.kernels.scene.samples import samples_per_contact
from tests.sizes import size


def one_load(line, speed, scheme, load, others=()):
    """Return what is found under a load."""
    pace = AtSpeed.of(scheme, line.steps_per_spacing, speed, others)
    found = steady_friction(Grounds.of([line]), pace, np.array([load]))
    follow_narrow(found)
    names = ("followed", "d", "mu", "contact", "indentation", "updates", "full", "samples")
    return SimpleNamespace(
        **{name: getattr(found, name)[0, 0] for name in names},
        jumps=found.found.jumps[0, 0],
        state=found.state(0, 0),
        samples_seen=found.samples_seen(0, 0),
    )


FORCES = hnp.arrays(float, st.integers(1, 40), elements=st.floats(-1.0, 1.0))


@pytest.mark.parametrize(
    ("force", "samples"),
    [
        ([0.0, 0.0], 0.0),
        ([1.0, 2.0, 3.0], 3.0),  # full contact
        ([-1.0, 5.0, -1.0, 1.0, 1.0, 0.0], 1.0),  # the narrow one carries more than half
        ([-1.0, 1.0, -1.0, 2.0, 2.0, 0.0], 2.0),
        ([1.0, 0.0, 0.0, 1.0], 2.0),  # one patch round the end of the line
    ],
)
def test_the_median_over_the_load(force, samples):
    assert samples_per_contact(np.array(force)) == samples


@given(FORCES, st.integers(0, 39))
def test_where_the_line_begins_plays_no_part(force, shift):
    assert samples_per_contact(np.roll(force, shift)) == samples_per_contact(force)


@given(FORCES, st.integers(2, 4))
def test_finer_samples_are_so_many_times_as_many(force, fold):
    finer = samples_per_contact(np.repeat(force, fold))
    assert finer == fold * samples_per_contact(force)


HURST, ELEMENTS, LOAD = 0.7, 500, 1e-3  # the light load of figures 5, 6 and grid6d


def line_of(steps, index=0, hurst=HURST, elements=ELEMENTS, phases=None):
    """Return a random line at so many samples per spacing."""
    phases = draw_phases(np.random.default_rng(index), elements) if phases is None else phases
    return Line.self_affine(amplitudes(hurst, elements), phases, elements, steps)


def slide(line, x, load=LOAD):
    """Return steady sliding at x = v tau q_max under Fbar = load, and the jump for 1.2 v."""
    speed = x / np.pi
    return one_load(line, speed, "exponential", load * line.z.size, (1.2 * speed,))


def mean_friction(steps, x, lines=4):
    """Return mu_1 over grad z, a mean of lines, and the jump for v2 = 1.2 v1 over grad z."""
    slope = rms_slope(amplitudes(HURST, ELEMENTS), ELEMENTS)
    found = [slide(line_of(steps, index), x) for index in range(lines)]
    jumps = [one.jumps[0] for one in found]
    return np.mean([one.mu for one in found]) / slope, np.mean(jumps) / slope


@pytest.mark.parametrize("x", [10.0, 100.0, 1e3, 1e4, 1e5])
def test_four_samples_per_spacing_are_as_good_as_many(x):
    """The line of the issue: with m = 4 mu_1 was 0.05 grad z from x = 1e4 on, whatever x."""
    fine = mean_friction(32, x)
    np.testing.assert_allclose(mean_friction(4, x), fine, rtol=0.01)


def test_friction_of_a_single_peak_falls_with_the_root_of_the_speed():
    at = [mean_friction(8, x)[0] for x in (1e4, 1e5, 1e6, 1e7)]
    np.testing.assert_allclose(np.diff(np.log10(at)), -0.5, atol=0.01)


def parabola_friction(radius, load, speed):
    """Return mu of a parabola z = s^2/(2 R), on its own: F_N = 4 G int p ds, eqs. 3 to 5.

    Contact from v - sqrt(v^2 + 2 R d) to sqrt(2 R d), p = d - s^2/(2 R) + v s/R; all in the units
    of the kernels. load : integral of p over s.
    """
    low, high = 0.0, load * radius
    for _ in range(200):
        d = 0.5 * (low + high)
        a, b = speed - np.sqrt(speed**2 + 2.0 * radius * d), np.sqrt(2.0 * radius * d)
        normal = np.poly1d([-1.0 / (6.0 * radius), speed / (2.0 * radius), d, 0.0])
        low, high = (d, high) if normal(b) - normal(a) < load else (low, d)
    pull = np.poly1d(
        [-1.0 / (8.0 * radius**2), speed / (3.0 * radius**2), d / (2.0 * radius), 0, 0]
    )
    return (pull(b) - pull(a)) / load


@pytest.mark.parametrize("x", [1e5, 1e7])
def test_the_highest_peak_alone_is_a_parabola(x):
    found, fine = slide(line_of(8), x), line_of(128)
    peak = int(np.argmin(fine.z))
    bend = curvatures(fine.z, fine.slope, 1.0 / fine.steps_per_spacing)[peak]
    closed = parabola_friction(1.0 / bend, LOAD * ELEMENTS, x / np.pi)
    assert found.samples < 1.0
    assert found.mu == pytest.approx(closed, rel=0.01)


@settings(max_examples=size(40, 10))
@given(
    st.floats(0.0, 1.0),
    st.floats(-4.0, 1.0).map(lambda power: 10.0**power),
    st.floats(-3.0, 7.0).map(lambda power: 10.0**power),
    st.sampled_from([1, 2, 4]),
    st.sampled_from(sorted(SCHEMES)),
)
@example(0.0, 10.0**0.75, 10.0**0.75, 1, "implicit-euler")  # edges of contacts overlap
def test_steady_friction_is_positive_and_within_the_slopes(hurst, load, x, steps, scheme):
    line = line_of(steps, 3, hurst, 60)
    found = one_load(line, x / np.pi, scheme, load * line.z.size)
    steepest = np.abs(line_of(64, 3, hurst, 60).slope).max()
    assert 0.0 < found.mu <= 1.001 * steepest
    assert 0.0 < found.contact <= 1.0
    assert found.samples > 0.0


def fine(line, smooth, fold):
    """Return heights over the deepest sample, slopes and that height, at so many times as many."""
    t = 1.0 - np.arange(fold) / fold
    parts = [
        quintic(line.z, line.slope, smooth.curvature, smooth.spacing, j) for j in range(line.z.size)
    ]
    z = np.concatenate([height(c, t) for c in parts])
    slope = np.concatenate([-steepness(c, t) / smooth.spacing for c in parts])
    return z - z.min(), slope, z.min()


@settings(max_examples=size(60, 12))
@example(0.3, 10.0**0.96875, 10.0**2.0625, 5.0, 52)  # a zero that is exact
@given(
    st.sampled_from([0.0, 0.3, 1.0]),
    st.floats(-6.0, 3.0).map(lambda power: 10.0**power),
    st.floats(-0.5, 3.0).map(lambda power: 10.0**power),
    st.sampled_from([1.2, 0.5, 5.0]),
    st.integers(0, 99),
)
def test_contacts_are_those_of_the_model_on_fine_samples_of_the_line(hurst, load, x, ratio, index):
    """The plain model, which knows nothing of patches, bounds or events, at any load and speed."""
    line, v = line_of(4, index, hurst, 30), x / np.pi
    smooth = smooth_line(line.z, line.slope, 0.25)
    guess = np.array([steady_sliding(SCHEMES["exponential"](0.25 / v), line.z, 120.0 * load)[0].d])
    table, jumps = slide_between(smooth, v, np.array([ratio * v]), np.array([120.0 * load]), guess)
    d, mu, length, median, events = table[0]
    fold = int(np.clip(64.0 / median, 16, size(4096, 1024)))
    z, slope, lowest = fine(line, smooth, fold)
    total, law = load * z.size, SCHEMES["exponential"](0.25 / (fold * v))
    w, near = steady_sliding(law, z, total)[0]
    one, _, share = quadrature(z, slope, w, near, v, v, total)
    other, _, _ = quadrature(z, slope, w, near, v, ratio * v, total)
    patch = samples_per_contact(near - (z - w))
    close = 0.02 + 60.0 / patch**2  # of slopes: what quadrature of so many samples keeps
    assert events > 0.0
    assert d == pytest.approx(near + lowest, abs=1e-3 * (near + 1e-3))
    assert mu == pytest.approx(one, rel=close)
    assert jumps[0, 0] == pytest.approx(other - one, rel=3.0 * close, abs=1e-9)
    assert length == pytest.approx(30.0 * share, rel=0.05 + 20.0 / patch**2)


@settings(max_examples=size(200, 40))
@given(
    st.lists(st.floats(-1.0, 1.0), min_size=6, max_size=6),
    st.floats(-1.0, 0.0),
    st.floats(1e-3, 10.0),
)
def test_the_first_zero_is_the_first(coefficients, u, a):
    c = (u + abs(coefficients[0]) + 0.01, *coefficients[1:])
    t = np.linspace(0.0, 1.0, 2001)
    f = height(c, t) - u * np.exp(-a * t)
    zero = first_zero(c, u, a, 0.0, 1.0, True)
    below = np.flatnonzero(f <= 0.0)
    if f[-1] < 0.0:  # sure to be found: then all before it is positive, or a second zero as well
        assert 0.0 < zero <= 1.0
        assert abs(height(c, zero) - u * np.exp(-a * zero)) < 1e-9
    elif below.size == 0:
        assert zero > 1.0 or abs(height(c, zero) - u * np.exp(-a * zero)) < 1e-5


def test_bounds_hold_between_samples_and_are_close():
    line = line_of(4)
    smooth = smooth_line(line.z, line.slope, 0.25)
    z, slope, lowest = fine(line, smooth, 16)
    z, slope = (z + lowest).reshape(-1, 16), slope.reshape(-1, 16)
    bounds = [
        (z.min(axis=1), smooth.low),
        (smooth.high, z.max(axis=1)),
        (slope.min(axis=1), smooth.flat),
    ]
    for above, below in bounds:
        assert (below <= above + 1e-12).all()
        assert np.quantile(above - below, 0.9) < 0.05 * np.ptp(above)
    np.testing.assert_allclose(smooth.area, 0.25 * z.mean(axis=1), atol=0.02 * np.ptp(z))


def test_a_smooth_line_is_the_line():
    fold, coarse = 8, line_of(4)
    found, _, lowest = fine(coarse, smooth_line(coarse.z, coarse.slope, 0.25), fold)
    z = line_of(4 * fold)
    order = int(np.argmin(np.abs(z.z + z.datum - coarse.z[0] - coarse.datum)))
    expected = np.roll(z.z, -order) + z.datum - coarse.datum
    np.testing.assert_allclose(found + lowest, expected, atol=2e-6)


@settings(max_examples=size(40, 10))
@given(st.floats(-3.0, 0.5), st.floats(-1.0, 3.0), st.floats(0.0, 1.0))
def test_how_many_samples_there_are_plays_no_part(power, fast, hurst):
    """Steady friction and jump of m = 4 and m = 16, in contacts that are narrow at both."""
    load, x = 10.0**power, 10.0**fast
    found = [slide(line_of(m, 2, hurst, 100), x, load) for m in (4, 16)]
    if all(one.followed for one in found):
        assert found[0].mu == pytest.approx(found[1].mu, rel=3e-4)
        assert found[0].jumps[0] == pytest.approx(found[1].jumps[0], rel=2e-3)
        assert found[0].contact == pytest.approx(found[1].contact, rel=1e-3)
        assert found[0].samples == pytest.approx(0.25 * found[1].samples, rel=1e-2)


def test_depths_that_are_rounding_are_left_to_the_samples():
    line = line_of(4)
    found = one_load(line, 1.0, "exponential", 1e-60)
    assert not found.followed
    assert found.mu > 0.0


def test_wide_contacts_are_left_as_they_are():
    line = line_of(4)
    found = slide(line, 1.0, load=0.5)
    assert found.samples >= NARROW
    assert not found.followed


def test_lines_that_are_not_smooth_are_left_as_they_are():
    line = line_of(4)._replace(band_limited=False)
    found = slide(line, 1e4)
    assert found.samples == 1.0
    assert not found.followed
    assert np.isfinite([found.mu, found.jumps[0]]).all()


def test_where_the_samples_fall_plays_no_part():
    """A shift by half a sample is a smaller part of a contact than a hundredth."""
    phases = draw_phases(np.random.default_rng(1), ELEMENTS)
    shifted = phases + np.pi * mode_numbers(ELEMENTS) / ELEMENTS / 4
    one, other = (slide(line_of(4, phases=p), 1e3).mu for p in (phases, shifted))
    assert one == pytest.approx(other, rel=2e-3)


def slide_with_jumps(speed, load, steps=8, scheme="exponential"):
    """Return a random line and steady sliding on it, at vbar and Fbar, with three jumps."""
    line, others = line_of(steps, 4, elements=200), (1.2 * speed, 0.8 * speed, speed)
    return line, one_load(line, speed, scheme, load * line.z.size, others)


def test_wide_contacts_are_seen_on_the_line_itself():
    _, found = slide_with_jumps(0.1, 3.0)
    assert found.samples == found.samples_seen >= NARROW
    assert not found.followed


def test_narrow_contacts_are_seen_between_the_samples():
    line, found = slide_with_jumps(100.0, 1e-3)
    assert found.followed
    assert found.samples < found.samples_seen == NARROW
    assert found.updates > line.z.size
    assert 0.0 < found.contact < 0.01


@pytest.mark.parametrize(("speed", "load"), [(0.1, 3.0), (100.0, 1e-3)])
def test_jump_has_the_sign_of_the_step_and_vanishes_with_it(speed, load):
    _, found = slide_with_jumps(speed, load)
    faster, slower, same = found.jumps
    assert faster > 0.0 > slower
    assert same == pytest.approx(0.0, abs=1e-12)


def test_few_samples_agree_with_many():
    few, many = slide_with_jumps(30.0, 1e-2, 4)[1], slide_with_jumps(30.0, 1e-2, 64)[1]
    assert few.mu == pytest.approx(many.mu, rel=0.02)
    assert few.indentation == pytest.approx(many.indentation, rel=0.02)
    assert few.contact == pytest.approx(many.contact, rel=0.05)


def test_rigid_shapes_of_samples_alone_are_never_followed():
    z = np.abs(np.linspace(-1.0, 1.0, 64, endpoint=False))
    slope = np.sign(np.linspace(-1.0, 1.0, 64, endpoint=False)) / 32.0
    line = Line.from_samples(z, slope, 8)
    assert not line.band_limited
    assert not one_load(line, 10.0, "exponential", 1e-3 * z.size).followed
