"""The page of variables: dimensions, units, signs, flags, coordinates."""

from elastomer_friction.workflow.reference.results import results_page

PAGE = results_page()


def entry(name):
    """Return what the page says of a variable."""
    return PAGE.split(f"\n### {name}\n\n")[1].split("\n#")[0]


def test_a_number_of_each_point_and_a_curve():
    assert "Dimensions: grid; unit: m.*" in entry("indentation")
    assert "Dimensions: grid × `sample`; unit: 1.*" in entry("mu")
    assert "Dimensions: `hurst`; unit: 1.*" in entry("alpha")


def test_the_sign_of_the_indentation_is_said():
    assert "Sign: negative at light loads" in entry("indentation")


def test_coordinates_have_their_rows():
    assert "| `spacing` | element spacing dx | m |" in PAGE


def test_an_asterisk_of_a_symbol_is_no_mark_of_markdown():
    assert r"*Amplitude mu\* of eq. 6" in entry("amplitude")
    assert "ln(v/v*)" not in PAGE
