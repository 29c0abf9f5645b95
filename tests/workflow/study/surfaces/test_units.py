"""Units of length: the spellings of instruments, and words that are none."""

import pytest

from elastomer_friction.workflow.study.surfaces.files import metres, units_in

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
