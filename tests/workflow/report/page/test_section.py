"""What is shown of one study: every study has a caption, and its title holds at every scale."""

import re

import pytest

from elastomer_friction.workflow.errors import UserError
from elastomer_friction.workflow.report.figure import caption
from elastomer_friction.workflow.report.page import section
from elastomer_friction.workflow.result.netcdf import write_datasets
from elastomer_friction.workflow.study.read import known_studies, read_study
from tests.support.synthetic import result

SENTENCE = r"[A-Z][^.]*(?:(?:eqs?\.|\d\.\d)[^.]*)*\."


@pytest.mark.parametrize("name", known_studies())
def test_every_study_has_a_caption_of_two_sentences(name):
    assert re.fullmatch(f"{SENTENCE} {SENTENCE}", caption(read_study(name)))


def test_a_study_without_a_script_has_the_caption_of_the_usual_figure(tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text(known_studies()["fig6"].read_text(encoding="utf-8"), encoding="utf-8")
    assert caption(read_study(str(path))).startswith("The first panel shows")


@pytest.mark.parametrize("name", known_studies())
def test_titles_count_nothing_that_differs_between_scales(name):
    title = re.sub(r"([Ff]igure|eq\.) \d+", "", read_study(name).title)
    assert not re.search(r"(?<!= )\b\d", title)


def test_realizations_that_differ_are_a_range(tmp_path):
    data = result("fig6")
    data["realizations"][{"velocity": 0}] = 4.0
    write_datasets(tmp_path / "fig6.nc", {"": data})
    shown = section(read_study("fig6"), {"": data}, tmp_path)
    assert shown["extent"] == "default scale, 4 to 10 realizations"
    assert shown["images"] == []
    (said,) = shown["troubles"]
    assert said.startswith(f"No figure: {tmp_path}/fig6.nc: cannot be used by fig6")
    assert shown["files"] == ["fig6.nc", "fig6.csv", "fig6-columns.csv"]


def test_a_study_whose_table_cannot_be_made_says_so(tmp_path, monkeypatch):
    def refuse(*_):
        raise UserError("there is no disk")

    monkeypatch.setattr("elastomer_friction.workflow.report.page.write_tables", refuse)
    shown = section(read_study("fig6"), {"": result("fig6")}, tmp_path)
    assert shown["troubles"][1:] == ["No table: there is no disk"]
    assert shown["files"] == ["fig6.nc"]
