"""The general computation of a case, against the fast one and in its limits."""

import numpy as np
import pytest

from elastomer_friction.kernels import (
    Case,
    Line,
    Quantities,
    Spectrum,
    amplitudes,
    draw_phases,
    run_case,
)
from elastomer_friction.kernels.velocity_step.memory_case import run_memory_case

LINE = Line.self_affine(amplitudes(0.7, 64), draw_phases(np.random.default_rng(2), 64), 64, 8)
KEPT = np.array([1, 2, 5, 20, 100, 400])
CASE = Case(0.3, 2.0, (1.5,), (KEPT,), "exponential")
SOLID = CASE._replace(spectrum=Spectrum((8.0,), (0.125,), 0.0))
REQUESTED = Quantities(initial_rate=True)


def test_a_kelvin_element_relaxes_as_on_the_fast_path():
    sampled = CASE._replace(refine=False)  # the general path uses the samples only
    quick, general = run_case(LINE, sampled, REQUESTED), run_memory_case(LINE, sampled, REQUESTED)
    relaxed = [outcome.curves[0] - outcome.mu_2[0] for outcome in (quick, general)]
    assert relaxed[1] == pytest.approx(relaxed[0], abs=1e-11)
    assert general.indentation == pytest.approx(quick.indentation, rel=1e-12)
    assert general.mu_1 == pytest.approx(quick.mu_1, rel=0.05)  # other quadratures
    assert general.jump[0] == pytest.approx(quick.jump[0], rel=0.05)


def test_without_a_dashpot_friction_rises_continuously():
    outcome = run_case(LINE, SOLID, REQUESTED)
    assert outcome.jump[0] == 0.0
    assert outcome.initial_rate[0] > 0.0
    step = 1.0 / (8 * 3.0)
    assert outcome.mu_1 < outcome.curves[0][0] < outcome.mu_1 + 1.1 * step * outcome.initial_rate[0]
    assert outcome.curves[0].max() > max(outcome.curves[0][0], outcome.mu_2[0])
    assert outcome.curves[0][-1] == pytest.approx(outcome.mu_2[0], rel=0.02)


def test_a_slow_weak_branch_changes_nothing():
    """A step is 1e-11 of its relaxation time: its state is small, but not lost in rounding."""
    slow = 1e7
    with_it = SOLID._replace(
        speed=2.0 * slow, spectrum=Spectrum((8.0, 1e-6), (0.125 / slow, 1.0), 0.0)
    )
    for number, expected in zip(
        run_case(LINE, with_it, REQUESTED)[:4], run_case(LINE, SOLID, REQUESTED)[:4], strict=True
    ):
        assert number == pytest.approx(expected, rel=1e-5)


def test_steps_lost_in_the_rounding_of_the_fastest_branch_are_refused():
    solid = Spectrum((8.0, 1.0), (1e-2, 1.0), 0.0)
    run_case(LINE, SOLID._replace(speed=1e10, spectrum=solid), Quantities(False, False, False))
    for spectrum, speed in ((solid._replace(viscosity=1.0), 1e10), (solid, 1e11)):
        with pytest.raises(ValueError, match="lost in rounding"):
            run_case(LINE, SOLID._replace(speed=speed, spectrum=spectrum), REQUESTED)
