"""Text files of instruments: headers, units, delimiters, encodings, rounded numbers."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from elastomer_friction.workflow.study.surfaces.files import metres, precision, read_text, units_in

RESOURCES = Path(__file__).resolve().parents[3] / "resources"


def read(text, columns=(0, 1), encoding="utf-8"):
    return read_text("surface.file", "f.txt", text.encode(encoding), columns)


@pytest.mark.parametrize(
    "text",
    [
        "0.5,1.5\n2,-3e-1\n",
        "0.5 1.5\n\n2 -3e-1",
        "0.5\t1.5\r\n2\t-0.3\r\n",
        "0,5;1,5\n2;-0,3\n",
        "0,5\t1,5\n2\t-0,3\n",
        "0,5 1,5\n2 -0,3\n",
        "# a comment\n0.5, 1.5,,\n% another\n  // and one\n2.0,-0.3,,\n! the last\n",
        "Scan\r\r\nID,0\r\r\n\r\r\nx,z\r\r\n0.5,1.5,,\r\n2,-0.3,,\r\n",
        "\ufeff0.5,1.5\n2,-0.3\n",
    ],
)
def test_a_table_is_read_however_it_is_written(text):
    np.testing.assert_array_equal(read(text).values, [[0.5, 2.0], [1.5, -0.3]])


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "latin-1", "utf-16"])
def test_the_micro_sign_in_any_encoding(encoding):
    assert read("x (µm),z (µm)\n0,1\n1,2\n", encoding=encoding).units == ("µm", "µm")


@pytest.mark.parametrize(
    ("header", "units"),
    [
        ("Lateral um,Raw Micrometer,", ("um", "Micrometer")),
        ("# x [um] z [nm]", ("um", "nm")),
        ("x,z\num,nm", ("um", "nm")),
        ("x (mm),height", ()),
        ("", ()),
        ("far, um, nm\n1\n2\n3", ()),  # not just before the numbers
    ],
)
def test_units_of_the_header(header, units):
    assert read(f"{header}\n0,1\n1,2\n").units == units


def test_columns_are_chosen():
    table = read("a,b mm,c um\n1,2,3\n4,5,6\n", columns=(1, 2))
    np.testing.assert_array_equal(table.values, [[2.0, 5.0], [3.0, 6.0]])
    assert table.units == ("mm", "um")
    assert table.written == ("2", "5")


def test_the_stylus_line_is_read_as_it_is():
    data = (RESOURCES / "stylus-line.csv").read_bytes()
    table = read_text("surface.file", "stylus-line.csv", data, (0, 1))
    assert table.values.shape == (2, 9600)
    assert table.units == ("um", "Micrometer")
    np.testing.assert_array_equal(table.values[:, [0, 1, -1]], [[0.0, 0.2, 1499.8], FIRST_AND_LAST])
    assert np.all(precision(table.written) == 0.1)


FIRST_AND_LAST = [-0.00933, -0.0076, 16.58112]


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
    [("m", 1.0), ("mm", 1e-3), ("nm", 1e-9), ("\u00c5", 1e-10), ("\u212b", 1e-10)],
)
def test_other_units(unit, factor):
    assert metres(unit) == factor


@pytest.mark.parametrize("word", ["M", "", "Raw", "s", "V", "a", "inch", "Lateral"])
def test_other_words_are_no_units(word):
    assert metres(word) is None


@pytest.mark.parametrize(
    ("header", "units"),
    [
        ("Lateral um,Raw Micrometer,", ["um", "Micrometer"]),
        ("x [µm]\tz (nm)", ["µm", "nm"]),
        ("position/mm;height_um", ["mm", "um"]),
        ("R. Cursor, M 3", []),
    ],
)
def test_units_within_a_header(header, units):
    assert units_in(header) == units
