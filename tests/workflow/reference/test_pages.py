"""Reference pages: complete, and up to date in the repository."""

import re
import shutil
from pathlib import Path

import pytest

import elastomer_friction as ef
from elastomer_friction.workflow.cli import command_parser
from elastomer_friction.workflow.reference import PAGES, write_pages
from elastomer_friction.workflow.study import ALL_TABLES, COMPARE, QUANTITIES

FOLDER = Path(__file__).resolve().parents[3] / "docs" / "reference"


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    folder = shutil.copytree(FOLDER, tmp_path_factory.mktemp("docs") / "reference")
    return {path.name: path.read_text(encoding="utf-8") for path in write_pages(folder)}


@pytest.mark.parametrize("name", PAGES)
def test_the_pages_in_the_repository_are_up_to_date(written, name):
    """If this fails: python -m elastomer_friction.workflow.reference, and commit docs/reference."""
    assert (FOLDER / name).read_text(encoding="utf-8") == written[name]


def test_every_command_has_a_heading_and_a_usage_line(written):
    (commands,) = (action for action in command_parser()._actions if action.dest == "command")
    for name in commands.choices:
        assert f"\n## {name}\n\n`elastomer-friction {name}" in written["commands.md"]


def test_every_key_and_quantity_has_an_entry(written):
    for table, keys in ALL_TABLES.items():
        assert f"\n## The table [{table}]\n" in written["keys.md"]
        for key in keys:
            assert f"\n### {table}.{key}\n" in written["keys.md"]
    paragraph = written["keys.md"].partition("**Comparisons.**")[2].partition("\n\n")[0]
    compared = paragraph.partition("values of")[2].partition(". ")[0]
    assert re.findall(r"`(\w+)`", compared) == list(COMPARE)
    for name in QUANTITIES:
        assert f"\n| `{name}` | " in written["keys.md"]


def test_an_entry_states_values_unit_and_default(written):
    assert (
        "\n*A number from 1 to 100. Default: 4; 6 if `accuracy` is below 1 %.*"
        in written["keys.md"]
    )
    assert "\n*A number above 0, in Pa. Required.*" in written["keys.md"]


def test_every_public_name_has_arguments_and_a_meaning(written):
    page = written["python.md"]
    for name in ef.__all__:
        if name != "__version__":
            assert f"\n## ef.{name}" in page
    for method in ("from_result", "steady", "jump", "after_jump", "response"):
        assert f"\n### KineticLaw.{method}\n\n`{method}(" in page
    (arguments,) = re.findall(r"^`run\(\*, (profile.*)\)`$", page, re.MULTILINE)
    names = {word.partition("=")[0] for word in arguments.split(", ")}
    assert {"material", "programme", "realizations"} <= names
    assert "\n- `realizations`: " in page
