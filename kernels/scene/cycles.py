"""Mean friction over the cycles of an oscillation, from all of their steps.

It is the ratio of the mean friction force to the mean normal force, which is the time average of mu
under a constant normal force. The mean is taken over the second half of the cycles, because the
first cycles depend on the start.
"""

from typing import NamedTuple

import numpy as np

from ..compile.jit import kernel
from ..motion.legs import Oscillation, Steps
from .scene_case import SceneCase

CYCLE_MEANS = ("mu_cycle_mean", "mu_cycle_mean_shear")


class AveragingWindow(NamedTuple):
    """Impulses of normal force and friction over consecutive steps, recorded or not."""

    after: int  # number of the step before the first step in the window
    last: int  # number of the last step in the window
    sums: np.ndarray  # of normal force, friction and its part mu, shape (3,); ratios are in h/dx


def averaging_window(scene: SceneCase, steps: Steps) -> AveragingWindow | None:
    """Return the second half of the cycles of the last oscillation, or None if not requested.

    The middle cycle of an odd number is included. Raises ValueError if no leg oscillates.
    """
    if "cycle_mean" not in scene.requested:
        return None
    legs = [(k, leg) for k, leg in enumerate(scene.programme) if isinstance(leg, Oscillation)]
    if not legs:
        raise ValueError('requested = "cycle_mean": no leg of the programme oscillates')
    number, leg = legs[-1]
    last = int(np.searchsorted(steps.leg, number, side="right"))
    ends = np.append(0.0, np.cumsum(steps.dt))[: last + 1]
    begin = ends[-1] - (leg.cycles + 1) // 2 / leg.frequency
    return AveragingWindow(int(np.argmin(np.abs(ends - begin))), last, np.zeros(3))


def cycle_mean(window: AveragingWindow | None, sheared: bool) -> dict[str, np.ndarray]:
    """Return the mean friction over the mean normal force in a window, by name, in h/dx.

    sheared : whether friction has a part by shear, which is the rest beside mu.
    """
    if window is None:
        return {}
    normal, friction, part = window.sums
    means = np.array([friction, friction - part]) / (normal if normal > 0.0 else np.nan)
    return dict(zip(CYCLE_MEANS[: 1 + sheared], means, strict=False))


@kernel
def add_impulses(window, acting, dt):
    """Add the impulses of a step; acting : its Forces."""
    window.sums[0] += dt * acting.normal
    window.sums[1] += dt * acting.friction
    if acting.normal > 0.0:
        window.sums[2] += dt * acting.normal * acting.mu
