"""Columns of numbers in text: separators, headers; and what is refused."""

import pytest

from elastomer_friction.workflow.errors import UserError
from elastomer_friction.workflow.study.settings.rows_of_numbers import (
    read_columns,
    read_rows,
    rows_of_file,
)

NAMES = ("a time in s", "a velocity in m/s")


def read(tmp_path, text):
    path = tmp_path / "columns.txt"
    path.write_text(text, encoding="utf-8")
    return read_columns("key", path, NAMES).values.tolist()


@pytest.mark.parametrize(
    "text",
    [
        "0 1\n2 3",
        "0,1\n2,3\n",
        "0;1\n2;3\n",
        " 0\t1 \n\n 2\t3 ",
        "0,0;1,0\n2;3",
        "0,0 1\n2 3",
        "t v\n0, 1,,\n! no\n2, 3\n",
        "# all in SI\ntime, velocity\n0, 1  # here\n2, 3\n",
        "\ufefftime [s]\tv [m/s]\n0e0\t1.0\n+2\t3\n",
    ],
)
def test_ways_to_write_them(tmp_path, text):
    assert read(tmp_path, text) == [[0.0, 2.0], [1.0, 3.0]]


@pytest.mark.parametrize(
    "text", ["0 1\n2 x", "0 1\n2 nan", "0 1\nend of file", "0 1\n2", "0 1\n2 inf"]
)
def test_a_row_that_is_none_is_named(tmp_path, text):
    with pytest.raises(UserError, match=r"^key: line 2 of .*must hold 2 finite numbers"):
        read(tmp_path, text)


@pytest.mark.parametrize("text", ["0 1 2\n2 3 4", "# as wide\n0;1;2"])
def test_a_column_too_many_is_no_row(tmp_path, text):
    with pytest.raises(UserError, match=r"^key: line \d of .*must hold 2 finite numbers, a time"):
        read(tmp_path, text)


def test_chosen_columns_and_the_lines_where_they_stand(tmp_path):
    (tmp_path / "columns.txt").write_text("t;F;v\n\n0,5;7;1\n1,5;;2\n")
    rows = rows_of_file("key", tmp_path / "columns.txt", (0, 2), NAMES)
    assert rows.values.tolist() == [[0.5, 1.5], [1.0, 2.0]]
    assert (rows.lines, rows.header) == ((3, 4), ("t;F;v", ""))
    with pytest.raises(UserError, match=r"columns\.txt': holds no row of 2 numbers in columns"):
        rows_of_file("key", tmp_path / "columns.txt", (0, 5), NAMES)
    with pytest.raises(UserError, match=r"line 4 of .* reads '1,5;;2': .* in columns \[0, 1\]"):
        rows_of_file("key", tmp_path / "columns.txt", (0, 1), NAMES)


def test_bytes_that_are_no_text(tmp_path):
    (tmp_path / "columns.txt").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(UserError, match="holds no row of 2 numbers"):
        read_columns("key", tmp_path / "columns.txt", NAMES)


def test_a_name_that_no_file_can_have(tmp_path):
    with pytest.raises(UserError, match="cannot be read"):
        read_columns("key", tmp_path / "a\0b", NAMES)


def test_the_first_column_as_it_is_written_and_the_lines_of_rows():
    rows = read_rows(b"x\n1,50;2\n\n3;4\n", (0, 1))
    assert rows.written == ("1.50", "3")
    assert (rows.lines, rows.header, rows.delimiter) == ((2, 4), ("x",), ";")
