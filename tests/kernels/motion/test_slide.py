"""Sliding by whole samples: where every element is, and what is left of it, after any way."""

import numpy as np
import pytest

from elastomer_friction.kernels import Kelvin, State
from elastomer_friction.kernels.motion.slide import shift, start_rings
from elastomer_friction.kernels.motion.stretches import bounds, gather, touchable
from tests.lines import random_line

LAW = Kelvin(0.97, 1.0 / 0.03, 0.5)
ELEMENTS, STEPS = 400, 450  # more than once round
CAPS = {"few": 0.01, "pieces": 0.1, "half": 0.5, "all": 1.0}  # share of the line below


def sliding(z, state, cap, depth):
    """Yield the thresholds, at all samples that can touch, of each step at given depths."""
    start, stop = touchable(z, cap)
    first, rings = bounds(stop - start), start_rings(LAW, z, state, start, stop)
    low = np.minimum(gather(z, start, stop), cap)
    c, d = low - gather(state.w, start, stop), state.d
    for step in range(1, STEPS + 1):
        shift(LAW, low, c, d, first, rings, step)
        d = depth(step)
        yield c.copy(), low


def where(z, cap):
    """Return the samples that can touch."""
    start, stop = touchable(z, cap)
    return np.concatenate([np.arange(a, b) for a, b in zip(start, stop, strict=True)])


def scene_of(share):
    """Return a line, a state without contact, a cap."""
    z, _ = random_line(ELEMENTS, 0.0, 1, seed=2)
    w = np.random.default_rng(3).uniform(-1.0, 0.0, ELEMENTS)
    return z, State(w, -10.0), np.quantile(z, share) if share < 1.0 else np.inf


@pytest.fixture(params=CAPS)
def scene(request):
    """Return the scene of one cap."""
    return scene_of(CAPS[request.param])


def test_the_caps_leave_one_piece_and_several():
    counts = [touchable(z, cap)[0].size for z, _, cap in map(scene_of, CAPS.values())]
    assert max(counts) >= 5
    assert min(counts) == 1


def test_elements_that_never_touch_decay_and_pass_by(scene):
    """After k steps the element of sample j + k is at sample j, its displacement times E^k."""
    z, state, cap = scene
    at = where(z, cap)
    for k, (c, low) in enumerate(sliding(z, state, cap, lambda _: -10.0), 1):
        expected = LAW.decay**k * state.w[(at + k) % ELEMENTS]
        np.testing.assert_allclose(low - c, expected, rtol=1e-12, atol=1e-14)


def test_what_decays_away_in_a_gap_is_zero_and_no_subnormal_number():
    z, state, cap = scene_of(CAPS["few"])
    rings = start_rings(Kelvin(1e-12, 1.0, 0.5), z, state, *touchable(z, cap))
    np.testing.assert_array_equal(rings.crossing, 0.0)
    assert np.abs(rings.slots[rings.slots != 0.0]).min() > 1e-210


def test_elements_that_touched_go_on_from_the_line(scene):
    """Every element is carried in a loop of its own, with no stretch and no ring."""
    z, state, cap = scene
    highest = min(cap, z.max())

    def depth(step):
        return highest * (0.5 + 0.4 * np.sin(0.7 * step))

    at, u = where(z, cap), np.minimum(state.w, z - state.d)  # by sample of the line
    touched = 0
    for step, (c, low) in enumerate(sliding(z, state, cap, depth), 1):
        w = LAW.decay * np.roll(u, -1)
        # What lies above the cap in short gaps is carried along as if it lay at the cap.
        np.testing.assert_allclose((low - c)[z[at] < cap], w[at][z[at] < cap], atol=1e-12)
        u = np.minimum(w, z - depth(step))
        touched += np.sum(u < w)
    assert touched > 100
