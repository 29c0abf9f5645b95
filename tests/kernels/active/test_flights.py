"""What crosses a gap arrives decayed, and what is forgotten is zero."""

import numpy as np
import pytest

from kernels import ConstantForce
from kernels.active.balance import foresee
from kernels.active.bounds import first_bounds
from kernels.active.flights import FORGOTTEN, aloft_at_first, powers_of
from kernels.active.lists import lists_of
from kernels.active.runs import classes_of
from tests.kernels.active.given import Jump, setting_of, states_of

STEPS = 30


def test_powers_end_at_the_last_step_or_where_all_is_forgotten():
    np.testing.assert_allclose(powers_of(0.5, 4), 0.5 ** np.arange(5), rtol=1e-15)
    few = powers_of(1e-8, 1000)
    assert few.size == 5
    assert few[-1] == 0.0
    assert few[-2] > FORGOTTEN
    assert (powers_of(0.0, 3) == [1.0, 0.0]).all()


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
