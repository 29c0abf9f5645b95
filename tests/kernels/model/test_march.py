"""Steady sliding and the march against an element-by-element reference, with and without a cap."""

from typing import NamedTuple

import numpy as np
import pytest

from elastomer_friction.kernels import (
    SCHEMES,
    ConstantForce,
    PrintedForce,
    lagged_slope,
    march,
    steady_sliding,
)
from tests.lines import random_line
from tests.reference_march import Elements, RigidElements, constants, relaxation, steady


class Scene(NamedTuple):
    """A line, a load and a velocity jump."""

    hurst: float
    m: int
    load: float
    speed: float
    ratio: float


# Many stretches, few, or one; faster and slower; partial and full contact; and speeds at which the
# memory of the elements reaches across the gaps.
SCENES = [
    Scene(0.0, 4, 0.01, 0.15, 1.3),
    Scene(0.0, 3, 5e-3, 0.2, 0.8),
    Scene(0.3, 4, 0.02, 0.15, 0.7),
    Scene(0.7, 4, 0.3, 0.3, 1.2),
    Scene(0.7, 1, 1e-4, 1.0, 2.0),
    Scene(1.0, 2, 60.0, 3.0, 1.2),
    Scene(0.0, 1, 60.0, 20.0, 0.8),
    Scene(0.3, 1, 0.3, 20.0, 1.2),
    Scene(0.7, 1, 0.1, 40.0, 0.8),
    Scene(0.0, 2, 0.5, 6.0, 1.5),
    Scene(0.0, 1, 25.0, 30.0 / np.pi, 3.0),  # z[0] touches: contact across the end of the period
]
ELASTIC = Scene(0.7, 1, 0.05, 2e-3, 1.2)  # elements relax by e^-500 in a step


class Jump:
    """The steady state at v1, computed by the kernels, and the march at v2 that starts from it."""

    def __init__(self, scene, scheme):
        self.scene, self.scheme = scene, scheme
        self.z, self.slope = random_line(60, scene.hurst, scene.m, 3)
        self.load = scene.load * self.z.size
        before, self.after = (
            SCHEMES[scheme](1.0 / (scene.m * scene.speed * ratio)) for ratio in (1, scene.ratio)
        )
        self.state, self.sweeps = steady_sliding(before, self.z, self.load)

    def march(self, kept_steps, cap=np.inf, control=ConstantForce):
        """Return (mu, indentation, inside)."""
        weight = lagged_slope(self.slope, self.after.lag)
        mu, d, _, inside = march(
            self.after, control(self.load), self.z, weight, self.state, kept_steps, cap
        )
        return mu, d, inside

    def reference(self):
        """Return (u, w, d) of steady sliding, and the constants of a step after the jump."""
        dt = 1.0 / (self.scene.m * self.scene.speed)
        steps = (constants(self.scheme, dt / ratio) for ratio in (1, self.scene.ratio))
        (decay, *_), after = steps
        return steady(self.z, self.scene.load, decay), after


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("scene", [*SCENES, ELASTIC], ids=str)
def test_steady_sliding_is_that_of_an_element_carried_round_the_line(scene, scheme):
    jump = Jump(scene, scheme)
    (u, w, d), _ = jump.reference()
    # The reference bisects to one ulp; its force loses digits with the stiffness, at most 150.
    assert jump.state.d == pytest.approx(d, rel=1e-12)
    np.testing.assert_allclose(jump.state.w, w, atol=1e-12 * max(1.0, d))
    actual = np.minimum(jump.state.w, jump.z - jump.state.d)
    np.testing.assert_allclose(actual, u, atol=1e-12 * max(1.0, d))
    assert jump.sweeps <= 10


@pytest.mark.parametrize(
    ("control", "kind", "cap_factor"),
    [
        (ConstantForce, Elements, np.inf),
        (ConstantForce, Elements, 1.01),
        (PrintedForce, RigidElements, np.inf),
    ],
)
@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("scene", SCENES, ids=str)
def test_march_is_the_reference_march(scene, scheme, control, kind, cap_factor):
    jump = Jump(scene, scheme)
    (u, _, start), step = jump.reference()
    steps = round(1.2 * jump.z.size)
    mu, d = relaxation(kind(jump.z, jump.slope, u, start, scene.load, step), steps)
    kept = np.arange(1, steps + 1, 2)
    cap = cap_factor * max(d.max(), start)
    found_mu, found_d, inside = jump.march(kept, cap, control)
    assert inside
    # d is the root of a sum of rounded terms; forces are differences multiplied by K <= 50.
    np.testing.assert_allclose(found_d, d[kept - 1], rtol=1e-11)
    np.testing.assert_allclose(found_mu, mu[kept - 1], rtol=1e-9, atol=1e-9)


def test_a_cap_that_is_reached_is_reported():
    jump = Jump(Scene(0.7, 2, 0.3, 3.0, 0.2), "exponential")  # at a lower speed d grows
    _, d, inside = jump.march(np.arange(1, 200))
    assert inside
    assert d.max() > 1.05 * jump.state.d
    assert not jump.march(np.arange(1, 200), 1.02 * jump.state.d)[2]
