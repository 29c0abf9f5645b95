"""Grid axes: snapped spacings."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from elastomer_friction.workflow.study.grid import snapped_spacing

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
