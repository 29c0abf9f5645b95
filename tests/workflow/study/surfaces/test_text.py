"""Units of length in headers, and to how much written numbers are known."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from elastomer_friction.workflow.study.surfaces.as_read import metres
from elastomer_friction.workflow.study.surfaces.positions import precision


@given(st.lists(st.floats(-1e6, 1e6), min_size=2, max_size=30), st.sampled_from([".2f", ".4g"]))
def test_numbers_are_within_half_their_precision(numbers, form):
    written = [format(number, form) for number in numbers]
    off = np.abs(np.array(numbers) - np.array(written, dtype=float))
    assert np.all(off <= 0.5 * precision(written) * (1.0 + 1e-9) + 1e-300)


def test_precision_counts_zeros_that_were_left_out():
    np.testing.assert_allclose(precision(["0", "0.2", "3", "1499.8"]), 0.1)
    np.testing.assert_allclose(precision(["1.25e-3", "1.25", "12500"]), [1e-5, 1e-4, 1.0])


MICRO = ("um", "µm", "μm", "UM", "Micrometer", "micrometres", "micron", "Microns", " um ")


@pytest.mark.parametrize("unit", MICRO)
def test_spellings_of_a_micrometre(unit):
    assert metres(unit) == 1e-6


@pytest.mark.parametrize(
    ("unit", "factor"),
    [("m", 1.0), ("mm", 1e-3), ("nm", 1e-9), ("in", 0.0254), ("\u00c5", 1e-10), ("\u212b", 1e-10)],
)
def test_other_units(unit, factor):
    assert metres(unit) == factor


@pytest.mark.parametrize("word", ["M", "", "Raw", "s", "V", "a", "PM", "Lateral"])
def test_other_words_are_no_units(word):
    assert metres(word) is None
