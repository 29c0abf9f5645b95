"""Errors of means under correlated noise are true; what is not known is no number."""

import math

import numpy as np
import pytest

from elastomer_friction.workflow.laboratory.estimate import Estimate, correlation_factor, mean
from tests.workflow.laboratory.given import noise


@pytest.mark.parametrize("correlation", [0.0, 0.5, 0.9])
def test_stated_errors_of_means_hold_two_thirds_of_them(correlation):
    found = [mean(noise(seed, 1500, 2.0, correlation)) for seed in range(100)]
    pulls = np.array([each.value / each.error for each in found])
    assert 0.55 < np.mean(abs(pulls) < 1.0) < 0.82
    assert np.mean(abs(pulls) < 3.0) > 0.95


def test_the_factor_is_that_of_the_autocorrelation():
    factor = correlation_factor(noise(1, 200_000, 1.0, 0.8))
    assert factor == pytest.approx((1.0 + 0.8) / (1.0 - 0.8), rel=0.05)
    assert correlation_factor(noise(1, 200_000, 1.0, -0.8)) == 1.0
    assert correlation_factor(np.ones(50)) == 1.0


def test_an_estimate_is_known_or_not():
    assert Estimate(1.0, 0.1).known
    assert not Estimate().known
    assert not Estimate(1.0, math.inf).known
    assert Estimate(1.0, 0.1).times(-2.0) == Estimate(-2.0, 0.2)
    assert Estimate(1.0, 0.1).if_below(0.2).known
    assert not Estimate(1.0, 0.1).if_below(0.1).known
