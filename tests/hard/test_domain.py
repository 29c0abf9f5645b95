"""Properties for H = 0 to 1, Fbar = 1e-6 to 1e4, x = 1e-4 to 1e6, v2/v1 = 1e-3 to 101."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from elastomer_friction.kernels import SCHEMES, Case, Line, Quantities, amplitudes, run_case
from elastomer_friction.studies.stability.probe import Motion, probe
from tests.hard.bounds import EPS, MARGIN, assert_stable, bounds
from tests.reference_march import constants, steady
from tests.sizes import size
from tests.support.sweeps import examples

NEAREST = 1e-4  # smallest relative velocity step; one below 1e-9 is rejected
FEW = settings(max_examples=size(examples(30), 15), deadline=None, derandomize=True, database=None)


def log_uniform(least: float, most: float):
    """Return a strategy of numbers with uniform logarithm."""
    return st.floats(np.log(least), np.log(most)).map(lambda q: float(np.exp(q)))


def ratios():
    """Return a strategy of v2/v1: 1, or a step that is not lost in rounding."""
    down, up = log_uniform(1e-3, 1.0 - NEAREST), log_uniform(1.0 + NEAREST, 101.0)
    return st.one_of(st.just(1.0), down, up)


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
    ratio = draw(ratios())
    scheme = draw(st.sampled_from(sorted(SCHEMES)))
    return Motion(draw(lines()), draw(log_uniform(1e-6, 1e4)), speed, ratio, scheme)


def numbers(motion: Motion):
    """Return (all coefficients of friction, indentation, contact fraction) of a velocity step."""
    kept_steps = np.array([1, 2, 4, 9])
    case = Case(motion.load, motion.speed, (motion.ratio,), (kept_steps,), motion.scheme)
    actual = run_case(motion.line, case, Quantities())
    mu = np.array([actual.mu_1, *actual.mu_2, *actual.jump, *actual.curves[0]])
    return mu, actual.indentation, actual.contact_fraction


def indentation(motion: Motion) -> float:
    """Return d of steady sliding before the velocity step."""
    return motion.steady(motion.step(1.0)[1])[0].d


@FEW
@given(motions())
def test_residuals_stay_within_rounding(motion):
    """See studies/stability/probe.py for the residuals."""
    assert_stable(motion, probe(motion, 15))


@FEW
@given(motions(), st.integers(-60, 60), st.integers(0, 6))
def test_heights_load_and_lengths_scale_bit_for_bit(motion, power, widened):
    """Scaling heights and spacing only changes the units of the problem."""
    s, wide, line = 2.0**power, 2**widened, motion.line
    z, slope, datum = s * line.z, s * wide * line.slope, s * line.datum
    if widened:  # prevent refinement of the line, which depends on the samples per spacing
        line = line._replace(band_limited=False)
        motion = motion._replace(line=line)
    scaled = Line(z, slope, datum, wide * line.steps_per_spacing, line.band_limited)
    mu, d, contact = numbers(motion)
    other = motion._replace(line=scaled, load=s * motion.load, speed=motion.speed / wide)
    scaled_mu, scaled_d, scaled_contact = numbers(other)
    np.testing.assert_array_equal(scaled_mu, s * wide * mu)
    assert (scaled_d, scaled_contact) == (s * d, contact)


@FEW
@given(motions())
def test_the_mirror_image_moving_the_other_way_is_the_same(motion):
    mirrored = motion.line.z[::-1].copy()
    decay, _, _ = constants(motion.scheme, motion.step(1.0)[0])
    _, _, expected = steady(mirrored, motion.load, decay, direction=-1)
    # The reference takes the load from mean(-u), with an error of eps K, as K (1 - E) = 1.
    assert abs(indentation(motion) / expected - 1.0) <= bounds(motion)["steady"]


@FEW
@given(motions(), st.floats(1.0001, 1e3))
def test_more_load_presses_deeper(motion, factor):
    heavier = motion._replace(load=factor * motion.load)
    law = motion.step(1.0)[1]
    ((w, d), _), ((w_more, deeper), _) = motion.steady(law), heavier.steady(law)
    assert deeper > d
    # d grows at most in proportion to the load, as the force is convex in d and zero at d = 0.
    assert deeper <= factor * d * (1.0 + bounds(heavier)["steady"])
    z = motion.line.z
    assert np.sum(z - w_more < deeper) >= np.sum(z - w < d)


@FEW
@given(motions(), st.floats(3.0, 10.0))
def test_full_contact_superposes(motion, factor):
    """In full contact d and displacements are linear in load and heights."""
    line = motion.line
    steep = line.z.max() + motion.speed * np.abs(line.slope).max()
    one = motion._replace(load=factor * steep)  # every pressure is positive
    law = one.step(1.0)[1]
    (w, d), _ = one.steady(law)
    assert np.all(line.z - w < d)
    lost = MARGIN * EPS * (1.0 + law.stiffness)
    assert d == pytest.approx(one.load + line.z.mean(), rel=lost)
    added = Line(2.0 * line.z, 2.0 * line.slope, 0.0, line.steps_per_spacing)
    both = indentation(one._replace(line=added, load=3.0 * one.load))
    rest = indentation(one._replace(load=2.0 * one.load))
    assert both == pytest.approx(d + rest, rel=lost)
