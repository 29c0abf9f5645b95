"""Elements on their way to the runs are where steady sliding has them."""

import numpy as np
import pytest

from kernels import ConstantForce
from kernels.active.aloft import aloft_at_first
from kernels.active.balance import foresee
from kernels.active.bounds import first_bounds
from kernels.active.lists import lists_of
from kernels.active.runs import classes_of
from tests.kernels.active.given import Jump, setting_of, states_of

STEPS = 30


@pytest.mark.parametrize("load", [1e-3, 0.1, 1.0])
def test_displacements_before_the_first_step_are_those_of_the_plain_sweep(load):
    setting, force = setting_of(Jump(0.5, 4, load, 10.0, 1.2), 120)
    bounds = first_bounds(setting, foresee(ConstantForce(force), setting), 0.1)
    runs, met, _ = classes_of(setting, bounds)
    w = np.full(setting.z.size, np.nan)
    aloft_at_first(setting, lists_of(runs, met), runs, STEPS, w)
    filled = np.isfinite(w)
    assert filled.any()
    expected = states_of(setting)[0].w[filled]
    np.testing.assert_allclose(w[filled], expected, rtol=1e-11, atol=1e-15)
    for top, distance in zip(runs.top, runs.distance, strict=True):
        upstream = (top + np.arange(1, min(distance, STEPS + 1))) % w.size
        assert filled[upstream].all()
