"""Stability of steady sliding on a spring, against predictions from velocity steps."""

import math

import numpy as np
import pytest
from scipy.optimize import curve_fit

from elastomer_friction.kernels import Slide, amplitudes, draw_phases, sample_line
from elastomer_friction.kernels.drive import Drive, run_pulled
from elastomer_friction.kernels.lines.line import Line
from elastomer_friction.kernels.scene import run_scene
from tests.kernels.scene.given import SOLID, a_scene
from tests.sizes import PLAIN_PYTHON

M, LOAD = 4, 0.1
SPEED = 50.0  # five spacings per relaxation time of the branch: velocity weakening
ROLLOFF = 50  # longest wave, in spacings; a long line averages over many such waves


def a_long_line(elements, seed=100):
    phases = draw_phases(np.random.default_rng(seed), elements)
    amplitude = amplitudes(0.7, elements, rolloff=elements / ROLLOFF)
    return Line.from_samples(*sample_line(amplitude, phases, elements, M), M)


def response(lines):
    """Return (t, d mu/d ln v, limit) after small velocity steps up and down."""
    ratios, distance = (1.05, 0.95), 12.0 * SOLID.times[0] * SPEED

    def mu(line, *legs):
        return run_scene(line, a_scene(legs, SOLID, M, load=LOAD))["trace_mu"]

    up, down = (
        np.mean(
            [mu(line, Slide(SPEED, 1.0), Slide(SPEED * r, distance))[M:] for line in lines], axis=0
        )
        for r in ratios
    )
    ends = [np.mean([mu(line, Slide(SPEED * r, 1.0))[0] for line in lines]) for r in ratios]
    scale, n = ratios[0] - ratios[1], min(up.size, down.size)
    t = np.arange(n) / (M * SPEED)
    return t, (up[:n] - down[:n]) / scale, (ends[0] - ends[1]) / scale


def force_after_a_pulse(line, stiffness, distance):
    """Return the response of the drive's force to a change of speed over one spacing.

    It is the difference of forces at equal positions of the drive, which removes the line's noise.
    """
    forces = []
    for r in (1.005, 0.995):
        scene = a_scene((Slide(SPEED * r, 1.0), Slide(SPEED, distance)), SOLID, M, load=LOAD)
        forces.append(run_pulled(line, scene, Drive(stiffness * LOAD))["trace_drive_force"])
    return (forces[0] - forces[1])[M:]


def fitted_rate_state(distance, step):
    """Return a, b and D_c of a - b (1 - exp(-s/D_c)), fitted to the response to a step."""
    (a, b, length), _ = curve_fit(
        lambda s, a, b, length: a - b * (1.0 - np.exp(-s / length)),
        distance,
        step,
        (0.0, 0.01, 5.0),
    )
    return a, b, length


def critical_stiffness(t, step, end):
    """Return (k_c/F_N, w) where k + s F_N T(s) = 0 has a root on the imaginary axis, s = i w.

    T(s) is s/v times the Laplace transform of the response to a step.
    """
    w = np.geomspace(0.5, 20.0, 400) / SOLID.times[0]
    rest = np.trapezoid(np.exp(-1j * np.outer(w, t)) * (step - end), t, axis=1)
    transfer = (end + 1j * w * rest) / SPEED
    (first, *_) = np.flatnonzero((transfer.real[:-1] < 0.0) & (transfer.real[1:] >= 0.0))
    return float(np.mean((w * transfer.imag)[first : first + 2])), float(w[first])


@pytest.mark.skipif(PLAIN_PYTHON, reason="NUMBA_DISABLE_JIT=1: ways of 20 000 elements")
def test_steady_sliding_is_stable_above_the_stiffness_predicted_from_velocity_steps():
    """Source: J. R. Rice, A. L. Ruina, J. Appl. Mech. 50, 343 (1983), doi:10.1115/1.3167042."""
    lines = [a_long_line(20000, seed) for seed in (100, 101, 102)]
    t, step, end = response(lines)
    critical, w = critical_stiffness(t, step, end)
    period = 2.0 * math.pi / w

    def growth(stiffness):
        """Return the amplitude ratio of the second period to the first."""
        distance, one = 2.6 * period * SPEED, round(period * SPEED * M)
        response_to_pulse = np.mean(
            [force_after_a_pulse(line, stiffness, distance) for line in lines], axis=0
        )
        first, second = (
            response_to_pulse[one // 2 :][:one],
            response_to_pulse[one // 2 + one :][:one],
        )
        return math.sqrt(np.mean(second**2) / np.mean(first**2))

    soft, stiff = growth(0.75 * critical), growth(1.3 * critical)
    assert soft > 2.0
    assert stiff < 0.5
    # In k_c = -(d mu/d ln v) F_N/D_c, D_c is that of a velocity step, not v t_b of the branch.
    a, b, length = fitted_rate_state(SPEED * t, step)
    assert (b - a) / length == pytest.approx(critical, rel=0.2)
    assert length < 0.75 * SPEED * SOLID.times[0]
