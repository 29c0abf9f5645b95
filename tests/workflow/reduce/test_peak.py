"""The peak of a curve: between samples by a parabola, at an end the sample itself."""

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from elastomer_friction.workflow.reduce.traces import extremum


@given(st.floats(0.06, 0.94), st.floats(-3.0, 3.0), st.sampled_from([1.0, -1.0]))
@example(0.08, 1.0, 1.0)  # the largest sample is the second
@example(0.92, 1.0, 1.0)  # the last but one
def test_the_peak_of_a_parabola_is_found_on_any_samples(place, height, sign):
    x = np.array([0.0, 0.1, 0.15, 0.4, 0.7, 0.9, 1.0])
    curves = height - sign * (x - place) ** 2 + np.zeros((3, 1))
    value, where = extremum(x, curves, sign)
    assert value == pytest.approx(np.full(3, height), abs=1e-12)
    assert where == pytest.approx(np.full(3, place), abs=1e-12)


def test_at_an_end_the_sample_is_the_peak_and_nan_stays_nan():
    curves = np.array([[3.0, 2.0, 1.0], [1.0, 2.0, 3.0], [1.0, np.nan, 2.0], [2.0, 2.0, 2.0]])
    value, where = extremum(np.arange(3.0), curves, 1.0)
    assert value.tolist()[:2] == [3.0, 3.0]
    assert where.tolist()[:2] == [0.0, 2.0]
    assert np.isnan([value[2], where[2]]).all()
    assert value[3] == 2.0
