"""Numbers as they are written, encodings, archives, and codes for missing values."""

import numpy as np
import pytest

from elastomer_friction.workflow.ground import foreign_content, is_text
from elastomer_friction.workflow.study.codes import missing_code
from elastomer_friction.workflow.text_tables.numerals import is_numeral, marks_of


@pytest.mark.parametrize(
    ("words", "numbers"),
    [
        ("0.5 -3e-1 +2 7. .25 1.5D2", [0.5, -0.3, 2.0, 7.0, 0.25, 150.0]),
        ("0,5 -3e-1 2", [0.5, -0.3, 2.0]),
        ("0,500 1,234", [0.5, 1.234]),  # a leading zero shows that commas are decimal
        ("1,234,567 12", [1234567.0, 12.0]),
        ("1.234,5 0,25", [1234.5, 0.25]),
        ("1,234.5 2.0", [1234.5, 2.0]),
    ],
)
def test_marks_of_a_table(words, numbers):
    assert all(map(is_numeral, words.split()))
    marks = marks_of(words.split())
    assert [marks.number(word) for word in words.split()] == numbers


@pytest.mark.parametrize(
    ("words", "why"),
    [
        ("600,362 12", "600,362 may be 600.362 or 600362"),
        ("0.100 600,362", "may be"),
        ("0,5 2.5", "holds both 0,5 and 2.5"),
        ("0.5 1.234.567", "holds both 1.234.567 and 0.5"),
        ("0,5 1,234,567", "holds both 0,5 and 1,234,567"),
    ],
)
def test_what_can_be_read_in_two_ways_is_refused(words, why):
    with pytest.raises(ValueError, match=why):
        marks_of(words.split())


@pytest.mark.parametrize("word", ["x", "1x", "12.05.2020", "02:10", "1_000", "e5", ""])
def test_words_that_are_no_numbers(word):
    assert not is_numeral(word)


def test_archives_and_files_that_are_no_text():
    assert foreign_content(b"PK\x03\x04rest").startswith("a zip archive")
    assert "Excel" in foreign_content(b"PK\x03\x04 [Content_Types].xml")
    assert "mesh" in foreign_content(b"ply\nelement vertex 9\nelement face 4\n")
    assert "picture" in foreign_content(b"\x89PNG\r\n")
    assert "JSON" in foreign_content(b'[{"x": 1}]')
    assert "PDF" in foreign_content(b"%PDF-1.4\n1 0 obj\n")
    assert "web page" in foreign_content(b"<!DOCTYPE html>\n404 1\n")
    assert foreign_content(b"0 1\n") == foreign_content(b"ply\nelement vertex 9\n") == ""
    assert is_text("x (µm)\n0\t1\r\n".encode("latin-1"))
    assert is_text("x\n0 1".encode("utf-16"))
    assert not is_text(b"\x89HDF\r\n\x1a\n")
    assert is_text(b"0 1\r\n\x1a")
    assert not is_text(b"1\x00\x002\x00")
    header = b"\\*File list\r\n" * 400  # of a microscope, with numbers behind it
    assert is_text(header)
    for encoding in ("utf-8", "utf-16-le"):
        text = header.decode().encode(encoding)
        assert not is_text(text + np.arange(4000, dtype="<i2").tobytes())


HEIGHTS = np.random.default_rng(5).normal(size=100)


@pytest.mark.parametrize(
    ("code", "count", "found"),
    [
        (-9999.0, 3, True),
        (-9999.0, 1, True),
        (-32768.0, 5, True),
        (3.4e38, 1, True),
        (-0.5e4, 2, True),  # no known code, but twice the same
        (-0.5e4, 1, False),  # a spike
        (8.0, 5, False),  # a plateau
    ],
)
def test_codes_for_missing_values(code, count, found):
    values = HEIGHTS.copy()
    values[10 : 10 + count] = code
    values[50] = np.nan
    seen = missing_code(values)
    assert (seen is not None) == found
    if seen:
        assert (seen.value, seen.times) == (code, count)
        assert seen.spreads == pytest.approx(abs(code) / 3.3, rel=0.3)
