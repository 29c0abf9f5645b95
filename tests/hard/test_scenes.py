"""Scenes at their limits: many branches, long rests, reversals, lines without a slope."""

import numpy as np
import pytest

from elastomer_friction.kernels.lines.line import Line
from elastomer_friction.kernels.motion.legs import Hold, Oscillation, Ramp, Slide
from elastomer_friction.kernels.rheology.forms import FORMS_BY_SCHEME
from elastomer_friction.kernels.rheology.spectrum import Spectrum, complex_modulus
from tests.kernels.scene.given import ANY_MOTION, MATERIALS, SOLID, a_line, trace
from tests.kernels.scene.test_known_answers import Q, response
from tests.sizes import size

SPREAD = np.geomspace(1e-7, 1e7, 30)  # fourteen decades
THIRTY = Spectrum((0.7,) * 30, tuple(SPREAD / (0.7 * SPREAD.sum())), 0.0)
PROGRAMME = (Slide(0.5, 4.3), Hold(2.0), Slide(-0.8, 3.0), Ramp(-0.8, 0.7, 6.0))


def assert_sound(traces, load=0.3):
    """Assert that values are finite, forces carry the load, and dissipation never decreases."""
    for name, values in traces.items():
        assert np.isfinite(values).all(), name
    np.testing.assert_allclose(traces["trace_normal_force"], load, rtol=1e-7)
    assert traces["trace_contact_fraction"].min() > 0.0
    if "dissipated_energy" in traces:
        assert np.diff(traces["dissipated_energy"]).min() >= 0.0


@pytest.mark.parametrize("start", ["steady", "relaxed", "fresh"])
@pytest.mark.parametrize("scheme", FORMS_BY_SCHEME)
def test_thirty_branches_over_fourteen_decades(scheme, start):
    """Some branches relax within a step, and some do not relax in the whole programme."""
    requested = ANY_MOTION if scheme == "exponential" else ("trace",)
    options = {"scheme": scheme, "start": start, "requested": requested}
    actual = trace(a_line(size(40, 12)), PROGRAMME, THIRTY, **options)
    assert_sound(actual)


@pytest.mark.parametrize("apart", [1e-2, 1e-4])
def test_a_branch_split_into_two_near_ones_changes_friction_by_the_square(apart):
    line = a_line(12)
    (g,), (t,) = SOLID.moduli, SOLID.times
    near = Spectrum((0.5 * g, 0.5 * g), (t * (1.0 - apart), t * (1.0 + apart)), 0.0)
    one, two = (trace(line, PROGRAMME, spectrum)["trace_mu"] for spectrum in (SOLID, near))
    assert np.abs(two - one).max() < apart**2 * np.abs(one).max()


@pytest.mark.parametrize("name", ["kelvin", "solid"])
def test_a_hold_of_ages_ends_relaxed(name):
    line = a_line()
    held = trace(line, (Slide(0.5, 3.3), Hold(1e9)), MATERIALS[name])
    rest = trace(line, (Slide(0.5, 3.3),), MATERIALS[name], start="relaxed")
    assert held["trace_indentation"][-1] == pytest.approx(rest["trace_indentation"][0], rel=1e-2)
    assert abs(held["trace_mu"][-1]) < 1e-2 * abs(held["trace_mu"][0])
    assert held["trace_mu"].size < 600


@pytest.mark.parametrize("name", MATERIALS)
def test_an_indentation_that_lifts_off_and_returns(name):
    """Friction is NaN where nothing touches, and after a long time the past is forgotten."""
    line = a_line()
    history = ((0.0, 4.0, 5.0, 1e6, 1e6 + 1.0), (1.0, 1.0, -9.0, -9.0, 1.0))
    programme = (Slide(0.5, 2.0), Hold(1e6 - 3.0), Slide(0.5, 2.0))
    actual = trace(line, programme, MATERIALS[name], indentation=history)
    touching = actual["trace_contact_fraction"] > 0.0
    np.testing.assert_array_equal(np.isfinite(actual["trace_mu"]), touching)
    np.testing.assert_array_equal(actual["trace_normal_force"] > 0.0, touching)
    assert touching[0]
    assert touching[-1]
    assert not touching.all()
    if name == "kelvin":
        return
    # The end is the same after a start without contact.
    late = ((0.0, 1.0, 2.0, 9.0), (-9.0, -9.0, 1.0, 1.0))
    again = trace(
        line, (Hold(1.0), Slide(0.5, 2.0)), MATERIALS[name], indentation=late, start="relaxed"
    )
    assert again["trace_normal_force"][-1] == pytest.approx(
        actual["trace_normal_force"][-1], rel=1e-2
    )


def test_a_reversal_within_a_contact_turns_friction_round():
    """Friction changes its sign within the size of a contact, and not at once."""
    actual = trace(a_line(), (Slide(0.5, 10.25), Slide(-0.5, 30.0)), SOLID)
    mu = actual["trace_mu"]
    assert mu[-1] < 0.0 < mu[0]
    assert np.isfinite(mu).all()
    back = trace(a_line(), (Slide(-0.5, 1.0),), SOLID)
    assert mu[-1] == pytest.approx(back["trace_mu"][0], rel=1e-2)


@pytest.mark.parametrize("omega", [3.0, 30.0])
def test_an_oscillation_of_a_thousandth_of_a_sample_shows_the_complex_modulus(omega):
    expected = (complex_modulus(SOLID, omega) - 1.0) * 0.5 * Q**2
    actual = response(SOLID, omega, 4, 8, samples=1e-3)
    assert abs(actual / expected - 1.0) < 5e-3


@pytest.mark.parametrize("name", MATERIALS)
def test_an_oscillation_of_a_thousandth_of_a_sample_is_linear_where_few_touch(name):
    """Ten times the motion changes friction ten times as much: samples cause no extra force."""
    line, spans = a_line(12), []
    for samples in (1e-3, 1e-4):
        motion = (Slide(0.5, 1.3), Hold(1e3), Oscillation(0.0, samples / 4, 1.0, 2))
        mu = trace(line, motion, MATERIALS[name])["trace_mu"]
        spans.append(np.ptp(mu[-64:]))
    assert spans[0] == pytest.approx(10.0 * spans[1], rel=2e-2)


SAMPLES = np.arange(64)
PROFILES = {
    "spikes": 5.0 * (SAMPLES % 17 == 3) - 2.0 * (SAMPLES == 40) + 0.01 * np.sin(0.3 * SAMPLES),
    "plateaus": np.round(3.0 * np.sin(2.0 * np.pi * SAMPLES / 64)),
    "teeth": SAMPLES % 2 * 1.0,
}


@pytest.mark.parametrize("profile", PROFILES)
@pytest.mark.parametrize("name", MATERIALS)
def test_profiles_with_spikes_and_plateaus(profile, name):
    line = Line.measured(PROFILES[profile], 1)
    actual = trace(line, PROGRAMME, MATERIALS[name], requested=ANY_MOTION)
    assert_sound(actual)
    between = Line.measured(PROFILES[profile], 16).slope  # reversals occur between samples
    assert np.abs(actual["trace_mu"]).max() <= 1.02 * np.abs(between).max()
