"""Lists that are shortened, elements that always land: the march stays the same, and is shorter."""

from functools import partial

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from elastomer_friction.kernels import SCHEMES, ConstantForce
from elastomer_friction.kernels.quick.march.active import MARGINS, active_march
from elastomer_friction.kernels.quick.march.bounds import first_bounds
from elastomer_friction.kernels.quick.march.crossings import Steady, arrivals_of
from elastomer_friction.kernels.quick.march.landings import beside, land, landed, no_landings
from elastomer_friction.kernels.quick.march.lists import lists_of
from elastomer_friction.kernels.quick.march.load_balance import foresee
from elastomer_friction.kernels.quick.march.narrow import march_shortening
from elastomer_friction.kernels.quick.march.runs import classes_of
from elastomer_friction.kernels.quick.march.stepping import Stand, march_on
from tests.kernels.quick.march.given import Jump, dense, rounding_of_mu, setting_of, size_of_jump
from tests.sizes import size


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
        found = march_shortening(setting, control, where, *others, 1e9, (0.0, 0.0))
    else:
        landings = no_landings(setting.end.d, setting.start.d, steps)
        found = march_on(setting, control, (*where, landings), *others)
    inside, _, _, work = found
    return mu, d, inside, work


def assert_same(setting, load, jump, steps, margin=0.1):
    """Compare as far as the bounds hold; return whether they held to the end."""
    mu, d, inside, _ = followed(setting, ConstantForce(load), steps, True, margin)
    deviation, expected = dense(setting, load, np.arange(1, steps + 1))
    held = np.isfinite(d)
    np.testing.assert_allclose(d[held], expected[held], rtol=1e-11, atol=1e-15)
    allowed = 1e-9 * size_of_jump(setting, jump, load) + rounding_of_mu(setting, load)
    apart = (mu - deviation)[held]  # the steady average, whatever it is
    np.testing.assert_allclose(apart - apart[:1], 0.0, atol=2.0 * allowed)
    return inside


@settings(max_examples=size(200, 15))
@given(
    elements=st.integers(4, 60),
    seed=st.integers(0, 2**31),
    hurst=st.floats(0.0, 1.0),
    m=st.sampled_from([1, 2, 5]),
    load=st.floats(-5.0, 1.6),
    x=st.floats(-2.0, 3.0),
    ratio=st.floats(0.2, 4.0),
    scheme=st.sampled_from(list(SCHEMES)),
    margin=st.sampled_from([0.05, 0.5]),
)
def test_small_lines(elements, seed, hurst, m, load, x, ratio, scheme, margin):
    jump = Jump(hurst, m, 10.0**load, 10.0**x, ratio, scheme)
    setting, load = setting_of(jump, elements, seed)
    assert_same(setting, load, jump, size(60, 15), margin)


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize(
    ("hurst", "m", "load", "x", "ratio"),
    [
        (0.7, 4, 1.0, 60.0, 1.2),
        (0.3, 4, 0.1, 30.0, 1.2),
        (0.9, 2, 3.0, 30.0, 0.8),
        (0.0, 4, 5.0, 30.0, 1.1),
    ],
)
def test_longer_lines(hurst, m, load, x, ratio, scheme):
    jump = Jump(hurst, m, load, x, ratio, scheme)
    setting, force = setting_of(jump, size(1000, 40))
    assert_same(setting, force, jump, size(300, 20))


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
    first, found, long = (marched(m) for m in (MARGINS[:1], MARGINS, (-0.4, -0.4, -0.4, 1e3)))
    assert not first[-1]
    assert found[-1]
    assert long[-1]
    np.testing.assert_allclose(found[1], long[1], rtol=1e-11)
    assert found[3] < size(0.2, 0.9) * long[3]


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


@pytest.mark.parametrize(("q", "steps", "touched"), [(3, 9, False), (6, 9, True), (3, 2, True)])
def test_nothing_is_summed_that_has_another_past(q, steps, touched):
    """It left free, or before the first step; or it is not known, as it would arrive too late."""
    landings, w = no_landings(1.8, 1.8, 20), aloft(30, 0.4)
    w[30 - 1] += 0.0 if touched else 1e-12
    assert not land(LAW, landings, (0.4, 30, q), (0.5, 0.3), PAST, w, steps)
    assert landed(landings).distances.size == 0
    assert not landings.tally.any()
