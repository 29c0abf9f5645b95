"""Fits of relaxations with an unknown rate: exact without noise, open where any rate will do."""

import numpy as np
import pytest

from elastomer_friction.workflow.laboratory.step_fit import fit_relaxation_curve
from elastomer_friction.workflow.reduce import LAWS, step_law
from tests.workflow.laboratory.given import noise

T = np.linspace(0.01, 3.0, 300)


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("ratio", [0.1, 1.2, 10.0])
def test_without_noise_the_parameters_are_exact(law, ratio):
    shape = step_law(law, ratio)
    values = 0.3 + shape(np.array([[0.05, np.log(4.0)]]), T)[0][0]
    fit = fit_relaxation_curve(T, values, shape)
    np.testing.assert_allclose(fit.p, [0.3, 0.05, np.log(4.0)], rtol=1e-6)
    assert fit.error(np.array([1.0, 0.0])) < 1e-9


def test_the_covariance_is_that_of_the_scatter():
    shape = step_law("ruina", 1.2)
    curve = 0.3 + shape(np.array([[0.05, np.log(4.0)]]), T)[0][0]
    fits = [fit_relaxation_curve(T, curve + noise(s, T.size, 1e-4), shape) for s in range(40)]
    scatter = np.std([fit.p for fit in fits], axis=0, ddof=1)
    stated = np.mean([np.sqrt(np.diag(fit.covariance)) for fit in fits], axis=0)
    np.testing.assert_allclose(scatter, stated, rtol=0.35)  # a tenth of it by chance


def test_noise_alone_is_compatible_with_any_rate_and_a_slow_one_with_all_slower():
    shape = step_law("ruina", 1.2)
    assert fit_relaxation_curve(T, 0.3 + noise(1, T.size, 1e-3), shape).compatible.all()
    slow = 0.3 + shape(np.array([[0.05, np.log(0.05)]]), T)[0][0] + noise(1, T.size, 1e-4)
    fit = fit_relaxation_curve(T, slow, shape)
    assert fit.compatible[0]
    assert not fit.compatible[-1]
    level = np.array([1.0, 0.0])
    assert fit.spread(level) > 5.0 * fit.spread(np.array([1.0, np.log(1.2)]))
