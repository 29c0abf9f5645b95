"""The page of variables: dimensions, units, signs, flags, coordinates."""

from elastomer_friction.workflow.reference.results import results_page

PAGE = results_page()


def entry(name):
    """Return what the page says of a variable."""
    return PAGE.split(f"\n### {name}\n\n")[1].split("\n#")[0]


def test_a_number_of_each_point_and_a_curve():
    assert entry("indentation").startswith("*Grid, in m.*\n")
    assert entry("mu").startswith("*Grid × `sample`.*\n")
    assert entry("alpha").startswith("*`hurst`.*\n")
    assert entry("shear_modulus").startswith("*A single number, in Pa.*\n")


def test_the_sign_of_the_indentation_is_said():
    assert "It is negative at light loads" in entry("indentation")


def test_flags_that_were_explained_are_linked():
    assert entry("rate_state_status").endswith("those of [`fit_status`](#fit_status).\n")


def test_coordinates_have_their_rows():
    assert "| `spacing` | element spacing dx | m |" in PAGE


def test_an_asterisk_of_a_symbol_is_no_mark_of_markdown():
    assert r"µ\* of eq. 6" in entry("amplitude")
    assert "ln(v/v*)" not in PAGE
