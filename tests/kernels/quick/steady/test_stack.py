"""Lines that are handed over together: each is as if it were alone."""

import numpy as np
import pytest

from elastomer_friction.kernels.quick.steady.spans import RISE, Spans, spans_of
from elastomer_friction.kernels.quick.steady.stack import (
    alone,
    spans_in,
    spans_of_line,
    stack_of,
    stacked,
)
from tests.kernels.quick.steady.given import line_of

LINES = [line_of(hurst, 77, 2, seed) for seed, hurst in enumerate((0.0, 0.7, 1.0))]


def stack():
    """Return all lines as a stack."""
    return stack_of(stacked([o.z for o in LINES]), stacked([o.slope for o in LINES]))


@pytest.mark.parametrize("spans_at", [spans_of_line, spans_in])
def test_what_is_known_of_the_spans_of_a_line_is_known_in_a_stack(spans_at):
    found = stack()
    for k, line in enumerate(LINES):
        for one, other in zip(spans_at(found, k), spans_of(line.z, line.slope), strict=True):
            np.testing.assert_array_equal(one, other)


def test_what_is_written_into_the_spans_of_a_line_is_in_the_stack():
    found = stack()
    spans_of_line(found, 1).rows[0, RISE] = 5.0
    assert found.rows[1, 0, RISE] == 5.0
    assert np.isnan(found.rows[(0, 2), 0, RISE]).all()


def test_a_line_of_a_stack_is_a_stack():
    one = alone(stack(), 2)
    expected = stack_of(LINES[2].z.reshape(1, -1), LINES[2].slope.reshape(1, -1))
    for own, other in zip(one, expected, strict=True):
        np.testing.assert_array_equal(own, other)
    assert Spans._fields[:-1] == one._fields[2:-1]


def test_a_single_row_is_not_copied():
    row = np.arange(3.0)
    assert np.shares_memory(stacked([row]), row)
    np.testing.assert_array_equal(stacked([row, 2.0 * row]), [row, 2.0 * row])
