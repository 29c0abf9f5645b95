"""Values of an axis: what may be written, what comes out, and what a mistake is answered with."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.study.grid import snapped_spacing
from elastomer_friction.workflow.study.settings import axis_values, within


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
    actual = axis_values("grid.a", spec)
    assert actual == values
    assert all(type(value) is float for value in actual)


@given(st.floats(1e-9, 1e9), st.floats(1e-9, 1e9), st.integers(2, 40))
def test_geomspace_keeps_its_ends(first, last, count):
    if 0.5 < first / last < 2.0:
        last = 3.0 * first
    values = axis_values("grid.a", {"geomspace": [first, last, count]})
    assert len(values) == count
    assert (values[0], values[-1]) == pytest.approx((first, last), rel=1e-11)


def test_both_ends_of_a_range_are_within_it():
    for value in (0.0, 0.5, 1.0):
        assert within("grid.a", value, 0.0, 1.0) == value
    for value in (math.nextafter(0.0, -1.0), math.nextafter(1.0, 2.0)):
        with pytest.raises(UserError, match="must lie between 0 and 1"):
            within("grid.a", value, 0.0, 1.0)


EVEN_SMOOTH = [2**a * 3**b * 5**c for a in range(1, 23) for b in range(15) for c in range(10)]


@given(st.floats(4.0, 1e6))
def test_snapped_spacing_is_the_nearest_that_gives_an_even_number_quick_for_the_fft(target):
    (spacing,) = snapped_spacing(0.01, (0.01 / target,))
    elements = round(0.01 / spacing)
    assert elements * spacing == pytest.approx(0.01, rel=1e-14)
    assert elements in EVEN_SMOOTH
    distance = min(abs(math.log(number / target)) for number in EVEN_SMOOTH)
    assert abs(math.log(elements / target)) == pytest.approx(distance, abs=1e-12)
    assert distance < 0.035 or target < 1000  # fine spacings move by few percent


def test_spacings_that_snap_to_one_are_one():
    assert snapped_spacing(1.0, (1 / 1000, 1 / 1001, 1 / 500)) == (1 / 1000, 1 / 500)
