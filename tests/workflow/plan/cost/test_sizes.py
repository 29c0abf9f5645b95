"""Seconds over samples: a power law between what was measured, and never less for more."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from elastomer_friction.workflow.plan.cost.work import DRAW, STEP, SWEEP, SecondsBySize

CURVE = SecondsBySize((10.0, 100.0, 1000.0), (2.0, 8.0, 80.0))


def test_a_curve_passes_through_what_was_measured():
    assert [CURVE(size) for size in CURVE.sizes] == pytest.approx(CURVE.seconds)
    assert CURVE(math.sqrt(1000.0)) == pytest.approx(4.0)  # a power law in between
    assert CURVE(1.0) == pytest.approx(2.0)  # what a call takes at least
    assert CURVE(2000.0) == pytest.approx(160.0)


@given(st.sampled_from([CURVE, DRAW, STEP, SWEEP]), st.floats(1.0, 1e7), st.floats(1.0, 4.0))
def test_more_samples_never_take_less_time(curve, size, factor):
    assert curve(size * factor) >= curve(size) * (1.0 - 1e-12)
