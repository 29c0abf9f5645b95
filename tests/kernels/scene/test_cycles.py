"""Mean friction over cycles, against sums over all steps and theory in full contact."""

import math

import numpy as np
import pytest

from elastomer_friction.kernels.lines.line import Line
from elastomer_friction.kernels.motion.legs import Oscillation, Slide
from elastomer_friction.kernels.rheology.spectrum import complex_modulus
from elastomer_friction.kernels.scene import SCENE_QUANTITIES, run_scene, scene_steps
from tests.kernels.scene.given import MATERIALS, PRONY, a_line, a_scene
from tests.sizes import size

Q = 2.0 * math.pi / 16.0  # wave number of a line with one wave, in 1/dx
DEEP = 30.0  # indentation of full contact, in h


def bessel(n, x):
    """Return J_n(x) by the trapezoidal rule over a period, exact to rounding."""
    angle = 2.0 * math.pi * np.arange(256) / 256
    return np.mean(np.cos(n * angle - x * np.sin(angle)))


def mean_in_full_contact(spectrum, speed, amplitude, omega):
    """Return the mean friction (h/dx) of a wave cos Q x that moves by v t + a sin(omega t).

    The wave is exp(-i Q X) = sum J_n(Q a) exp(-i (Q v + n omega) t). Its frequencies contribute
    independently: F_x = Q/2 sum J_n(Q a)^2 G''(Q v + n omega)/G.
    """
    n = np.arange(-60, 61)
    weight = np.array([bessel(order, Q * amplitude) for order in n]) ** 2
    frequency = Q * speed + n * omega
    loss = np.sign(frequency) * complex_modulus(spectrum, np.abs(frequency)).imag
    return 0.5 * Q * float(weight @ loss) / DEEP


@pytest.mark.parametrize("turns", [0.05, 1.0, 6.0])  # Q times amplitude
@pytest.mark.parametrize("share", [0.5, 3.0])  # velocity amplitude over mean velocity
@pytest.mark.parametrize("name", ["kelvin", "prony"])
def test_mean_friction_in_full_contact_is_the_sum_over_frequencies_of_a_modulated_wave(
    name, share, turns
):
    m, speed = size(8, 4), 20.0
    x = np.arange(16 * m) / m
    line = Line.from_samples(np.cos(Q * x), -Q * np.sin(Q * x), m)
    amplitude = turns / Q
    omega = share * speed / amplitude
    steady = mean_in_full_contact(MATERIALS[name], speed, 1e-9, omega)
    expected = mean_in_full_contact(MATERIALS[name], speed, amplitude, omega)
    legs = (Oscillation(speed, amplitude, omega / (2.0 * math.pi), size(16, 2)),)
    scene = a_scene(
        legs,
        MATERIALS[name],
        m,
        indentation=DEEP,
        requested=SCENE_QUANTITIES,
        recorded=np.arange(1),
    )
    result = float(run_scene(line, scene)["mu_cycle_mean"])
    assert result == pytest.approx(expected, rel=size(2e-3, 2e-2))
    if name == "kelvin":  # the loss is proportional to the velocity
        assert expected == pytest.approx(steady, rel=1e-12)
    elif share > 1.0 and turns > 0.5:
        assert expected < 0.9 * steady


SWINGS = (Oscillation(0.3, 1.0, 0.2, 2), Oscillation(0.1, 2.3, 0.1, 5), Slide(0.4, 3.0))


@pytest.mark.parametrize("start", ["steady", "fresh"])
def test_cycle_mean_is_the_mean_over_the_later_half_of_the_last_oscillation(start):
    """The mean covers three of five cycles and does not depend on the recorded steps."""
    line = a_line()
    scene = a_scene(SWINGS, PRONY, indentation=0.5, start=start, requested=SCENE_QUANTITIES)
    result, ends = run_scene(line, scene), np.cumsum(scene_steps(scene, 4).dt)
    begin, end = 2.0 / 0.2 + 2.0 / 0.1, 2.0 / 0.2 + 5.0 / 0.1
    inside = (ends > begin + 1e-6) & (ends < end + 1e-6)
    dt = np.diff(np.append(0.0, ends))[inside]
    force, normal = (
        result[f"trace_{name}_force"][1:][inside] @ dt for name in ("friction", "normal")
    )
    assert normal > 0.0
    assert result["mu_cycle_mean"] == pytest.approx(force / normal, rel=1e-12)
    few = run_scene(line, scene._replace(recorded=np.array([0, 7])))
    assert few["mu_cycle_mean"] == result["mu_cycle_mean"]
    assert math.isnan(run_scene(line, scene._replace(indentation=-9.0))["mu_cycle_mean"])


def test_cycle_mean_without_an_oscillation_is_refused():
    with pytest.raises(ValueError, match="no leg of the programme oscillates"):
        run_scene(a_line(10), a_scene((Slide(0.7, 1.0),), requested=("cycle_mean",)))
