"""Each step of the active-set march has the root of its balance."""

import numpy as np
import pytest

from kernels import ConstantForce, PrintedForce, lagged_slope, march
from kernels.active.march import active_march
from tests.kernels.active.given import Jump, setting_of
from tests.sizes import COMPILES_ALONE

CONTROLS = [ConstantForce, pytest.param(PrintedForce, marks=COMPILES_ALONE)]


@pytest.mark.parametrize("control", CONTROLS)
@pytest.mark.parametrize("load", [0.001, 0.1, 3.0])
def test_the_indentation_of_every_step_is_that_of_the_plain_march(control, load):
    setting, force = setting_of(Jump(0.7, 2, load, 10.0, 1.3), 120)
    steps = np.arange(1, 25)
    _, found, _, _, inside = active_march(setting, control(force), steps)
    assert inside
    weight = lagged_slope(setting.slope, setting.law.lag)
    cap = setting.z.max() + force
    _, expected, _, _ = march(
        setting.law, control(force), setting.z, weight, setting.start, steps, cap
    )
    np.testing.assert_allclose(found, expected, rtol=1e-11)
