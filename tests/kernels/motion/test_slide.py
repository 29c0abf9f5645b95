"""Sliding and tracks: positions of the elements after every step, and their displacements."""

import numpy as np
import pytest

from elastomer_friction.kernels import Kelvin, State, amplitudes, draw_phases, sample_line
from elastomer_friction.kernels.lines.self_affine import mode_numbers
from elastomer_friction.kernels.motion import track as module
from elastomer_friction.kernels.motion.fourier import FourierShift
from elastomer_friction.kernels.motion.legs import Hold, Oscillation, Slide, steps_of
from elastomer_friction.kernels.motion.slide import (
    SHORT_GAP,
    gather,
    piece_bounds,
    shift,
    start_rings,
    touchable,
)
from elastomer_friction.kernels.motion.track import tracks
from tests.lines import random_line


def test_stretches_cover_exactly_what_can_touch():
    z, _ = random_line(400, 0.2, 1, seed=2)
    for cap in np.quantile(z, [0.005, 0.02, 0.3, 0.9]):
        start, stop = touchable(z, cap)
        inside = np.zeros(z.size, bool)
        for a, b in zip(start, stop, strict=True):
            inside[a:b] = True
            assert z[a] < cap
            assert z[b - 1] < cap
        assert np.all(z[~inside] >= cap)
        assert np.all(start[1:] - stop[:-1] > SHORT_GAP)
    start, stop = touchable(z, np.inf)
    assert (start.tolist(), stop.tolist()) == ([0], [z.size])


@pytest.mark.parametrize("gap", [SHORT_GAP, SHORT_GAP + 1])
def test_a_gap_is_left_out_from_one_sample_beyond_a_short_one(gap):
    z = np.concatenate([np.ones(40), np.zeros(2), np.ones(gap), np.zeros(3)])
    start, stop = touchable(z, 0.5)
    if gap == SHORT_GAP:
        assert (start.tolist(), stop.tolist()) == ([40], [z.size])
    else:
        assert (start.tolist(), stop.tolist()) == ([40, 42 + gap], [42, z.size])


LAW = Kelvin(0.97, 1.0 / 0.03, 0.5)
ELEMENTS, STEPS = 400, 450  # more than one period
CAPS = {"few": 0.01, "pieces": 0.1, "half": 0.5, "all": 1.0}  # share of the line below the cap


def sliding(z, state, cap, depth):
    """Yield (thresholds, heights) at all samples that can touch, for each step at given depths."""
    start, stop = touchable(z, cap)
    first, rings = piece_bounds(stop - start), start_rings(LAW, z, state, start, stop)
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
    """Return (line, state without contact, cap); share : of the line below the cap."""
    z, _ = random_line(ELEMENTS, 0.0, 1, seed=2)
    w = np.random.default_rng(3).uniform(-1.0, 0.0, ELEMENTS)
    return z, State(w, -10.0), np.quantile(z, share) if share < 1.0 else np.inf


@pytest.fixture(params=CAPS)
def scene(request):
    """Return the scene for one cap."""
    return scene_of(CAPS[request.param])


def test_what_decays_away_in_a_gap_is_zero_and_no_subnormal_number():
    z, state, cap = scene_of(CAPS["few"])
    rings = start_rings(Kelvin(1e-12, 1.0, 0.5), z, state, *touchable(z, cap))
    np.testing.assert_array_equal(rings.crossing, 0.0)
    assert np.abs(rings.slots[rings.slots != 0.0]).min() > 1e-210


def test_elements_that_touched_go_on_from_the_line(scene):
    """The reference steps every element in a loop, without stretches or rings."""
    z, state, cap = scene
    highest = min(cap, z.max())

    def depth(step):
        return highest * (0.5 + 0.4 * np.sin(0.7 * step))

    at, u = where(z, cap), np.minimum(state.w, z - state.d)  # at the samples of the line
    touched = 0
    for step, (c, low) in enumerate(sliding(z, state, cap, depth), 1):
        w = LAW.decay * np.roll(u, -1)
        # In short gaps, heights above the cap are replaced by the cap.
        np.testing.assert_allclose((low - c)[z[at] < cap], w[at][z[at] < cap], atol=1e-12)
        u = np.minimum(w, z - depth(step))
        touched += np.sum(u < w)
    assert touched > 100


@pytest.mark.parametrize("fraction", [0.3, 0.5, 1.0])
@pytest.mark.parametrize(("elements", "m"), [(16, 1), (16, 3), (15, 1)])
def test_the_shift_is_that_of_every_mode(elements, m, fraction):
    """With one sample per spacing, a line of even length has a wave of two samples."""
    phases = draw_phases(np.random.default_rng(1), elements)
    amplitude = amplitudes(0.5, elements)
    q = 2.0 * np.pi * mode_numbers(elements) / elements
    at = np.outer((np.arange(elements * m) - fraction) / m, q) + phases
    z, slope = FourierShift(*sample_line(amplitude, phases, elements, m), m).by(fraction)
    np.testing.assert_allclose(z, np.cos(at) @ amplitude, atol=1e-13)
    np.testing.assert_allclose(slope, -np.sin(at) @ (amplitude * q), atol=1e-13)


PROGRAMME = (Slide(1.0, 3.3), Hold(1.0), Oscillation(0.0, 0.2, 0.3, 1), Slide(-2.0, 5.0))


def lines(z, slope, m, steps, start):
    """Return heights and slopes after every step, concatenated over all stages."""
    rows = []
    for track in tracks(z, slope, m, steps, start, 1.5):
        for s in range(0 if not rows else 1, track.dt.size + 1):
            begin = track.begin[s]
            rows.append([v[track.line[s], begin : begin + z.size] for v in (track.z, track.slope)])
    return np.array(rows)


def test_whole_samples_are_the_line_itself_read_from_elsewhere():
    z, slope = random_line(20, 0.7, 2, seed=1)
    steps = steps_of((Slide(1.0, 12.0), Slide(-1.0, 30.0)), 2)
    actual = lines(z, slope, 2, steps, 0.0)
    for row, place in zip(actual, np.append(0.0, steps.position), strict=True):
        np.testing.assert_array_equal(row, [np.roll(v, int(place)) for v in (z, slope)])


def test_fractions_are_shifted_and_stages_do_not_show(monkeypatch):
    z, slope = random_line(20, 0.7, 2, seed=1)
    steps = steps_of(PROGRAMME, 2, 0.4)
    actual = lines(z, slope, 2, steps, 0.4)
    shifted = FourierShift(z, slope, 2)
    for row, place in zip(actual, np.append(0.4, steps.position), strict=True):
        whole = int(np.floor(place))
        expected = [np.roll(v, whole) for v in shifted.by(place - whole)]
        np.testing.assert_allclose(row, expected, atol=1e-14)
    monkeypatch.setattr(module, "MAX_SHIFTED_LINES", 3)
    assert len(list(tracks(z, slope, 2, steps, 0.4, 1.5))) > 10
    np.testing.assert_array_equal(lines(z, slope, 2, steps, 0.4), actual)
