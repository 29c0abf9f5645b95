"""The active-set march against the plain one, its lists shortened or not, and what they save."""

import itertools
from functools import partial

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from elastomer_friction.kernels import SCHEMES, ConstantForce
from elastomer_friction.kernels.motion.stretches import touchable
from elastomer_friction.kernels.quick.march.active import MARGINS, active_march
from elastomer_friction.kernels.quick.march.bounds import are_within, bounds_of, first_bounds
from elastomer_friction.kernels.quick.march.crossings import Steady, arrivals_of
from elastomer_friction.kernels.quick.march.landings import beside, land, landed, no_landings
from elastomer_friction.kernels.quick.march.lists import lists_of
from elastomer_friction.kernels.quick.march.load_balance import foresee
from elastomer_friction.kernels.quick.march.narrow import closer_bounds, march_shortening
from elastomer_friction.kernels.quick.march.runs import classes_of
from elastomer_friction.kernels.quick.march.stepping import Stand, march_on
from tests.kernels.quick.march.given import (
    Jump,
    dense,
    rounding_of_mu,
    setting_of,
    size_of_jump,
    states_of,
)
from tests.sizes import size

EVERY = np.arange(1, size(60, 9) + 1)
REGIMES = [
    Jump(hurst, m, load, x, ratio, scheme)
    for hurst, m, load, x, ratio, scheme in itertools.product(
        (0.0, 0.5, 1.0),
        size((1, 4, 16), (1, 4)),
        size((1e-4, 0.03, 0.5, 5.0, 25.0), (1e-3, 0.5, 25.0)),
        size((0.01, 0.3, 3.0, 30.0, 1000.0), (0.3, 30.0)),
        size((0.3, 1.0 + 1e-6, 1.2, 3.0), (0.3, 1.2)),
        SCHEMES,
    )
]


def assert_same(setting, load, jump, kept_steps, margins=MARGINS):
    """Compare with the plain march, within 1e-9 of the jump and what rounding leaves of mu."""
    mu, d, settled, _, inside = active_march(setting, ConstantForce(load), kept_steps, margins)
    assert inside
    deviation, expected = dense(setting, load, kept_steps)
    np.testing.assert_allclose(d, expected, rtol=1e-11, atol=1e-15)
    allowed = 1e-9 * size_of_jump(setting, jump, load) + rounding_of_mu(setting, load)
    np.testing.assert_allclose(mu - settled, deviation, rtol=0.0, atol=allowed)


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("hurst", [0.0, 0.5, 1.0])
def test_it_is_the_plain_march_in_every_regime(hurst, scheme):
    regimes = [jump for jump in REGIMES if (jump.hurst, jump.scheme) == (hurst, scheme)]
    for jump in regimes[:: size(7, 5)]:
        setting, load = setting_of(jump, size(100, 24))
        assert_same(setting, load, jump, EVERY)


def followed(setting, control, steps, narrowing=True, margin=0.1):
    """Return (mu, indentation, inside, work) of a march whose lists are shortened, or are not."""
    guess = foresee(control, setting)
    bounds = first_bounds(setting, guess, margin)
    runs, met, sums = classes_of(setting, bounds)
    lists, steady = lists_of(runs, met), Steady(setting.start.decay.once, setting.start.d)
    arrivals = arrivals_of(setting.law, lists, runs, steady, setting.z, steps)
    kept = np.arange(1, steps + 1)
    mu, d = np.full(steps, np.nan), np.full(steps, np.nan)
    where = runs, lists, sums, arrivals
    stand = Stand(0, 0, setting.start.d, guess, np.nan)
    others = bounds, stand, steps, (kept, mu, d)
    if narrowing:
        found = march_shortening(setting, control, where, *others, 1e9)
    else:
        landings = no_landings(setting.end.d, setting.start.d, steps)
        found = march_on(setting, control, (*where, landings), *others)
    inside, _, _, work = found
    return mu, d, inside, work


@settings(max_examples=size(200, 15))
@given(
    elements=st.integers(2, 60),
    seed=st.integers(0, 2**31),
    hurst=st.floats(0.0, 1.0),
    m=st.sampled_from([1, 2, 5]),
    load=st.floats(-5.0, 1.6),
    x=st.floats(-2.5, 4.0),
    ratio=st.floats(0.2, 4.0),
    scheme=st.sampled_from(list(SCHEMES)),
    margin=st.sampled_from([0.0, 1e-3, 0.05, 0.1, 0.3, 0.5]),
)
def test_small_lines(elements, seed, hurst, m, load, x, ratio, scheme, margin):
    """It may fall back on the plain march, but never gives other numbers.

    Nor do lists that are shortened as soon as they can be, however often that was too much: the
    march goes back to longer ones, and ends if the bounds hold that it began with.
    """
    jump = Jump(hurst, m, 10.0**load, 10.0**x, ratio, scheme)
    setting, load = setting_of(jump, max(elements, -(-4 // m)), seed)
    kept, margins = EVERY[:20], (margin, 0.5, 2.0)
    if active_march(setting, ConstantForce(load), kept, margins)[-1]:
        assert_same(setting, load, jump, kept, margins)
    short, long = (
        followed(setting, ConstantForce(load), EVERY.size, narrowing, max(margin, 0.05))
        for narrowing in (True, False)
    )
    assert short[2] == long[2]
    mu, d, _, _ = short
    deviation, expected = dense(setting, load, EVERY)
    held = np.isfinite(d)
    np.testing.assert_allclose(d[held], expected[held], rtol=1e-11, atol=1e-15)
    allowed = 1e-9 * size_of_jump(setting, jump, load) + rounding_of_mu(setting, load)
    apart = (mu - deviation)[held]  # the steady average, whatever it is
    np.testing.assert_allclose(apart - apart[:1], 0.0, atol=2.0 * allowed)


def test_lists_become_short():
    setting, load = setting_of(Jump(0.7, 4, 1.0, 60.0, 1.2), size(1000, 60))
    short, long = (
        followed(setting, ConstantForce(load), size(300, 40), narrowing)
        for narrowing in (True, False)
    )
    assert short[2]
    assert long[2]
    assert short[3] < size(0.6, 0.95) * long[3]


def test_a_march_that_began_anew_shortens_its_lists_too():
    """At H = 1 and large x, d comes to rest and moves on where a higher asperity is met."""
    setting, load = setting_of(Jump(1.0, 4, 0.025, size(3e3, 150.0), 0.8), size(2000, 100))
    marched = partial(active_march, setting, ConstantForce(load), np.array([size(10_000, 500)]))
    first, found = (marched(m) for m in (MARGINS[:1], MARGINS))
    _, d, held, work = followed(setting, ConstantForce(load), size(10_000, 500), False, 2.0)
    assert not first[-1]
    assert found[-1]
    assert held
    np.testing.assert_allclose(found[1], d[-1:], rtol=1e-11)
    assert found[3] < size(0.2, 0.9) * work


LONG = [Jump(0.7, 4, 1.0, 78.0, 1.2), Jump(0.7, 4, 0.025, 78.0, 0.8), Jump(1.0, 4, 1.0, 31.0, 1.2)]


@pytest.mark.parametrize("jump", LONG, ids=str)
def test_long_lines_over_all_steps(jump):
    steps = int(size(4 * jump.m * jump.ratio * jump.x / np.pi, 80))
    setting, load = setting_of(jump, size(3000, 500))
    assert_same(setting, load, jump, np.arange(1, steps + 1))


def test_full_contact_has_nothing_to_list():
    jump = Jump(1.0, 4, 60.0, 3.0, 1.2)
    setting, load = setting_of(jump, size(200, 40))
    w, d = states_of(setting)[0]
    assert (setting.z - w < d).all()
    assert_same(setting, load, jump, EVERY)
    *_, work, inside = active_march(setting, ConstantForce(load), EVERY)
    assert inside
    assert work == setting.z.size


@pytest.mark.parametrize("x", [1e-5, 1e-3, 1e5])
def test_decay_near_zero_and_near_one(x):
    for load in (1e-80, 1e-3, 1.0):
        setting, force = setting_of(Jump(0.7, 1, load, x, 1.2), size(200, 40))
        mu, d, settled, _, inside = active_march(setting, ConstantForce(force), EVERY)
        assert inside
        deviation, expected = dense(setting, force, EVERY)
        np.testing.assert_allclose(d, expected, rtol=1e-11)
        np.testing.assert_allclose(mu - settled, deviation, atol=1e-8 * np.abs(mu).max())


def test_bounds_that_are_left_cost_a_restart_and_no_digit():
    jump = Jump(0.7, 4, 0.3, 10.0, 2.0)
    setting, load = setting_of(jump, size(200, 40))
    assert not active_march(setting, ConstantForce(load), EVERY, (-0.4,) * 3)[-1]
    assert_same(setting, load, jump, EVERY, (-0.4, 0.5, 2.0))


def test_few_elements_are_stepped():
    """Of the samples that the plain march steps."""
    jump = Jump(0.7, 4, 1.0, 78.0, 1.2)
    setting, load = setting_of(jump, size(2000, 100))
    steps = size(130, 30)
    *_, work, inside = active_march(setting, ConstantForce(load), np.array([steps]))
    assert inside
    start, stop = touchable(setting.z, 1.02 * setting.start.d)
    assert work - setting.z.size < size(0.3, 0.9) * steps * (stop - start).sum()


LAW = SCHEMES["exponential"](0.3)
PAST = np.array([2.0, 1.9, 1.85, 1.83, 1.82, 1.815])
SIZE = 40


def aloft(source, height):
    """Return the displacements of elements that left a sample in contact, up to now."""
    w = np.full(SIZE, np.nan)
    for i in range(1, PAST.size):
        w[(source - i) % SIZE] = LAW.decay**i * (height - PAST[-1 - i])
    return w


def test_sums_are_those_of_samples_one_by_one():
    landings, step, now = no_landings(1.8, PAST[0], 20), PAST.size, 1.81
    samples = [(0.4, 0.5, 2, 0.3), (0.1, 0.7, 4, -0.2), (0.2, 0.3, 4, 0.6)]
    for height, z, q, weight in samples:
        w = aloft(45, height)  # 45 is sample 5, counted on round the period
        assert land(LAW, landings, (height, 45, q), (z, weight), PAST, w, 9)
    landings = landed(landings)
    assert landings.distances.tolist() == [2, 4]
    past = np.append(PAST, now)
    landings.past[: past.size] = past
    each = [now - z + LAW.decay**q * (height - past[step - q]) for height, z, q, _ in samples]
    weights = [weight for *_, weight in samples]
    assert beside(landings, step, now, 0) == (3.0, pytest.approx(sum(each), rel=1e-13))
    expected = np.dot(each, weights)
    assert beside(landings, step, now, 1) == (3.0, pytest.approx(expected, rel=1e-13))


@pytest.mark.parametrize("margin", [0.6, 2.4, 40.0])
def test_closer_ones_leave_room_but_never_go_beyond(margin):
    """A margin of the spread between what was seen, here 2.5, and the end, 2.75."""
    outer = bounds_of(LAW, 1.0, 3.0, 0.2, 0.9, 0.4)
    seen = bounds_of(LAW, 2.5, 2.5, 0.6, 0.6, 0.0)
    found = closer_bounds(LAW, outer, seen, 2.75, margin)
    assert found.high == pytest.approx(min(2.75 + margin * 0.25, outer.high))
    assert found.low == pytest.approx(max(2.5 - margin * 0.25, outer.low))
    assert found.least >= outer.least
    assert found.most <= outer.most
    assert are_within(found, 2.75, 0.6)
