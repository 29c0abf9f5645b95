"""The pages of keys: values, units, defaults, and the names of quantities."""

from elastomer_friction.workflow.reference.keys import keys_page, measures_page
from elastomer_friction.workflow.study import QUANTITIES

PAGE = keys_page()


def entry(key, page=PAGE):
    """Return the line of values and the text of a key."""
    return page.split(f"\n### {key}\n\n")[1].split("\n\n")[:2]


def test_an_entry_says_values_unit_and_default():
    assert entry("numerics.horizon")[0] == (
        "*A number from 1 to 100. Default: 4; 6 where `accuracy` is below 1 %.*"
    )
    assert entry("material.shear_modulus")[0] == "*A number above 0, in Pa. Required.*"
    assert "Doubled" in entry("material.shear_modulus")[1]


def test_every_quantity_has_its_row():
    for name in QUANTITIES:
        assert f"\n| `{name}` | " in PAGE


def test_keys_of_a_measured_study_have_the_values_of_its_scales():
    said, means = entry("accuracy: measure.lines", measures_page())
    assert said.startswith("*A whole number from 4 to 100000. Required; `128`")
    assert "Doubled" in means
