"""Single legs of a programme: their speeds, and what has no meaning."""

import math

import pytest

from elastomer_friction.kernels.motion.legs import (
    Hold,
    Oscillation,
    Ramp,
    Sampled,
    Slide,
    last_speed,
    speed_at_start,
    steps_of,
)
from elastomer_friction.kernels.rheology.spectrum import SHORTEST

M = 4


@pytest.mark.parametrize(
    ("leg", "first", "last"),
    [
        (Slide(2.0, 1.0), 2.0, 2.0),
        (Hold(1.0), 0.0, 0.0),
        (Ramp(1.0, 3.0, 1.0), 1.0, 3.0),
        (Oscillation(0.5, 1.0, 1.0, 1), 0.5, 0.5 + 2.0 * math.pi),
        (Sampled((0.0, 1.0), (4.0, 5.0)), 4.0, 5.0),
    ],
)
def test_first_and_last_speed(leg, first, last):
    assert speed_at_start((leg,)) == first
    assert last_speed(leg) == pytest.approx(last)


@pytest.mark.parametrize(
    "leg",
    [
        Slide(0.0, 1.0),
        Slide(1.0, -1.0),
        Slide(math.nan, 1.0),
        Hold(-1.0),
        Ramp(1.0, 2.0, 0.0),
        Oscillation(0.0, 0.0, 1.0, 1),
        Oscillation(0.0, 1.0, 1.0, 0),
        Oscillation(0.0, 1.0, 1.0, 2.5),
        Sampled((0.0,), (1.0,)),
        Sampled((1.0, 2.0), (1.0, 1.0)),
        Sampled((0.0, 0.0), (1.0, 1.0)),
        Sampled((0.0, 1.0), (1.0, math.inf)),
    ],
    ids=str,
)
def test_legs_without_meaning_are_refused(leg):
    with pytest.raises(ValueError, match=type(leg).__name__):
        steps_of((leg,), M)


def test_steps_lost_in_rounding_are_refused():
    with pytest.raises(ValueError, match="lost in rounding"):
        steps_of((Slide(1.0 / (M * SHORTEST) * 2.0, 5.0),), M)
