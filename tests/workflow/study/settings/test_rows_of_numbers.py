"""Rows of numbers, however they are written; the forms of headers are in surfaces/test_text.py."""

import numpy as np
import pytest

from elastomer_friction.workflow.study.settings.rows_of_numbers import BrokenRowError, read_rows


@pytest.mark.parametrize(
    "text", ["0,5;1\n2;3", "0.5\t1 # here\n\n2\t3\t\n", "t v\n0.5, 1,,\n! no\n2, 3\n", "0,5 1\n2 3"]
)
@pytest.mark.parametrize("exact", [False, True])
def test_ways_to_write_them(text, exact):
    np.testing.assert_array_equal(
        read_rows(text.encode(), (0, 1), exact).values, [[0.5, 2.0], [1.0, 3.0]]
    )


@pytest.mark.parametrize(("exact", "text"), [(True, "0 1\n2 3 4"), (False, "0 1\n2")])
def test_a_row_that_breaks_off_or_goes_on_is_named(exact, text):
    with pytest.raises(BrokenRowError, match="line 2 reads '2") as error:
        read_rows(text.encode(), (0, 1), exact)
    assert (error.value.number, error.value.line) == (2, text.partition("\n")[2])


def test_text_without_numbers_has_no_rows():
    rows = read_rows(b"no\nnumbers", (0, 1))
    assert (rows.values.shape, rows.lines) == ((2, 0), ())


def test_the_first_column_as_it_is_written_and_the_lines_of_rows():
    rows = read_rows(b"x\n1,50;2\n\n3;4\n", (0, 1))
    assert rows.written == ("1.50", "3")
    assert (rows.lines, rows.header, rows.delimiter) == ((2, 4), ("x",), ";")
