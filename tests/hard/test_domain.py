"""Properties over all of H = 0 to 1, Fbar = 1e-6 to 1e4, x = 1e-4 to 1e6, v2/v1 = 1e-3 to 101."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kernels import SCHEMES, Case, Line, Quantities, amplitudes, run_case
from studies.stability.probe import Motion, probe
from tests.hard.bounds import EPS, MARGIN, assert_stable, bounds
from tests.reference_march import constants, steady
from tests.sizes import size

RECORD = np.array([1, 2, 4, 9])
FEW = settings(max_examples=size(60, 15), deadline=None, derandomize=True, database=None)


def log_uniform(least: float, most: float):
    """Return numbers whose logarithm is spread evenly."""
    return st.floats(np.log(least), np.log(most)).map(lambda q: float(np.exp(q)))


@st.composite
def lines(draw):
    """Return a random line of any Hurst exponent."""
    n, m = draw(st.integers(8, 24)), draw(st.integers(1, 3))
    angles = st.lists(st.floats(0.0, 6.28), min_size=n // 2, max_size=n // 2)
    return Line.self_affine(amplitudes(draw(st.floats(0.0, 1.0)), n), np.array(draw(angles)), n, m)


@st.composite
def motions(draw):
    """Return a line under load, and a velocity step, from the whole domain."""
    speed = draw(log_uniform(1e-4, 1e6)) / np.pi
    ratio = draw(log_uniform(1e-3, 101.0))
    scheme = draw(st.sampled_from(sorted(SCHEMES)))
    return Motion(draw(lines()), draw(log_uniform(1e-6, 1e4)), speed, ratio, scheme)


def run(motion: Motion, line=None, load=None, speed=None):
    """Return every number of the case in one array, mu first."""
    line = motion.line if line is None else line
    case = Case(
        load or motion.load, speed or motion.speed, (motion.ratio,), (RECORD,), motion.scheme
    )
    found = run_case(line, case, Quantities())
    return np.concatenate([[found.mu_1], found.mu_2, found.jump, *found.curves]), found


@FEW
@given(motions())
def test_residuals_stay_within_rounding(motion):
    """Balance, contact, no energy created, steady stays steady: studies/stability/probe.py."""
    assert_stable(motion, probe(motion, 15))


@FEW
@given(motions(), st.integers(-60, 60))
def test_heights_and_load_scale_bit_for_bit(motion, power):
    s = 2.0**power
    line = motion.line
    scaled = Line(s * line.z, s * line.slope, s * line.datum, line.steps_per_spacing)
    mu, one = run(motion)
    scaled_mu, other = run(motion, scaled, s * motion.load)
    np.testing.assert_array_equal(scaled_mu, s * mu)
    assert other.indentation == s * one.indentation
    assert other.contact_fraction == one.contact_fraction


@FEW
@given(motions(), st.integers(0, 6))
def test_lengths_scale_bit_for_bit(motion, power):
    """The same samples on another spacing: speed and slopes change, the problem does not."""
    s = 2**power
    line = motion.line
    wide = Line(line.z, s * line.slope, line.datum, s * line.steps_per_spacing)
    mu, one = run(motion)
    wide_mu, other = run(motion, wide, speed=motion.speed / s)
    np.testing.assert_array_equal(wide_mu, s * mu)
    assert other.indentation == one.indentation


@FEW
@given(motions(), st.integers(1, 71))
def test_cyclic_shifts_change_nothing_but_rounding(motion, shift):
    _, law = motion.step(1.0)
    (w, d), _ = motion.steady(law)
    rolled = motion._replace(line=motion.line._replace(z=np.roll(motion.line.z, shift)))
    (w_rolled, d_rolled), _ = rolled.steady(law)
    assert abs(d_rolled / d - 1.0) <= bounds(motion)["steady"]
    lost = MARGIN * EPS * (motion.line.z.max() + d) + abs(d_rolled - d)
    assert np.max(np.abs(w_rolled - np.roll(w, shift))) <= lost
    # A line is turned to its top: the same numbers to the bit, wherever it was cut.
    again = Line.from_samples(rolled.line.z, np.roll(motion.line.slope, shift), 1)
    np.testing.assert_array_equal(again.z, motion.line.z)


@FEW
@given(motions())
def test_the_mirror_image_moving_the_other_way_is_the_same(motion):
    dt, law = motion.step(1.0)
    (_, d), _ = motion.steady(law)
    mirrored = motion.line.z[::-1].copy()
    _, _, expected = steady(mirrored, motion.load, constants(motion.scheme, dt)[0], direction=-1)
    # The reference takes the load from mean(-u): eps K of it is lost, as K (1 - E) = 1.
    assert abs(d / expected - 1.0) <= bounds(motion)["steady"]


@FEW
@given(motions(), st.floats(1.0001, 1e3))
def test_more_load_presses_deeper(motion, factor):
    _, law = motion.step(1.0)
    (w, d), _ = motion.steady(law)
    z, heavier = motion.line.z, motion._replace(load=factor * motion.load)
    (w_more, deeper), _ = heavier.steady(law)
    assert deeper > d
    # d grows at most as fast as the load: the force is convex and vanishes at the bottom.
    assert deeper <= factor * d * (1.0 + bounds(heavier)["steady"])
    assert np.sum(z - w_more < deeper) >= np.sum(z - w < d)


@FEW
@given(lines(), log_uniform(1e-4, 1e6), st.sampled_from(sorted(SCHEMES)), st.data())
def test_full_contact_superposes(line, x, scheme, data):
    """Everything touches: d and displacements are linear in load and heights."""
    speed = x / np.pi
    steep = line.z.max() + speed * np.abs(line.slope).max()
    load = data.draw(st.floats(3.0, 10.0)) * steep  # every pressure is positive
    motion = Motion(line, load, speed, 1.0, scheme)
    _, law = motion.step(1.0)
    (w, d), _ = motion.steady(law)
    assert np.all(line.z - w < d)
    lost = MARGIN * EPS * (1.0 + law.stiffness)
    assert d == pytest.approx(load + line.z.mean(), rel=lost)
    added = Line(2.0 * line.z, 2.0 * line.slope, 0.0, line.steps_per_spacing)
    (_, both), _ = Motion(added, 3.0 * load, speed, 1.0, scheme).steady(law)
    (_, rest), _ = Motion(line, 2.0 * load, speed, 1.0, scheme).steady(law)
    assert both == pytest.approx(d + rest, rel=lost)


@FEW
@given(motions())
def test_refined_samples_lie_on_the_same_line(motion):
    """Twice the samples: d moves by less than the height that lies between two samples."""
    n, m = motion.line.z.size // motion.line.steps_per_spacing, motion.line.steps_per_spacing
    fine = motion.line
    coarse = Line.from_samples(fine.z[::m], fine.slope[::m], 1)
    one, other = (Motion(q, motion.load, motion.speed, 1.0, motion.scheme) for q in (coarse, fine))
    assert coarse.z.size == n
    (_, d_one), _ = one.steady(one.step(1.0)[1])
    (_, d_other), _ = other.steady(other.step(1.0)[1])
    between = np.abs(fine.slope).max()
    assert abs((d_one + coarse.datum) - d_other) <= between + 1e-9 * (d_one + d_other)
