"""Static friction after a hold, from traces that are known."""

import numpy as np
import pytest

from elastomer_friction.kernels import Hold, Slide
from elastomer_friction.workflow.reduce.traces import healing, last_hold

PROGRAMME = (Slide(-2.0, 3.0), Hold(5.0), Slide(-2.0, 4.0))
TRACES = (  # leg, distance and friction of the samples
    np.array([[0.0, 0, 1, 1, 2, 2, 2, 2]]),
    np.array([[0.0, -3, -3, -3, -4, -5, -6, -7]]),
    -np.array([[0.4, 0.5, 0.3, 0.2, 0.6, 0.8, 0.7, 0.5]]),
)


def test_peak_and_end_of_the_hold_have_the_sign_of_the_motion():
    found = healing(PROGRAMME, *TRACES)
    assert found.mu_end_of_hold.tolist() == [-0.2]
    assert found.static_peak[0] == pytest.approx(-0.8, abs=0.01)
    assert found.healing[0] == found.static_peak[0] + 0.5
    assert found.peak_distance[0] == pytest.approx(2.2, abs=0.1)


def test_the_last_hold_that_is_slid_after_counts():
    twice = (*PROGRAMME, Hold(1.0), Slide(3.0, 1.0), Hold(1.0))
    assert last_hold(PROGRAMME) == (1, -2.0)
    assert last_hold(twice) == (3, 3.0)


@pytest.mark.parametrize("programme", [(Slide(1.0, 1.0),), (Hold(1.0), Hold(1.0))])
def test_without_such_a_hold_there_is_nothing(programme):
    assert np.isnan(healing(programme, *TRACES)).all()
