"""Values of an axis: what may be written, what comes out, and what a mistake is answered with."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from elastomer_friction.workflow.errors import UserError
from elastomer_friction.workflow.study.settings.checks import axis_values


@pytest.mark.parametrize(
    ("spec", "values"),
    [
        (2, (2.0,)),
        ([3.0, 1, 2.0], (3.0, 1.0, 2.0)),
        ({"linspace": [2.0, 5.0, 1]}, (2.0,)),
        ({"linspace": [0.0, 1.0, 11]}, tuple(k / 10 for k in range(11))),  # as one would type
        ({"geomspace": [1e-2, 1e2, 5]}, (0.01, 0.1, 1.0, 10.0, 100.0)),
        ({"geomspace": [-1.0, -100.0, 3]}, (-1.0, -10.0, -100.0)),
    ],
)
def test_values_of_an_axis(spec, values):
    found = axis_values("grid.a", spec)
    assert found == values
    assert all(type(value) is float for value in found)


@given(st.floats(1e-9, 1e9), st.floats(1e-9, 1e9), st.integers(2, 40))
def test_geomspace_keeps_its_ends(first, last, count):
    if 0.5 < first / last < 2.0:
        last = 3.0 * first
    values = axis_values("grid.a", {"geomspace": [first, last, count]})
    assert len(values) == count
    assert (values[0], values[-1]) == pytest.approx((first, last), rel=1e-11)


# Beside those of tests/refusals.md, which test_limits.py tries.
BAD = [
    (True, " = True: must be a finite number"),
    ("0.3", " = '0.3': must be a finite number"),
    (10**400, f" = {10**39}: must be a finite number"),
    ([1.0, 2.0, 1], " = [1.0, 2.0, 1]: holds a value twice"),
    ({"linspace": [1.0, 1.0, 2]}, " = {'linspace': [1.0, 1.0, 2]}: holds a value twice"),
    ({}, " = {}: use {linspace"),
    ({"linspace": 1, "geomspace": 1}, " = {'linspace': 1, 'geomspace': 1}: use {linspace"),
    ([1.0, False], "[1] = False"),
    ([[1.0]], "[0] = [1.0]"),
    ({"linspace": 3}, ".linspace = 3"),
    ({"linspace": ["0", 1, 2]}, ".linspace[0] = '0'"),
    ({"linspace": [0, math.inf, 2]}, ".linspace[1] = inf"),
    ({"linspace": [0, 1, 2.0]}, ".linspace[2] = 2.0: must be a whole number"),
    ({"linspace": [0, 1, 0]}, ".linspace[2] = 0: must be a whole number, from 1 to 10000"),
    ({"geomspace": [0, 1, 3]}, ".geomspace = [0, 1, 3]: both ends must be of one sign"),
]


@pytest.mark.parametrize(("spec", "complaint"), BAD)
def test_what_is_wrong_is_named_with_its_place(spec, complaint):
    with pytest.raises(UserError) as error:
        axis_values("grid.a", spec)
    assert str(error.value).startswith(f"grid.a{complaint}")
