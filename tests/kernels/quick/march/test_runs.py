"""What is said to touch always does, what is said never to touch never does."""

import numpy as np
import pytest

from elastomer_friction.kernels import SCHEMES, ConstantForce, solve_indentation
from elastomer_friction.kernels.quick.march.bounds import are_within, first_bounds
from elastomer_friction.kernels.quick.march.given import advance
from elastomer_friction.kernels.quick.march.load_balance import foresee
from elastomer_friction.kernels.quick.march.runs import classes_of
from tests.kernels.quick.march.given import Jump, setting_of, states_of
from tests.sizes import size


def listed_of(runs, touching):
    """Return which samples are listed. touching : at some moment within the bounds."""
    found = np.zeros(touching.size, bool)
    for bottom, top in zip(runs.bottom, runs.top, strict=True):
        assert not found[bottom : top + 1].any()
        found[bottom : top + 1] = True
    for top, distance, sure in zip(runs.top, runs.distance, runs.sure, strict=True):
        between = (top + np.arange(1, distance)) % found.size
        assert not (found | touching)[between].any()
        above = (top + distance) % found.size
        assert touching[above] if sure else found[above]
    return found


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("ratio", [0.4, 1.2, 2.5])
@pytest.mark.parametrize("hurst", [0.0, 0.7])
def test_classes_hold_as_long_as_bounds_do(hurst, ratio, scheme):
    seen = np.zeros(3, int)  # samples that never touch, always do, are listed
    for load, x in ((1e-3, 0.3), (0.03, 30.0), (0.5, 3.0), (5.0, 100.0), (25.0, 3.0)):
        for margin in (0.1, 1.0):
            setting, force = setting_of(Jump(hurst, 4, load, x, ratio, scheme), size(80, 30))
            law, d = setting.law, setting.start.d
            bounds = first_bounds(setting, foresee(ConstantForce(force), setting), margin)
            runs, met, sums = classes_of(setting, bounds)
            w = states_of(setting)[0].w
            before = setting.z - w < d
            listed = listed_of(runs, before)
            assert listed.sum() == met.z.size
            assert (before & ~listed).sum() == sums.samples
            seen += [(~before & ~listed).sum(), int(sums.samples), met.z.size]
            u = np.minimum(w, setting.z - d)
            for _ in range(size(100, 20)):
                w, old = law.decay * np.roll(u, -1), d
                d, _ = solve_indentation(setting.z - w, force / law.stiffness, d)
                if not are_within(bounds, d, advance(law, d, old)):
                    break
                assert ((setting.z - w < d) == before)[~listed].all()
                u = np.minimum(w, setting.z - d)
    assert (seen > 0).all()
