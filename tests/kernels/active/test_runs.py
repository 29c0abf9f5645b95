"""What is said to touch always does, what is said never to touch never does."""

import numpy as np
import pytest

from kernels import SCHEMES, solve_indentation
from kernels.active.bounds import first_bounds, first_indentation, holds
from kernels.active.runs import classes_of
from kernels.active.setting import advance
from tests.kernels.active.given import Jump, setting_of
from tests.sizes import size

NEVER, LISTED, ALWAYS = range(3)


def classes(setting, bounds):
    """Return the class of every sample."""
    runs, stretches = classes_of(setting, bounds)
    found = np.full(setting.z.size, NEVER)
    for start, stop in zip(*stretches, strict=True):
        found[start:stop] = ALWAYS
    for bottom, top in zip(runs.bottom, runs.top, strict=True):
        assert (found[bottom : top + 1] == NEVER).all()
        found[bottom : top + 1] = LISTED
    for top, distance, sure in zip(runs.top, runs.distance, runs.sure, strict=True):
        between = (top + np.arange(1, distance)) % found.size
        assert (found[between] == NEVER).all()
        above = found[(top + distance) % found.size]
        assert above == LISTED or (sure and above == ALWAYS)
    return found


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("ratio", [0.4, 1.2, 2.5])
@pytest.mark.parametrize("hurst", [0.0, 0.7])
def test_classes_hold_as_long_as_bounds_do(hurst, ratio, scheme):
    seen = np.zeros(3, int)
    for load, x in ((1e-3, 0.3), (0.03, 30.0), (0.5, 3.0), (5.0, 100.0), (25.0, 3.0)):
        for margin in (0.1, 1.0):
            setting, force = setting_of(Jump(hurst, 4, load, x, ratio, scheme), size(80, 30))
            law, d = setting.law, setting.start.d
            bounds = first_bounds(setting, first_indentation(setting, force), margin)
            found = classes(setting, bounds)
            seen += np.bincount(found, minlength=3)
            u = np.minimum(setting.start.w, setting.z - d)
            for _ in range(size(100, 20)):
                w, old = law.decay * np.roll(u, -1), d
                d, _ = solve_indentation(setting.z - w, force / law.stiffness, d)
                if not holds(bounds, d, advance(law, d, old)):
                    break
                touching = setting.z - w < d
                assert touching[found == ALWAYS].all()
                assert not touching[found == NEVER].any()
                u = np.minimum(w, setting.z - d)
    assert (seen > 0).all()
