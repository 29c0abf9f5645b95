"""Narrow contacts on refined lines: the parabola's closed form, finer lines, never a wrong sign."""

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
from elastomer_friction.kernels.lines.self_affine import mode_numbers
from elastomer_friction.kernels.quick.contacts.fine_line import curvatures, interpolate
from elastomer_friction.kernels.quick.contacts.refined import (
    FINE,
    NARROW,
    curvatures_of,
    finer,
    refined,
)
from elastomer_friction.kernels.quick.contacts.samples import samples_per_contact
from elastomer_friction.kernels.quick.contacts.steady_friction import (
    AtSpeed,
    Grounds,
    refine,
    steady_friction,
)
from elastomer_friction.kernels.quick.steady.stack import stack_of
from tests.sizes import size


def one_load(line, speed, scheme, load, others=()):
    """Return what is found under a load; ``seen`` is None where the samples of the line will do."""
    pace = AtSpeed.of(scheme, line.steps_per_spacing, speed, others)
    found = steady_friction(Grounds.of([line]), pace, np.array([load]))
    refine(found, 0, 0)
    names = ("d", "mu", "contact", "indentation", "updates", "full", "samples")
    return SimpleNamespace(
        **{name: getattr(found, name)[0, 0] for name in names},
        jumps=found.found.jumps[0, 0],
        state=found.state(0, 0),
        seen=found.seen.get((0, 0)),
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


@settings(max_examples=size(40, 5))
@given(st.floats(-4.0, 1.0), st.floats(-2.0, 3.0), st.sampled_from(sorted(SCHEMES)))
def test_a_part_of_a_fine_line_is_as_all_of_it(power, speed, scheme):
    """Steady sliding on fine samples everywhere, which few of them can tell as well."""
    line = line_of(4, 5, 0.3, 40)
    load, v = 10.0**power * line.z.size, 10.0**speed
    law = SCHEMES[scheme](1.0 / (4 * v))
    state, _ = steady_sliding(law, line.z, load)
    samples = samples_per_contact(state.d - (line.z - state.w))
    stack = stack_of(line.z.reshape(1, -1), line.slope.reshape(1, -1))
    curvature = curvatures_of(line)
    found = refined(line, stack, curvature, (v, 1.2 * v), scheme, load, state, samples)
    if found is None or found.fold > size(64, 8):
        return
    heights, slopes = interpolate(
        line.z, line.slope, curvature, np.arange(line.z.size), 0.25, found.fold
    )
    law = SCHEMES[scheme](1.0 / (4 * found.fold * v))
    w, d = steady_sliding(law, heights, load * found.fold)[0]
    mu, _, contact = quadrature(heights, slopes, w, d, v, v, load * found.fold)
    after, _, _ = quadrature(heights, slopes, w, d, v, 1.2 * v, load * found.fold)
    steepest = np.abs(slopes).max()
    rounding = 1e-10 + 1e-13 * (d + v * steepest) * law.stiffness / 10.0**power
    assert found.d == pytest.approx(d, rel=rounding, abs=1e-12)
    assert found.contact == pytest.approx(contact, rel=rounding)
    assert found.jumps[0] == pytest.approx(after - mu, abs=rounding * steepest)
    assert found.samples == samples_per_contact(d - (heights - w)) >= 0.5 * FINE
    if 4 * found.fold * v > 3.0 and mu > 0.0:  # else there is more to it (friction.py)
        assert found.mu == pytest.approx(mu, abs=rounding * steepest)


@pytest.mark.parametrize(
    ("samples", "fold"),
    [(20.0, 4), (12.0, 4), (10.0, 6), (6.0, 8), (5.0, 12), (1.0, 48)],
)
def test_fine_samples_are_as_many_as_contacts_need_and_hardly_more(samples, fold):
    assert finer(samples) == fold
    assert FINE <= samples * fold < 1.7 * FINE


def test_wide_contacts_are_left_as_they_are():
    line = line_of(4)
    found = slide(line, 1.0, load=0.5)
    assert found.samples >= NARROW
    assert found.seen is None


def test_lines_that_are_not_smooth_are_left_as_they_are():
    line = line_of(4)._replace(band_limited=False)
    found = slide(line, 1e4)
    assert found.samples == 1.0
    assert found.seen is None
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
    assert found.seen is None


def test_narrow_contacts_are_seen_on_finer_samples_of_a_part_of_the_line():
    line, found = slide_with_jumps(100.0, 1e-3)
    assert found.seen.fold > 1
    assert found.samples_seen == found.seen.samples == found.seen.fold * found.samples
    assert found.samples < NARROW
    assert found.updates > line.z.size
    assert found.seen.updates < 0.1 * line.z.size * found.seen.fold
    assert 0.0 < found.contact < 0.01


@pytest.mark.parametrize(("speed", "load"), [(0.1, 3.0), (100.0, 1e-3)])
def test_jump_has_the_sign_of_the_step_and_vanishes_with_it(speed, load):
    _, found = slide_with_jumps(speed, load)
    faster, slower, same = found.jumps
    assert faster > 0.0 > slower
    assert same == pytest.approx(0.0, abs=1e-12)


def test_few_samples_that_are_refined_agree_with_many():
    few, many = slide_with_jumps(30.0, 1e-2, 4)[1], slide_with_jumps(30.0, 1e-2, 64)[1]
    assert few.mu == pytest.approx(many.mu, rel=0.02)
    assert few.indentation == pytest.approx(many.indentation, rel=0.02)
    assert few.contact == pytest.approx(many.contact, rel=0.05)


def test_rigid_shapes_of_samples_alone_are_never_refined():
    z = np.abs(np.linspace(-1.0, 1.0, 64, endpoint=False))
    slope = np.sign(np.linspace(-1.0, 1.0, 64, endpoint=False)) / 32.0
    line = Line.from_samples(z, slope, 8)
    assert not line.band_limited
    assert one_load(line, 10.0, "exponential", 1e-3 * z.size).seen is None
