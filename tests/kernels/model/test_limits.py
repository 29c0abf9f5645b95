"""The limits of loads and speeds: what lies outside is named, and nothing else is refused."""

import math

import pytest

from elastomer_friction.kernels.model.limits import LOADS, SPEEDS, check_between


@pytest.mark.parametrize("limits", [LOADS, SPEEDS])
def test_both_limits_are_taken(limits):
    for value in limits:
        check_between("speed", value, limits)


@pytest.mark.parametrize("value", [0.0, -1.0, 1e-13, 1e13, math.inf, math.nan])
def test_what_lies_outside_is_named_with_what_would_be_right(value):
    with pytest.raises(ValueError, match=r"^speed = \S+: must lie between 1e-12 and 1e\+12$"):
        check_between("speed", value, SPEEDS)
