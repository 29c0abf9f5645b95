"""The indentation under loads, by spans: the plain solver's, from any guess, in few sweeps."""

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from elastomer_friction.kernels import SCHEMES, Line, steady_sliding
from elastomer_friction.kernels.quick.steady.carry import decay_of
from elastomer_friction.kernels.quick.steady.contacts import room_for
from elastomer_friction.kernels.quick.steady.sliding import (
    CLOSE,
    STEPS,
    approach,
    indentation,
)
from elastomer_friction.kernels.quick.steady.thresholds import thresholds_of
from tests.kernels.quick.march.given import spans_of
from tests.lines import random_line
from tests.sizes import size

LINES = [(0.0, 5, 1, 3.0), (0.3, 77, 2, 0.05), (0.7, 100, 4, 2.0), (1.0, 48, 8, 500.0)]
LOADS = (1e-6, 1e-3, 0.03, 0.3, 2.0, 40.0)  # Fbar, from a sample to full contact


def given_line(point):
    hurst, elements, m, _ = point
    return Line.from_samples(*random_line(elements, hurst, m, 3), m)


def solved(point, load, guess=None):
    """Return d by spans, the number of sweeps, and d of the plain solver to its rounding."""
    _, _, m, speed = point
    line = given_line(point)
    law, spans = SCHEMES["exponential"](1.0 / (m * speed)), spans_of(line.z, line.slope)
    own, total = thresholds_of(line.z, line.slope, speed, law.stiffness), load * line.z.size
    to, steps = (decay_of(law), line.z, spans, own.stay), 0
    if guess is None:
        guess, steps = approach(*to, total), STEPS
    d, after, _ = indentation(*to, total, guess, room_for(line.slope, speed))
    plain = steady_sliding(law, line.z, total)[0].d
    # The plain balance is known to 1e-15 of d times the stiffness, m vbar and more.
    return (
        d,
        steps + after,
        pytest.approx(plain, rel=1e-12 + 1e-15 * (1 + m * speed) * plain / load),
    )


@pytest.mark.parametrize("load", LOADS)
@pytest.mark.parametrize("point", LINES, ids=str)
def test_few_sweeps_lead_to_the_indentation(point, load):
    d, sweeps, plain = solved(point, load)
    assert d == plain
    assert sweeps <= 7


@settings(max_examples=size(200, 20))
@example((0.7, 50, 2, 1e-12), -100.0, 0.0)
@example((0.7, 50, 2, 1e12), -100.0, 0.0)
@example((0.7, 50, 2, 1.0), 100.0, 0.0)
@example((0.0, 5, 1, 3.0), 0.875, 4.0)
@example((0.0, 5, 1, 3.0), 1.0, 5.75)
@given(st.sampled_from(LINES), st.floats(-9.0, 3.0), st.floats(-12.0, 6.0))
def test_any_guess_leads_to_the_root(point, load, guess):
    d, sweeps, _ = solved(point, 10.0**load, 10.0**guess)
    # Each search may leave CLOSE of the load. The force is convex in the depth and begins with
    # it, so that it is at most its slope times the depth: of the depth no more than CLOSE is left.
    # The first step, from the guess, is rounded as the guess is, and may end the search.
    left = 2.0 * CLOSE * (d - given_line(point).z.min()) + 1e-15 * (1.0 + 10.0**guess)
    assert d == pytest.approx(solved(point, 10.0**load)[0], rel=0.0, abs=left)
    assert sweeps <= (16 if abs(load) < 100.0 else 40)
