"""The report: what the page holds, and what it says of results that are missing or broken."""

import base64
import re
import shutil

from tests.support.commands import output, refusal
from tests.support.small import write_study
from tests.support.synthetic import result
from workflow.report.claims import known_claims
from workflow.report.report import study_names, write_report
from workflow.result.netcdf import write_datasets
from workflow.run.measured import run_measured
from workflow.study.read import read_study

REPORTED = ("fig5", "fig8")


def page(folder):
    """Return the text of the report."""
    return (folder / "report.html").read_text(encoding="utf-8")


def test_page_is_self_contained(folder):
    text = page(folder)
    assert "<script" not in text
    assert "<link" not in text
    sources = re.findall(r'(?:src|href)="([^"]{0,30})', text)
    allowed = ("data:image/png;base64,", "#", "https://doi.org/")
    assert all(source.startswith(allowed) for source in sources)


def test_page_fits_a_phone(folder):
    text = page(folder)
    assert '<meta name="viewport" content="width=device-width, initial-scale=1">' in text
    assert "font-size: 16px" in text


def test_page_holds_the_figures(folder):
    found = re.findall(r"data:image/png;base64,([^\"]+)", page(folder))
    drawn = [(folder / f"{name}.png").read_bytes() for name in REPORTED]
    assert [base64.b64decode(image) for image in found] == drawn
    for name in REPORTED:
        assert f'alt="Figure of the study {name}: ' in page(folder)


def test_page_holds_the_claims_that_can_be_judged(folder):
    text = page(folder)
    assert text.count("holds within 0.05") == 2
    assert f"{len(known_claims()) - 4} of {len(known_claims())} claims cannot be judged" in text


def test_page_says_where_a_result_comes_from(folder):
    text = page(folder)
    for words in ("Seed", "2014", "Commit", "numpy", "10 each", "implicit-euler", "shear modulus"):
        assert words in text
    assert "0.001 … 0.7 (8 values)" in text
    assert "2·10<sup>−6</sup>" in text


def test_page_names_missing_studies_and_how_to_run_them(folder):
    text = page(folder)
    missing = [name for name in study_names() if name not in REPORTED]
    assert f"{len(missing)} of {len(missing) + 2} studies have no" in text
    for name in study_names():
        assert (f"<code>make study-{name}</code>" in text) == (name in missing)


def test_same_results_give_the_same_bytes(folder, tmp_path):
    for name in REPORTED:
        shutil.copy(folder / f"{name}.nc", tmp_path)
    assert write_report(tmp_path, []).read_bytes() == (folder / "report.html").read_bytes()


def write_bare(folder, name, **attributes):
    """Write a result without estimates: nothing can be drawn, which is quick."""
    write_datasets(folder / f"{name}.nc", {"": result(name).assign_attrs(attributes)})


def test_report_of_chosen_studies(capsys, tmp_path):
    write_bare(tmp_path, "fig6")
    assert output(capsys, "report", "fig8", "fig6", "--out", str(tmp_path)) == (
        f"{tmp_path / 'report.html'}\n"
    )
    assert "1 of 2 studies have no" in page(tmp_path)
    write_report(tmp_path, ["fig6"])
    assert 'id="missing"' not in page(tmp_path)


def test_text_of_a_result_is_escaped(tmp_path):
    write_bare(tmp_path, "fig6", title="<b>&amp; x", commit="<i>", code="other")
    write_report(tmp_path, ["fig6"])
    assert "<b>" not in page(tmp_path)
    assert "<i>" not in page(tmp_path)
    assert "&lt;b&gt;&amp;amp; x" in page(tmp_path)


def test_a_figure_that_cannot_be_drawn_leaves_the_rest(tmp_path):
    write_bare(tmp_path, "fig6")
    write_report(tmp_path, ["fig6"])
    assert "fig6.nc: cannot be used by fig6" in page(tmp_path)
    assert "normal force F<sub>N</sub>" in page(tmp_path)


def test_a_study_without_a_figure_script(finished, tmp_path):
    shutil.copy(finished.path, tmp_path)
    write_report(tmp_path, [write_study(tmp_path)])
    assert "the study has no figure script" in page(tmp_path)
    assert "coarse" in page(tmp_path)


def test_a_measured_study_shows_its_settings_and_no_time_stepping(powers, tmp_path):
    run_measured(read_study("powers"), tmp_path / "powers.nc")
    (powers / "figure.py").unlink()
    write_report(tmp_path, ["powers"])
    assert "Powers of two" in page(tmp_path)
    assert "<td>base</td><td>2.0</td>" in page(tmp_path)
    assert "Time stepping" not in page(tmp_path)


def test_an_empty_folder_is_one_line(capsys, tmp_path):
    said = refusal(capsys, "report", "--out", str(tmp_path))
    assert said.startswith(f"error: {tmp_path}: holds no result of fig2, fig3")


def test_results_of_different_code_are_pointed_out(tmp_path):
    write_bare(tmp_path, "fig6", code="0123")
    write_bare(tmp_path, "fig5")
    write_report(tmp_path, ["fig5", "fig6"])
    assert "computed by 2 versions of the numerical code" in page(tmp_path)


def test_settings_that_are_not_those_of_the_study_are_told(tmp_path):
    text = result("fig6").attrs["study"].replace('"seed": ', '"seed": 1')
    write_bare(tmp_path, "fig6", study=text)
    write_report(tmp_path, ["fig6"])
    assert "Not as in study.toml" in page(tmp_path)
    assert "study.seed" in page(tmp_path)
