"""What is said of whole spans, and of the first sample, is so all along the march."""

import numpy as np
import pytest

from elastomer_friction.kernels import ConstantForce, lagged_slope, march
from elastomer_friction.kernels.quick.march.bounds import first_bounds
from elastomer_friction.kernels.quick.march.load_balance import foresee
from elastomer_friction.kernels.quick.march.span_kinds import (
    ALWAYS,
    FREE,
    always,
    kind_of_first,
    levels_of,
    never,
)
from elastomer_friction.kernels.quick.steady.spans import SPAN
from tests.kernels.quick.march.given import Jump, setting_of, states_of
from tests.sizes import size


@pytest.mark.parametrize("load", [0.01, 0.3, 3.0, 25.0])
@pytest.mark.parametrize("ratio", [0.6, 1.2])
def test_never_and_always_are_true_at_every_step(load, ratio):
    setting, force = setting_of(Jump(0.9, 8, load, 1.0, ratio), size(150, 40))
    z, law = setting.z, setting.law
    bounds = first_bounds(setting, foresee(ConstantForce(force), setting), 0.5)
    levels = levels_of(setting, bounds)
    spans = range(z.size // SPAN)
    none = np.repeat([never(setting, bounds, levels, b) for b in spans], SPAN)
    stay = np.repeat([always(setting, bounds, b) for b in spans], SPAN)
    assert none.any() or load > 1.0
    assert stay.any() or load < 1.0
    first = kind_of_first(setting, bounds, levels)
    weight, most = lagged_slope(setting.slope, law.lag), np.arange(1, 30)
    w, d = states_of(setting)[0]
    start = states_of(setting)[0]
    _, found, _, inside = march(law, ConstantForce(force), z, weight, start, most, z.max() + force)
    assert inside
    before = z - w < d
    for new in found:
        w = law.decay * np.roll(np.minimum(w, z - d), -1)
        touching = z - w < new
        assert not touching[: none.size][none].any()
        held = stay & np.roll(before, -1)[: stay.size]
        assert touching[: stay.size][held].all()
        assert not (first == FREE and touching[0])
        assert touching[0] or not (first == ALWAYS and before[1])
        d, before = new, touching
