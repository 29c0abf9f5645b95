"""What is said of spans and samples is so all along the march; lists and sums are what touches."""

import numpy as np
import pytest

from elastomer_friction.kernels import (
    SCHEMES,
    ConstantForce,
    lagged_slope,
    march,
    solve_indentation,
)
from elastomer_friction.kernels.quick.march.balance import foresee
from elastomer_friction.kernels.quick.march.bounds import first_bounds, holds
from elastomer_friction.kernels.quick.march.flights import (
    FORGOTTEN,
    Steady,
    arrivals_of,
    launch,
    powers_of,
)
from elastomer_friction.kernels.quick.march.lists import add_sample, add_span, lists_of, weighed
from elastomer_friction.kernels.quick.march.marks import (
    ALWAYS,
    FREE,
    always,
    levels_of,
    mark_of_first,
    never,
)
from elastomer_friction.kernels.quick.march.runs import classes_of
from elastomer_friction.kernels.quick.march.setting import advance, rise
from elastomer_friction.kernels.quick.steady.spans import SPAN, add_rises, spans_of
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
    first = mark_of_first(setting, bounds, levels)
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
                if not holds(bounds, d, advance(law, d, old)):
                    break
                assert ((setting.z - w < d) == before)[~listed].all()
                u = np.minimum(w, setting.z - d)
    assert (seen > 0).all()


@pytest.mark.parametrize("load", [0.01, 0.3, 3.0])
def test_lists_and_sums_carry_the_load_of_the_start_together(load):
    """Were the speed not to change: then D is d (1 - E) at once."""
    setting, force = setting_of(Jump(0.5, 4, load, 10.0, 1.0), 150)
    guess = foresee(ConstantForce(force), setting)
    bounds = first_bounds(setting, guess, 0.1)
    runs, met, sums = classes_of(setting, bounds)
    lists = lists_of(runs, met)
    depth, _ = weighed(lists.c, lists.weight, setting.start.d)
    assert setting.law.stiffness * (depth + sums.depth) == pytest.approx(force, rel=1e-9)
    assert lists.first[-1] == lists.z.size == (runs.top - runs.bottom + 1).sum()


def test_weighed_sums_are_those_of_the_touching_samples():
    c, weight = np.random.default_rng(2).standard_normal((2, 23))
    each = np.maximum(0.3 - c, 0.0)
    assert weighed(c, weight, 0.3) == pytest.approx((each.sum(), (each * weight).sum()), rel=1e-12)


@pytest.mark.parametrize("hurst", [0.0, 1.0])
def test_a_span_is_its_samples_round_the_period(hurst):
    setting, _ = setting_of(Jump(hurst, 4, 0.5, 10.0, 1.2), 4 * SPAN)
    z, level = setting.z + 7.0, 0.4
    setting = setting._replace(z=z, spans=spans_of(z, setting.slope))
    add_rises(setting.spans.rows, z, setting.slope)
    a = rise(setting.law, z, np.roll(z, -1))
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


STEPS = 30


def test_powers_end_at_the_last_step_or_where_all_is_forgotten():
    np.testing.assert_allclose(powers_of(0.5, 4), 0.5 ** np.arange(5), rtol=1e-15)
    few = powers_of(1e-8, 1000)
    assert few.size == 5
    assert few[-1] == 0.0
    assert few[-2] > FORGOTTEN
    assert (powers_of(0.0, 3) == [1.0, 0.0]).all()


@pytest.mark.parametrize("load", [1e-3, 0.1, 1.0])
def test_at_first_those_arrive_who_are_aloft_in_steady_sliding(load):
    setting, force = setting_of(Jump(0.5, 4, load, 10.0, 1.2), 120)
    bounds = first_bounds(setting, foresee(ConstantForce(force), setting), 0.1)
    runs, met, _ = classes_of(setting, bounds)
    rest = setting.law, lists_of(runs, met), runs
    state = states_of(setting)[0]
    steady = Steady(setting.start.decay.once, setting.start.d)
    _, found = arrivals_of(*rest, steady, setting.z, STEPS)
    _, expected = arrivals_of(*rest, state, setting.z, STEPS)
    assert found.values.size > STEPS
    np.testing.assert_allclose(found.values, expected.values, rtol=1e-11, atol=1e-15)
    np.testing.assert_array_equal(found.begin, expected.begin)


def test_what_is_aloft_arrives_after_the_samples_between_decayed_at_the_new_speed():
    values = np.full(6, np.nan)
    powers = powers_of(0.5, 10)
    launch(Steady(0.8, 0.1), values, 1, 5, powers, values, 7, 6, -1.0)
    assert np.isnan(values[[0, 5]]).all()
    expected = [-(0.5**k) * 0.8 ** (6 - k) for k in (1, 2, 3, 4)]  # k samples upstream of the run
    np.testing.assert_allclose(values[1:5], expected, rtol=1e-14)
