"""The march against the element-by-element reference, and what it must conserve."""

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
    step_average,
)
from elastomer_friction.kernels.motion.stretches import touchable
from tests.convergence import observed_order
from tests.lines import random_line
from tests.reference_march import Elements, RigidElements, constants, relaxation, steady
from tests.sizes import size


class Scene(NamedTuple):
    """A line, a load and a velocity jump."""

    hurst: float
    m: int
    load: float
    speed: float
    ratio: float


# Many stretches, few, one; speeding up and slowing down; partial and full contact; the last
# three so fast that the memory of the elements reaches across the gaps.
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
]
ELEMENTS = 60


class Jump:
    """The steady state at v1 by the kernels, and the march at v2 from it."""

    def __init__(self, scene, scheme, elements=ELEMENTS, seed=3):
        self.scene, self.scheme = scene, scheme
        self.z, self.slope = random_line(elements, scene.hurst, scene.m, seed)
        self.load = scene.load * self.z.size
        self.before, self.after = (
            SCHEMES[scheme](1.0 / (scene.m * scene.speed * ratio)) for ratio in (1, scene.ratio)
        )
        self.state = self.steady(self.before)
        self.d = self.state.d
        self.weight = lagged_slope(self.slope, self.after.lag)

    def steady(self, law):
        """Return (w, d) of steady sliding."""
        return steady_sliding(law, self.z, self.load)[0]

    def march(self, kept_steps, cap=np.inf, control=ConstantForce):
        """Return (mu, indentation, inside)."""
        steps = np.asarray(kept_steps)
        mu, d, _, inside = march(
            self.after, control(self.load), self.z, self.weight, self.state, steps, cap
        )
        return mu, d, inside

    def reference(self, steps, kind=Elements):
        """Return (mu, d) of the reference, from its own steady state."""
        scene = self.scene
        dt = 1.0 / (scene.m * scene.speed)
        u, _, d = steady(self.z, scene.load, constants(self.scheme, dt)[0])
        step = constants(self.scheme, dt / scene.ratio)
        return relaxation(kind(self.z, self.slope, u, d, scene.load, step), steps)


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
    steps = round(1.2 * jump.z.size)
    mu, d = jump.reference(steps, kind)
    found_mu, found_d, inside = jump.march(
        np.arange(1, steps + 1), cap_factor * max(d.max(), jump.d), control
    )
    assert inside
    # d is a root of sums of rounded terms; forces are differences multiplied by K <= 50.
    np.testing.assert_allclose(found_d, d, rtol=1e-11)
    np.testing.assert_allclose(found_mu, mu, rtol=1e-9, atol=1e-9)


@pytest.mark.parametrize("scheme", SCHEMES)
def test_eq_3_as_printed_holds_elements_all_round_the_line(scheme):
    """Near full contact z[0] touches: the end of the line is reached straight from there."""
    jump = Jump(Scene(0.0, 1, 25.0, 30.0 / np.pi, 3.0), scheme)
    steps = 40
    mu, d = jump.reference(steps, RigidElements)
    found_mu, found_d, _ = jump.march(np.arange(1, steps + 1), np.inf, PrintedForce)
    np.testing.assert_allclose(found_d, d, rtol=1e-11)
    np.testing.assert_allclose(found_mu, mu, rtol=1e-9, atol=1e-9)


def test_the_cap_does_not_change_the_march():
    """Leaving out what cannot touch must be exact, whatever the memory."""
    jump = Jump(Scene(0.7, 1, 0.1, 100.0, 1.2), "exponential", elements=600, seed=5)
    kept_steps = np.arange(1, size(300, 60))
    mu, d, _ = jump.march(kept_steps)
    capped_mu, capped_d, inside = jump.march(kept_steps, 1.01 * d.max())
    assert inside
    np.testing.assert_allclose(capped_d, d, rtol=1e-12)
    np.testing.assert_allclose(capped_mu, mu, rtol=1e-11)


def test_scenes_cover_many_stretches_one_and_none_left_out():
    counts = []
    for scene in SCENES:
        jump = Jump(scene, "exponential")
        counts.append(touchable(jump.z, 1.01 * jump.d)[0].size)
    assert max(counts) >= 3
    assert min(counts) == 1


@pytest.mark.parametrize("control", [ConstantForce, PrintedForce])
@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("m", [1, 4])
@pytest.mark.parametrize(
    ("hurst", "load", "speed"), [(0.0, 1e-3, 0.5), (0.7, 0.1, 20.0), (1.0, 2.0, 3.0)]
)
def test_steady_sliding_stays_steady(scheme, m, hurst, load, speed, control):
    """The discrete problem is shift-invariant: d is constant, and so is the step average."""
    jump = Jump(Scene(hurst, m, load, speed, 1.0), scheme, elements=60)
    mu, d, inside = jump.march(np.arange(1, size(1000, 150) + 1), 1.01 * jump.d, control)
    assert inside
    np.testing.assert_allclose(d, jump.d, rtol=1e-12)
    expected = step_average(jump.weight, jump.z - jump.state.w, jump.d)
    np.testing.assert_allclose(mu, expected, rtol=1e-10, atol=1e-11)


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("scene", SCENES[:4], ids=str)
def test_march_ends_in_the_steady_state_of_the_new_speed(scene, scheme):
    jump = Jump(scene, scheme, elements=60)
    w, d = jump.steady(jump.after)
    # 35 tau and at least two turns of the line: e^-35 is forgotten.
    steps = 2 * jump.z.size + int(35 * scene.m * scene.speed * scene.ratio)
    mu, found, _ = jump.march([1, steps], 1.2 * max(d, jump.d))
    assert found[1] == pytest.approx(d, rel=1e-11)
    assert mu[1] == pytest.approx(step_average(jump.weight, jump.z - w, d), rel=1e-9, abs=1e-10)
    assert abs(found[0] / d - 1.0) > 1e-9  # it was not there from the start


def test_only_the_recorded_steps_are_kept_and_arguments_left_alone():
    jump = Jump(SCENES[3], "exponential", elements=60)
    arguments = (jump.z, jump.weight, jump.state.w)
    copies = [argument.copy() for argument in arguments]
    every, some = jump.march(np.arange(1, 101)), jump.march([1, 7, 64, 100])
    np.testing.assert_array_equal(some[:2], np.array(every[:2])[:, [0, 6, 63, 99]])
    for before, now in zip(copies, arguments, strict=True):
        np.testing.assert_array_equal(before, now)


def test_a_cap_that_is_reached_is_reported():
    jump = Jump(Scene(0.7, 2, 0.3, 3.0, 0.2), "exponential", elements=60)  # slower: d grows
    _, d, inside = jump.march(np.arange(1, 200))
    assert inside
    assert d.max() > 1.05 * jump.d
    assert not jump.march(np.arange(1, 200), 1.02 * jump.d)[2]


FEW_ELEMENTS, LOAD, SPEED, RATIO, DURATION = 40, 0.05, 1.0, 1.3, 5  # duration in spacings
SEEDS = range(4)
REFINEMENTS = np.array([4, 8, 16, 32])[: size(4, 3)]


def displacements(z, slope, m, scheme):
    """Yield the displacements of all elements (reference) before and after each step."""
    u, _, d = steady(z, LOAD, constants(scheme, 1.0 / (m * SPEED))[0])
    step = constants(scheme, 1.0 / (m * SPEED * RATIO))
    elements = Elements(z, slope, u, d, LOAD, step)
    yield u
    for _ in range(DURATION * m):
        elements.advance()
        yield elements.u


def work(z, slope, m, scheme):
    """Return the work done on the line per element, from mu and d of the kernels."""
    before, after = (SCHEMES[scheme](1.0 / (m * SPEED * r)) for r in (1.0, RATIO))
    load = LOAD * z.size
    state, _ = steady_sliding(before, z, load)
    weight = lagged_slope(slope, after.lag)
    kept_steps = np.arange(1, DURATION * m + 1)
    mu, depth, _, _ = march(after, ConstantForce(load), z, weight, state, kept_steps, np.inf)
    return LOAD * (mu.sum() / m + depth[-1] - state.d)  # v dt = dx / m


def imbalance(m, seed, scheme):
    """Return (work - elastic - dissipated) / dissipated over the time after the jump."""
    z, slope = random_line(FEW_ELEMENTS, 1.0, m, seed)
    u = np.array(list(displacements(z, slope, m, scheme)))
    elastic = 0.5 * (np.mean(u[-1] ** 2) - np.mean(u[0] ** 2))
    dissipated = np.sum(np.mean(np.diff(u, axis=0) ** 2, axis=1)) * m * SPEED * RATIO
    return (work(z, slope, m, scheme) - elastic - dissipated) / dissipated


@pytest.mark.parametrize("scheme", SCHEMES)
def test_work_is_stored_or_dissipated(scheme):
    """First order: u' is discontinuous where an element meets the line within a step."""
    errors = np.array([[imbalance(m, seed, scheme) for seed in SEEDS] for m in REFINEMENTS])
    assert observed_order(REFINEMENTS, errors) > 0.8  # nominal 1; random edges scatter
    # Error constant about 0.16 / m (measured); a missing term would leave all of its share.
    assert np.sqrt(np.mean(errors[-1] ** 2)) < 0.3 / REFINEMENTS[-1]
