"""Marks say never and always only where it is so all along the march."""

import numpy as np
import pytest

from kernels import ConstantForce, lagged_slope, march
from kernels.active.bounds import first_bounds, first_indentation
from kernels.active.marks import ALWAYS, FREE, levels_of, marks_of
from tests.kernels.active.given import Jump, setting_of


@pytest.mark.parametrize("load", [0.01, 0.3, 3.0])
@pytest.mark.parametrize("ratio", [0.6, 1.2])
def test_never_and_always_are_true_at_every_step(load, ratio):
    setting, force = setting_of(Jump(0.5, 4, load, 10.0, ratio), 150)
    z, law = setting.z, setting.law
    bounds = first_bounds(setting, first_indentation(setting, force), 0.5)
    marks = marks_of(setting, bounds, levels_of(setting, bounds))[: z.size]
    weight = lagged_slope(setting.slope, law.lag)
    most = np.arange(1, 30)
    _, found, _, inside = march(
        law, ConstantForce(force), z, weight, setting.start, most, z.max() + force
    )
    assert inside
    w, d = setting.start.w.copy(), setting.start.d
    before = z - w < d
    for new in found:
        w = law.decay * np.roll(np.minimum(w, z - d), -1)
        touching = z - w < new
        assert not touching[marks == FREE].any()
        assert touching[(marks == ALWAYS) & np.roll(before, -1)].all()
        d, before = new, touching
