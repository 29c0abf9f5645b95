"""What is listed and what is summed make up what touches."""

import numpy as np
import pytest

from kernels.active.bounds import first_bounds, first_indentation
from kernels.active.lists import lists_of, sums_of, weighed
from kernels.active.runs import classes_of
from tests.kernels.active.given import Jump, setting_of


@pytest.mark.parametrize("load", [0.01, 0.3, 3.0])
def test_lists_and_sums_carry_the_load_of_the_start_together(load):
    """Were the speed not to change: then D is d (1 - E) at once."""
    setting, force = setting_of(Jump(0.5, 4, load, 10.0, 1.0), 150)
    guess = first_indentation(setting, force)
    bounds = first_bounds(setting, guess, 0.1)
    runs, stretches = classes_of(setting, bounds)
    lists, sums = lists_of(setting, bounds, runs), sums_of(setting, stretches)
    depth, _ = weighed(lists.c, lists.weight, setting.start.d)
    assert setting.law.stiffness * (depth + sums.depth) == pytest.approx(force, rel=1e-9)
    assert lists.first[-1] == lists.z.size == (runs.top - runs.bottom + 1).sum()


def test_weighed_sums_are_those_of_the_touching_samples():
    c, weight = np.random.default_rng(2).standard_normal((2, 23))
    each = np.maximum(0.3 - c, 0.0)
    assert weighed(c, weight, 0.3) == pytest.approx((each.sum(), (each * weight).sum()), rel=1e-12)
