"""Elements that always land need the past of the indentation alone."""

import numpy as np
import pytest

from elastomer_friction.kernels import SCHEMES
from elastomer_friction.kernels.quick.march.landings import land, landed, no_landings
from elastomer_friction.kernels.quick.march.load_balance import beside, keep_past

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
    for k in range(past.size):
        keep_past(landings, k, past[k])
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
