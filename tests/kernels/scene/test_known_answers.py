"""Scenes with known results: moduli, relaxation and creep of the material."""

import math

import numpy as np
import pytest

from elastomer_friction.kernels.lines.line import Line
from elastomer_friction.kernels.motion.legs import Hold, Oscillation
from elastomer_friction.kernels.rheology.retardation import retardation
from elastomer_friction.kernels.rheology.spectrum import complex_modulus, relaxation_modulus
from elastomer_friction.kernels.scene import run_scene
from tests.convergence import observed_order
from tests.kernels.scene.given import MATERIALS, PRONY, SOLID, a_line, a_scene
from tests.sizes import size

Q = 2.0 * np.pi / 16  # wave number of the indenting wave, in 1/dx


def response(spectrum, omega, m, cycles, samples=0.03):
    """Return F_x/X of a small oscillation in full contact, in 4 G L h^2/dx per dx."""
    amplitude = samples / m
    x = np.arange(16 * m) / m
    line = Line.from_samples(np.cos(Q * x), -Q * np.sin(Q * x), m)
    programme = (Oscillation(0.0, amplitude, omega / (2.0 * math.pi), cycles),)
    scene = a_scene(programme, spectrum, m, start="relaxed", indentation=30.0)
    result = run_scene(line, scene)
    last = slice(-16 * m, None)
    waves = np.stack([f(omega * result["trace_time"][last]) for f in (np.sin, np.cos)], axis=1)
    measured, *_ = np.linalg.lstsq(waves, result["trace_friction_force"][last], rcond=None)
    return complex(*measured) / amplitude


CYCLES = {3.0: 6, 30.0: 24}  # number of cycles by omega


def errors_of_moduli(spectrum, refinements):
    """Return errors of F_x = X rms(z')^2 (G*/G - 1), shape (refinements, frequencies)."""
    result = [[response(spectrum, w, m, n) for w, n in CYCLES.items()] for m in refinements]
    expected = [(complex_modulus(spectrum, omega) - 1.0) * 0.5 * Q**2 for omega in CYCLES]
    return np.abs(np.array(result) / expected - 1.0)


@pytest.mark.parametrize("name", MATERIALS)
def test_a_small_oscillation_in_full_contact_shows_the_complex_modulus(name):
    """The amplitude is 0.03 samples; errors are of second order."""
    errors = errors_of_moduli(MATERIALS[name], (4, 8)[: size(2, 1)])
    assert errors[0].max() < 5e-3
    # With a dashpot and branches, the order is lower if a branch's time is a few steps.
    fall = 0.6 if name == "damped" else 0.35
    assert (errors[-1] < size(fall, 1.1) * errors[0]).all()


def relaxation_errors(spectrum, refinements, scheme="exponential"):
    """Return the maximum error of F = mean(d - z) G(t) in a hold at constant indentation."""
    errors = []
    for m in refinements:
        line = a_line(8, 0.7, m, 1)
        options = {"start": "fresh", "indentation": 20.0, "scheme": scheme}
        scene = a_scene((Hold(5.0),), spectrum, m, **options)
        result = run_scene(line, scene)
        modulus = relaxation_modulus(spectrum, result["trace_time"])
        expected = (20.0 - (line.z.mean() + line.datum)) * modulus
        errors.append([np.abs(result["trace_normal_force"] / expected - 1.0).max()])
    return np.array(errors)


def test_stress_relaxes_as_the_modulus_at_second_order():
    """The indentation is constant from the start; the relaxation form is exact."""
    assert relaxation_errors(PRONY, [2], "implicit-euler") < 1e-11
    refinements = np.array([2, 4, 8, 16])
    errors = relaxation_errors(PRONY, refinements)
    assert observed_order(refinements, errors) > 1.8
    assert errors[-1] < 1e-3


@pytest.mark.parametrize("spectrum", [SOLID, PRONY], ids=str)
@pytest.mark.parametrize("duration", [0.01, 0.3, 20.0])
def test_creep_under_a_load_is_exact(spectrum, duration):
    """All elements carry the same force: d = F J(t) for any steps."""
    line = Line.from_samples(np.zeros(8), np.zeros(8), 1)
    form = retardation(spectrum)
    scene = a_scene((Hold(duration),), spectrum, 1, start="fresh", requested=("trace", "state"))
    crept = form.glass - np.sum(form.compliances * np.expm1(-duration / form.times))
    assert float(run_scene(line, scene)["state_d"]) == pytest.approx(0.3 * crept, rel=1e-12)
