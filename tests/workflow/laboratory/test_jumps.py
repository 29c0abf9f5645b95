"""grad z from jumps: found on the plateau, unknown where the jump is in proportion to friction."""

import numpy as np
import pytest

from elastomer_friction.workflow.laboratory.estimate import Estimate
from elastomer_friction.workflow.laboratory.record import measured_steps
from elastomer_friction.workflow.laboratory.step_fit import fit_step
from elastomer_friction.workflow.laboratory.together import fit_slope, predicted_jump
from tests.workflow.laboratory.given import SLOPE, law, record

STEP = fit_step(*measured_steps(record()))


def slope(speeds, share=0.02, seed=None, ratio=1.2):
    """Return grad z from jumps with relative errors; seed: of their scatter, None for none."""
    rng = np.random.default_rng(seed)
    fits = []
    for v in speeds:
        off = share * rng.standard_normal() if seed is not None else 0.0
        jump = float(law().jump(v, ratio * v)) * (1.0 + off)
        step = STEP.step._replace(v1=v, v2=ratio * v)
        mu = Estimate(float(law().steady(v)), 0.0)
        fits.append(STEP._replace(step=step, mu_1=mu, jump=Estimate(jump, share * abs(jump))))
    return fit_slope(fits)


@pytest.mark.parametrize("ratio", [0.8, 1.2])
def test_the_slope_of_the_law_is_found(ratio):
    assert slope([0.05, 0.1, 1.0], ratio=ratio).value == pytest.approx(SLOPE, rel=1e-3)


def test_stated_errors_hold_two_thirds_of_the_estimates():
    found = [slope([0.02, 0.05, 0.2, 1.0], seed=seed) for seed in range(40)]
    pulls = np.array([(each.value - SLOPE) / each.error for each in found])
    assert np.mean(abs(pulls) < 1.0) > 0.5
    assert np.mean(abs(pulls) < 3.0) > 0.95


def test_jumps_in_proportion_to_friction_say_nothing():
    assert not slope([1e-5, 1e-4]).known
    assert not fit_slope([STEP._replace(jump=Estimate())]).known


def test_the_jump_is_that_of_equation_12():
    for v in (1e-3, 0.1):
        jump = predicted_jump(np.array([float(law().steady(v))]), SLOPE)
        assert 0.2 * jump[0] == pytest.approx(float(law().jump(v, 1.2 * v)))
