"""Bounds hold what they are made of; what is said to touch always does, and what never to never."""

import numpy as np
import pytest

from elastomer_friction.kernels import SCHEMES, ConstantForce, lagged_slope, solve_indentation
from elastomer_friction.kernels.quick.march.bounds import (
    are_within,
    bounds_of,
    first_bounds,
)
from elastomer_friction.kernels.quick.march.crossings import Steady, arrivals_of
from elastomer_friction.kernels.quick.march.given import a_of, advance
from elastomer_friction.kernels.quick.march.lists import add_sample, add_span, lists_of
from elastomer_friction.kernels.quick.march.load_balance import FEW, foresee, overlap_of
from elastomer_friction.kernels.quick.march.narrow import closer_bounds
from elastomer_friction.kernels.quick.march.runs import classes_of
from elastomer_friction.kernels.quick.steady.spans import SPAN, add_rises
from tests.kernels.quick.march.given import Jump, dense, setting_of, states_of
from tests.kernels.quick.steady.given import spans_of
from tests.sizes import size

LAW = SCHEMES["exponential"](0.3)


@pytest.mark.parametrize("margin", [0.1, 2.0])
def test_what_they_are_made_of_lies_within_and_what_is_farther_out_does_not(margin):
    found = bounds_of(LAW, 2.0, 3.0, 0.6, 0.9, margin)
    for d, push in ((2.0, 0.6), (3.0, 0.9), (2.5, 2.5 / LAW.stiffness)):
        assert are_within(found, d, push)
    assert not are_within(found, 3.0 + 1.01 * margin, 0.7)
    assert not are_within(found, np.nan, 0.7)
    assert not are_within(found, 2.5, np.nan)


@pytest.mark.parametrize("room", [0.0, 0.5, 5.0])
def test_closer_ones_leave_room_but_never_go_beyond(room):
    """Their own margin is 0.6 of the spread between what was seen, here 2.5, and the end, 2.75."""
    outer = bounds_of(LAW, 1.0, 3.0, 0.2, 0.9, 0.4)
    seen = bounds_of(LAW, 2.5, 2.5, 0.6, 0.6, 0.0)
    found = closer_bounds(LAW, outer, seen, 2.75, (room, 0.01 * room))
    assert found.high == pytest.approx(max(2.75 + 0.6 * 0.25, min(2.75 + room, outer.high)))
    assert found.high <= outer.high
    assert found.low >= outer.low
    assert found.most >= min(0.6 + 0.01 * room, outer.most)
    assert are_within(found, 2.75, 0.6)


@pytest.mark.parametrize("ratio", [0.7, 1.2])
@pytest.mark.parametrize(("load", "x"), [(0.01, 10.0), (0.3, 10.0), (0.5, 1.0), (2.0, 3.0)])
def test_the_first_step_is_foreseen_and_lies_within_the_first_bounds(load, x, ratio):
    setting, load = setting_of(Jump(0.7, 4, load, x, ratio), 200)
    guess = foresee(ConstantForce(load), setting)
    _, (d,) = dense(setting, load, np.array([1]))
    assert 0.9 < (guess - setting.start.d) / (d - setting.start.d) < 1.7
    found = first_bounds(setting, guess, 0.05)
    assert are_within(found, d, advance(setting.law, d, setting.start.d))


def test_no_digits_are_lost_where_hardly_anything_decays():
    law = SCHEMES["exponential"](1e-12)
    assert advance(law, 5.0, 5.0) == pytest.approx(5.0 / law.stiffness, rel=1e-15)


@pytest.mark.parametrize("size", [0, 5, FEW - 1, FEW, FEW + 39])
def test_overlaps_are_those_of_the_touching_elements(size):
    c = np.random.default_rng(5).standard_normal(size)
    depth, count = overlap_of(c, 0.2)
    assert depth == pytest.approx(np.maximum(0.2 - c, 0.0).sum(), rel=1e-12)
    assert count == np.count_nonzero(c < 0.2)


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


@pytest.mark.parametrize("hurst", [0.0, 1.0])
def test_a_span_is_its_samples_round_the_period(hurst):
    setting, _ = setting_of(Jump(hurst, 4, 0.5, 10.0, 1.2), 4 * SPAN)
    z, level = setting.z + 7.0, 0.4
    setting = setting._replace(z=z, spans=spans_of(z, setting.slope))
    add_rises(setting.spans.rows, z, setting.slope)
    a = a_of(setting.law, z, np.roll(z, -1))
    weight = lagged_slope(setting.slope, setting.law.lag)
    for b in (0, 3, z.size // SPAN - 1):
        own = slice(b * SPAN, (b + 1) * SPAN)
        whole, one_by_one = np.zeros(4), np.zeros(4)
        add_span(setting, level, b, whole)
        for j in range(own.start, own.stop):
            add_sample(level - a[j], weight[j], one_by_one)
        each = level - a[own]
        expected = [SPAN, each.sum(), weight[own].sum(), each @ weight[own]]
        scale = np.abs(each).sum() * np.abs(weight[own]).max()
        np.testing.assert_allclose(whole, expected, rtol=1e-11, atol=1e-13 * scale)
        np.testing.assert_allclose(one_by_one, expected, rtol=1e-11, atol=1e-13 * scale)


@pytest.mark.parametrize("load", [1e-3, 0.1, 1.0])
def test_at_first_those_arrive_who_are_aloft_in_steady_sliding(load):
    setting, force = setting_of(Jump(0.5, 4, load, 10.0, 1.2), 120)
    bounds = first_bounds(setting, foresee(ConstantForce(force), setting), 0.1)
    runs, met, _ = classes_of(setting, bounds)
    rest = setting.law, lists_of(runs, met), runs
    steady = Steady(setting.start.decay.once, setting.start.d)
    _, found = arrivals_of(*rest, steady, setting.z, 30)
    _, expected = arrivals_of(*rest, states_of(setting)[0], setting.z, 30)
    assert found.values.size > 30
    np.testing.assert_allclose(found.values, expected.values, rtol=1e-11, atol=1e-15)
    np.testing.assert_array_equal(found.begin, expected.begin)
