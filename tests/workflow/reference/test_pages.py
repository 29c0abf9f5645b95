"""The pages of reference: as the tables in the code are now, and in the repository."""

from pathlib import Path

import pytest

from elastomer_friction.workflow.reference import PAGES, write_pages
from elastomer_friction.workflow.result import VARIABLES
from elastomer_friction.workflow.study import EVERY_TABLE, described_measures

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
        assert f"\n## The table [measure] of {study}\n" in written["measures.md"]
        for key in keys:
            assert f"\n### {study}: measure.{key}\n" in written["measures.md"]
    for name in VARIABLES:
        assert f"\n### {name}\n" in written["results.md"]


def test_a_flag_has_its_row_and_what_the_file_says_of_it(written):
    page = written["results.md"]
    assert "| −1 | `failed` |" in page
    assert "| 2 | `not_exponential`: eq. 6 leaves over a fifth of the sum of squares |" in page
