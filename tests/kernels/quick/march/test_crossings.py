"""What crosses a gap arrives decayed, and what is forgotten is zero."""

import numpy as np
import pytest

from elastomer_friction.kernels import ConstantForce
from elastomer_friction.kernels.quick.march.bounds import first_bounds
from elastomer_friction.kernels.quick.march.crossings import (
    FORGOTTEN,
    Steady,
    arrivals_of,
    launch,
    powers_of,
)
from elastomer_friction.kernels.quick.march.lists import lists_of
from elastomer_friction.kernels.quick.march.load_balance import foresee
from elastomer_friction.kernels.quick.march.runs import classes_of
from tests.kernels.quick.march.given import Jump, setting_of, states_of

STEPS = 30


def test_powers_end_at_the_last_step_or_where_all_is_forgotten():
    np.testing.assert_allclose(powers_of(0.5, 4), 0.5 ** np.arange(5), rtol=1e-15)
    few = powers_of(1e-8, 1000)
    assert few.size == 5
    assert few[-1] == 0.0
    assert few[-2] > FORGOTTEN
    assert (powers_of(0.0, 3) == [1.0, 0.0]).all()


@pytest.mark.parametrize("load", [1e-3, 0.1, 1.0])
def test_at_first_those_arrive_who_are_aloft_in_steady_sliding(load):
    setting, force = setting_of(Jump(0.5, 4, load, 10.0, 1.2), 120)
    bounds = first_bounds(setting, foresee(ConstantForce(force), setting), 0.1)
    runs, met, _ = classes_of(setting, bounds)
    rest = setting.law, lists_of(runs, met), runs
    state = states_of(setting)[0]
    steady = Steady(setting.start.decay.once, setting.start.d)
    _, found = arrivals_of(*rest, steady, setting.z, STEPS)
    _, expected = arrivals_of(*rest, state, setting.z, STEPS)
    assert found.values.size > STEPS
    np.testing.assert_allclose(found.values, expected.values, rtol=1e-11, atol=1e-15)
    np.testing.assert_array_equal(found.begin, expected.begin)


def test_what_is_aloft_arrives_after_the_samples_between_decayed_at_the_new_speed():
    values = np.full(6, np.nan)
    powers = powers_of(0.5, 10)
    launch(Steady(0.8, 0.1), values, 1, 5, powers, values, 7, 6, -1.0)
    assert np.isnan(values[[0, 5]]).all()
    expected = [-(0.5**k) * 0.8 ** (6 - k) for k in (1, 2, 3, 4)]  # k samples upstream of the run
    np.testing.assert_allclose(values[1:5], expected, rtol=1e-14)
