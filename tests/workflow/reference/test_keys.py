"""The page of keys: values, units, defaults, and the names of quantities."""

from elastomer_friction.workflow.reference.keys import keys_page
from elastomer_friction.workflow.study import QUANTITIES

PAGE = keys_page()


def entry(key):
    """Return the line of values and the text of a key."""
    return PAGE.split(f"\n### {key}\n\n")[1].split("\n\n")[:2]


def test_an_entry_says_values_unit_and_default():
    assert entry("numerics.horizon")[0] == (
        "*Value: a number from 1 to 100; default: 4; 6 where `accuracy` is below 1 %.*"
    )
    assert entry("material.shear_modulus")[0] == "*Value: a number above 0; unit: Pa; required.*"
    assert "Doubled" in entry("material.shear_modulus")[1]


def test_every_quantity_has_its_row():
    for name in QUANTITIES:
        assert f"\n| `{name}` | " in PAGE


def test_keys_of_a_measured_study_have_the_values_of_its_scales():
    said, means = entry("accuracy: measure.lines")
    assert said.startswith("*Value: a whole number, at least 4 and at most 100000; required; `128`")
    assert "Doubled" in means
