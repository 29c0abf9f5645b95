"""Settings of velocity jumps that the tests of the active-set march share."""

from typing import NamedTuple

import numpy as np

from kernels import (
    SCHEMES,
    ConstantForce,
    lagged_slope,
    march,
    quadrature,
    steady_sliding,
    step_average,
)
from kernels.active.setting import Setting
from tests.lines import random_line


class Jump(NamedTuple):
    """A velocity jump on a line that is given or random."""

    hurst: float
    m: int
    load: float
    x: float  # pi vbar
    ratio: float
    scheme: str = "exponential"


def setting_of(jump, elements, seed=1, line=None):
    """Return (setting, load)."""
    z, slope = random_line(elements, jump.hurst, jump.m, seed) if line is None else line
    load = jump.load * z.size
    laws = [SCHEMES[jump.scheme](np.pi / (jump.m * jump.x * r)) for r in (1.0, jump.ratio)]
    return Setting(z, slope, *laws, *(steady_sliding(law, z, load)[0] for law in laws)), load


def size_of_jump(setting, jump, load):
    """Return the change of mu when the speed changes."""
    v = jump.x / np.pi
    before, after = (
        quadrature(setting.z, setting.slope, *setting.start, v, speed, load)[0]
        for speed in (v, v * jump.ratio)
    )
    return abs(after - before)


def dense(setting, load, kept_steps):
    """Return (deviation of mu from its steady value at v2, indentation) of the plain march."""
    law, (w, d) = setting.law, setting.end
    weight = lagged_slope(setting.slope, law.lag)
    # Samples that cannot touch are left out: the digits of small displacements would be lost.
    for cap in (1.02 * max(setting.start.d, d), 1.001 * max(setting.start.d, load)):
        mu, found, _, inside = march(
            law, ConstantForce(load), setting.z, weight, setting.start, kept_steps, cap
        )
        if inside:
            break
    assert inside
    return mu - step_average(weight, setting.z - w, d), found


def rounding_of_mu(setting, load):
    """Return what rounding leaves open of mu: of the overlaps, differences of heights."""
    w, d = setting.end
    touching = (setting.z - w < d).sum()
    overlap = load / setting.law.stiffness / touching
    share = 1e-16 * (setting.z.max() + d) / overlap
    return (1e-14 + 2.0 * share) * np.abs(setting.slope).max()
