"""Samples per contact: runs of touching samples, weighed with the load they carry."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from elastomer_friction.kernels.quick.contacts.samples import samples_per_contact

FORCES = hnp.arrays(float, st.integers(1, 40), elements=st.floats(-1.0, 1.0))


@pytest.mark.parametrize(
    ("force", "samples"),
    [
        ([0.0, 0.0], 0.0),
        ([1.0, 2.0, 3.0], 3.0),  # full contact
        ([-1.0, 5.0, -1.0, 1.0, 1.0, 0.0], 1.0),  # the narrow one carries more than half
        ([-1.0, 1.0, -1.0, 2.0, 2.0, 0.0], 2.0),
        ([1.0, 0.0, 0.0, 1.0], 2.0),  # one patch round the end of the line
    ],
)
def test_the_median_over_the_load(force, samples):
    assert samples_per_contact(np.array(force)) == samples


@given(FORCES, st.integers(0, 39))
def test_where_the_line_begins_plays_no_part(force, shift):
    assert samples_per_contact(np.roll(force, shift)) == samples_per_contact(force)


@given(FORCES, st.integers(2, 4))
def test_finer_samples_are_so_many_times_as_many(force, fold):
    finer = samples_per_contact(np.repeat(force, fold))
    assert finer == fold * samples_per_contact(force)
