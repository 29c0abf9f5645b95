"""What is said of doubled keys of [numerics] is so."""

import numpy as np

from elastomer_friction.workflow.plan.error_laws import LAWS
from tests.support.small import small_plan


def test_steps_doubled_at_least_halve_the_error_of_steady_friction():
    (problem, *_) = [task.problem for task in small_plan().variants[0].tasks]
    eight, sixteen = (LAWS["mu_1"].error(problem, m, refine=False) for m in (8, 16))  # a number
    assert eight >= 2.0 * sixteen


def test_a_horizon_doubled_doubles_the_march():
    once, twice = (
        np.array(
            [task.march_steps for task in small_plan(f"numerics.horizon={h}").variants[0].tasks]
        )
        for h in (8, 16)
    )
    assert np.all(np.abs(twice / once - 2.0) < 0.3)


def test_an_accuracy_doubled_takes_a_quarter_of_the_lines():
    fine, coarse = (
        sum(small_plan(f"numerics.accuracy={a}", "numerics.steps_per_spacing=8").expected.values())
        for a in (0.01, 0.02)
    )
    assert 3.5 < fine / coarse < 4.5
