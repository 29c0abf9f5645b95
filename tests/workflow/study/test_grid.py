"""Grid axes: what may be written, what comes out, and what a mistake is answered with."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from workflow.errors import UserError
from workflow.study.grid import axis_values, snapped_spacing


@pytest.mark.parametrize(
    ("spec", "values"),
    [
        (0.3, (0.3,)),
        (2, (2.0,)),
        ([3.0, 1, 2.0], (3.0, 1.0, 2.0)),
        ({"linspace": [1.0, 3.0, 3]}, (1.0, 2.0, 3.0)),
        ({"linspace": [2.0, 5.0, 1]}, (2.0,)),
        ({"geomspace": [1e-2, 1e2, 5]}, (0.01, 0.1, 1.0, 10.0, 100.0)),
        ({"geomspace": [-1.0, -100.0, 3]}, (-1.0, -10.0, -100.0)),
    ],
)
def test_values_of_an_axis(spec, values):
    assert axis_values("grid.a", spec) == values


def test_values_are_floats():
    assert all(type(value) is float for value in axis_values("grid.a", [1, 2]))


def test_generated_values_are_the_numbers_one_would_type():
    tenths = axis_values("grid.a", {"linspace": [0.0, 1.0, 11]})
    assert tenths == (0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0)


@given(st.floats(1e-9, 1e9), st.floats(1e-9, 1e9), st.integers(2, 40))
def test_geomspace_keeps_its_ends(first, last, count):
    if 0.5 < first / last < 2.0:
        last = 3.0 * first
    values = axis_values("grid.a", {"geomspace": [first, last, count]})
    assert len(values) == count
    assert (values[0], values[-1]) == pytest.approx((first, last), rel=1e-11)


BAD_AXES = [
    (True, "True", "finite number"),
    ("0.3", "'0.3'", "finite number"),
    (None, "None", "finite number"),
    (math.nan, "nan", "finite number"),
    (-math.inf, "-inf", "finite number"),
    ([1.0, 2.0, 1], "[1.0, 2.0, 1]", "twice"),
    ({"linspace": [1.0, 1.0, 2]}, "[1.0, 1.0, 2]", "twice"),
    ({}, "{}", "use {linspace"),
    ({"linspace": [1, 2, 3], "geomspace": [1, 2, 3]}, "geomspace", "use {linspace"),
]


@pytest.mark.parametrize(("spec", "value", "remedy"), BAD_AXES)
def test_bad_axis_names_key_value_and_remedy(spec, value, remedy):
    with pytest.raises(UserError) as error:
        axis_values("grid.speed", spec)
    message = str(error.value)
    assert message.startswith("grid.speed")
    assert value in message
    assert remedy in message


BAD_ENTRIES = [
    ([1.0, False], "grid.a[1] = False"),
    ([[1.0]], "grid.a[0] = [1.0]"),
    ({"linspace": 3}, "grid.a.linspace = 3"),
    ({"linspace": ["0", 1, 2]}, "grid.a.linspace[0] = '0'"),
    ({"linspace": [0, math.inf, 2]}, "grid.a.linspace[1] = inf"),
    ({"linspace": [0, 1, 2.0]}, "grid.a.linspace[2] = 2.0: must be a whole number"),
    ({"linspace": [0, 1, 0]}, "grid.a.linspace[2] = 0: must be a whole number, from 1 to 10000"),
    ({"geomspace": [0, 1, 3]}, "grid.a.geomspace = [0, 1, 3]: both ends must be of one sign"),
]


@pytest.mark.parametrize(("spec", "start"), BAD_ENTRIES)
def test_bad_entry_is_named_with_its_place(spec, start):
    with pytest.raises(UserError) as error:
        axis_values("grid.a", spec)
    assert str(error.value).startswith(start)


def test_a_whole_number_beyond_every_float_is_refused():
    with pytest.raises(UserError, match="finite number"):
        axis_values("grid.a", 10**400)


def is_smooth(count):
    """Return whether ``count`` has no prime factor but 2, 3 and 5."""
    for prime in (2, 3, 5):
        while count % prime == 0:
            count //= prime
    return count == 1


def nearest_smooth(target):
    """Return the even 5-smooth number nearest to ``target`` in ratio, by trying them all."""
    candidates = range(2, int(4 * target) + 4, 2)
    return min((n for n in candidates if is_smooth(n)), key=lambda n: abs(math.log(n / target)))


@given(st.floats(4.0, 3000.0))
def test_snapped_spacing_is_the_nearest_that_gives_an_even_smooth_number(target):
    (spacing,) = snapped_spacing(0.01, (0.01 / target,))
    elements = 0.01 / spacing
    assert elements == pytest.approx(round(elements), rel=1e-14)
    assert round(elements) % 2 == 0
    assert is_smooth(round(elements))
    best = nearest_smooth(target)
    distances = [abs(math.log(n / target)) for n in (round(elements), best)]
    assert distances[0] == pytest.approx(distances[1], abs=1e-12)


@given(st.integers(1000, 10**7))
def test_snapping_moves_a_fine_spacing_by_few_percent(elements):
    (spacing,) = snapped_spacing(1.0, (1.0 / elements,))
    assert spacing * elements == pytest.approx(1.0, abs=0.035)


def test_spacings_that_snap_to_one_are_one():
    assert snapped_spacing(1.0, (1 / 1000, 1 / 1001, 1 / 500)) == (1 / 1000, 1 / 500)
