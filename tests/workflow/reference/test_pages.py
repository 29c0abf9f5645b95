"""The pages of reference: as the tables in the code are now, and in the repository."""

import re
from pathlib import Path

import pytest

from elastomer_friction.workflow.cli import command_parser
from elastomer_friction.workflow.reference import PAGES, write_pages
from elastomer_friction.workflow.reference.commands import commands_page
from elastomer_friction.workflow.reference.index import anchor, index_page
from elastomer_friction.workflow.reference.keys import keys_page
from elastomer_friction.workflow.reference.results import results_page
from elastomer_friction.workflow.result import VARIABLES
from elastomer_friction.workflow.study import EVERY_TABLE, QUANTITIES, described_measures

PAGE = commands_page()


def test_every_command_has_its_heading_and_its_usage():
    (commands,) = (action for action in command_parser()._actions if action.dest == "command")
    assert {"plan", "run", "figure", "prony"} <= set(commands.choices)
    for name in commands.choices:
        assert f"\n## {name}\n\n`elastomer-friction {name}" in PAGE


def test_an_option_is_named_with_its_meaning_and_default():
    assert "| `--accuracy ACCURACY` | as --set numerics.accuracy=0.01: 1% or 0.01 |  |" in PAGE
    assert "| `--set TABLE.KEY=VALUE` | override one setting" in PAGE
    assert "| folder of results, or path of the .nc file | `results` |" in PAGE


def test_a_place_for_one_or_more_files_and_one_for_this_or_that():
    assert "\n`elastomer-friction fit FILE … [OPTIONS]`\n" in PAGE
    assert "| `[FOLDER or STUDY]` | a folder of results" in PAGE


KEYS = keys_page()


def key_entry(key):
    """Return the line of values and the text of a key."""
    return KEYS.split(f"\n### {key}\n\n")[1].split("\n\n")[:2]


def test_an_entry_says_values_unit_and_default():
    assert key_entry("numerics.horizon")[0] == (
        "*Value: a number from 1 to 100; default: 4; 6 where `accuracy` is below 1 %.*"
    )
    assert (
        key_entry("material.shear_modulus")[0] == "*Value: a number above 0; unit: Pa; required.*"
    )
    assert "Doubled" in key_entry("material.shear_modulus")[1]


def test_every_quantity_has_its_row():
    for name in QUANTITIES:
        assert f"\n| `{name}` | " in KEYS


def test_keys_of_a_measured_study_have_the_values_of_its_scales():
    said, means = key_entry("accuracy: measure.lines")
    assert said.startswith("*Value: a whole number, at least 4 and at most 100000; required; `128`")
    assert "Doubled" in means


RESULTS = results_page()


def entry(name):
    """Return what the page says of a variable."""
    return RESULTS.split(f"\n### {name}\n\n")[1].split("\n#")[0]


def test_a_number_of_each_point_and_a_curve():
    assert "Dimensions: grid; unit: m.*" in entry("indentation")
    assert "Dimensions: grid × `sample`; unit: 1.*" in entry("mu")
    assert "Dimensions: `hurst`; unit: 1.*" in entry("alpha")


def test_the_sign_of_the_indentation_is_said():
    assert "Sign: negative at light loads" in entry("indentation")


def test_coordinates_have_their_rows():
    assert "| `spacing` | element spacing dx | m |" in RESULTS


def test_an_asterisk_of_a_symbol_is_no_mark_of_markdown():
    assert r"*Amplitude mu\* of eq. 6" in entry("amplitude")
    assert "ln(v/v*)" not in RESULTS


ROWS = re.findall(r"^\| \[`(\w+)`\]\((\w+\.md)#([\w-]+)\)", index_page(), re.MULTILINE)


def test_names_are_in_order():
    names = [name for name, _, _ in ROWS]
    assert len(names) > 100
    assert names == sorted(names)


def test_every_link_leads_to_a_heading():
    pages = {"keys.md": keys_page(), "results.md": results_page()}
    known = {
        (name, anchor(heading))
        for name, page in pages.items()
        for heading in re.findall(r"^#+ (.*)$", page, re.MULTILINE)
    }
    assert {(page, place) for _, page, place in ROWS} <= known


FOLDER = Path(__file__).resolve().parents[3] / "docs" / "reference"


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    folder = tmp_path_factory.mktemp("docs") / "reference"
    return {path.name: path.read_text(encoding="utf-8") for path in write_pages(folder)}


@pytest.mark.parametrize("name", PAGES)
def test_the_pages_in_the_repository_are_up_to_date(written, name):
    """If this fails: python -m elastomer_friction.workflow.reference, and commit docs/reference."""
    assert (FOLDER / name).read_text(encoding="utf-8") == written[name]


def test_every_key_and_every_variable_has_its_heading(written):
    for table, keys in EVERY_TABLE.items():
        assert f"\n## The table [{table}]\n" in written["keys.md"]
        for key in keys:
            assert f"\n### {table}.{key}\n" in written["keys.md"]
    for study, keys in described_measures().items():
        assert f"\n## The table [measure] of {study}\n" in written["keys.md"]
        for key in keys:
            assert f"\n### {study}: measure.{key}\n" in written["keys.md"]
    for name in VARIABLES:
        assert f"\n### {name}\n" in written["results.md"]


def test_a_flag_has_its_row_and_what_the_file_says_of_it(written):
    page = written["results.md"]
    assert "| −1 | `failed` |" in page
    assert "| 2 | `not_exponential`: eq. 6 leaves over a fifth of the sum of squares |" in page
