"""The report page: its content, and its messages on missing and damaged results."""

import base64
import re
import shutil

import pytest
import xarray as xr
from markupsafe import escape

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.report import figure
from elastomer_friction.workflow.report.claims import known_claims
from elastomer_friction.workflow.report.page import (
    formula,
    section,
    study_names,
    verdict_class,
    write_report,
)
from elastomer_friction.workflow.result.netcdf import write_datasets
from elastomer_friction.workflow.run.measurement import run_measured
from elastomer_friction.workflow.store import journal
from elastomer_friction.workflow.study.read import known_studies, read_study
from tests.support.commands import output, refusal
from tests.support.synthetic import add, result
from tests.workflow.report.page.conftest import CAPTION

REPORTED = ("fig5", "fig8")


def written(folder, *names):
    """Write the report of some studies; return its text."""
    return write_report(folder, list(names)).read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def page(folder):
    """Return the text of the report that is there."""
    return (folder / "report.html").read_text(encoding="utf-8")


def test_page_is_self_contained_and_fits_a_phone(page):
    assert page.count("<script") == page.count("<script>") == 1  # none from elsewhere
    assert "<link" not in page
    sources = re.findall(r'(?:src|href)="([^"]{0,30})', page)
    allowed = ("data:image/png;base64,", "#", "https://doi.org/")
    beside = {source for source in sources if not source.startswith(allowed)}
    assert beside >= {f"{name}.{kind}" for name in REPORTED for kind in ("nc", "pdf", "csv")}
    assert '<meta name="viewport" content="width=device-width, initial-scale=1">' in page
    assert "font-size: 16px" in page


def test_links_lead_to_files_beside_the_page(folder, page):
    links = re.findall(r'href="([\w-]+\.\w+)"', page)
    assert len(links) == len(set(links)) >= 3 * len(REPORTED)
    assert all((folder / link).is_file() for link in links)


def test_page_holds_the_figures(folder, page):
    actual = re.findall(r"data:image/png;base64,([^\"]+)", page)
    drawn = [(folder / f"{name}.png").read_bytes() for name in REPORTED]
    assert [base64.b64decode(image) for image in actual] == drawn
    for name in REPORTED:
        study = read_study(name)
        assert f'alt="{escape(f"{study.title}. {CAPTION}")}"' in page


def test_page_holds_the_claims_that_can_be_judged(page):
    assert page.count("holds within 0.05") == 2
    assert f"{len(known_claims()) - 5} of {len(known_claims())} claims cannot be judged" in page


def test_page_says_where_a_result_comes_from(page):
    for words in ("Seed", "2014", "Commit", "numpy", "10 each", "implicit-euler", "shear modulus"):
        assert words in page
    assert "paper_step" in page
    assert "0.001 … 0.7 (8 values)" in page
    assert "2·10<sup>−6</sup>" in page


def test_a_heading_states_scale_and_realizations(page):
    actual = re.findall(r'<h2 id="fig\d">(.+?) <span class="extent">(.*?)</span></h2>', page)
    assert [extent for _, extent in actual] == ["default scale, 10 realizations"] * len(REPORTED)
    assert "Jump and steady friction over velocity for many normal forces" in actual[0][0]
    assert 'id="smoke"' not in page
    contents = re.search(r'aria-label="Contents">(.*?)</nav>', page, re.DOTALL)[1]
    assert '<a href="#fig5">Jump and steady friction over velocity' in contents


def test_a_caption_is_two_sentences_and_says_how_to_read_a_point(page):
    captions = re.findall(r"<figcaption>(.*?)</figcaption>", page, re.DOTALL)
    assert len(captions) == len(REPORTED)
    for words in captions:
        assert re.fullmatch(r'([A-Z].+?\.\s+){2}<span class="aid">Rest a .*', words, re.DOTALL)


def test_results_of_a_scale_have_a_page_of_their_own(capsys, tmp_path):
    data = result("fig6").assign_attrs(study=read_study("fig6", "smoke").text)
    write_datasets(tmp_path / "fig6-smoke.nc", {"": data})
    message = refusal(capsys, "report", "fig6", "--out", str(tmp_path))
    assert message == f"error: {tmp_path}: holds no result of fig6; first run: make study-NAME\n"
    out = ("--scale", "smoke", "--out", str(tmp_path))
    message = refusal(capsys, "report", "fig5", *out)
    assert message.endswith(
        "no result of fig5 at scale smoke; first run: make study-NAME SCALE=smoke\n"
    )
    path = tmp_path / "report-smoke.html"
    assert output(capsys, "report", "fig6", "fig5", *out) == f"{path}\n"
    page = path.read_text(encoding="utf-8")
    assert ">smoke scale, 10 realizations<" in page
    assert "<code>make study-fig5 SCALE=smoke</code>" in page
    assert output(capsys, "report", *out) == f"{path}\n"  # of all studies that have the scale


def test_the_report_of_an_own_study_is_about_that_study(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    message = refusal(capsys, "report", "fig5")
    assert message.endswith("holds no result of fig5; first run: python -m workflow run NAME\n")
    output(capsys, "new", "mine")
    data = add(result("fig6"), mu_1=0.1, model_ratio=0.8).assign_attrs(title="My rubber")
    write_datasets(tmp_path / "mine.nc", {"": data.assign_attrs(study=read_study("mine").text)})
    page = write_report(tmp_path, []).read_text(encoding="utf-8")
    assert "<title>My rubber</title>" in page
    assert "mu_1 of the foundation is 0.8 of that of a half-space" in page
    for words in ("What the paper says", "#claims", "make ", "have no"):
        assert words not in page
    assert '<a href="mine.html">Look through this result</a>' in page
    assert (tmp_path / "mine.html").is_file()


def test_smoke_data_have_a_banner_for_any_file_name(tmp_path):
    write_bare(tmp_path, "fig6", study=read_study("fig6", "smoke").text)
    write_bare(tmp_path, "fig5")
    page = written(tmp_path, "fig5", "fig6")
    banner = re.search(r'id="smoke">(.*?)</div>', page, re.DOTALL)[1]
    assert "fig6" in banner
    assert "fig5" not in banner
    assert page.count("These are smoke data.") == 1
    write_bare(tmp_path, "fig6", study=read_study("fig6", settings=["study.seed=7"]).text)
    page = written(tmp_path, "fig6")
    assert ">default scale with other settings, 10 realizations<" in page
    assert 'id="smoke"' not in page


def test_a_drawn_point_has_a_text_of_its_value_and_error(tmp_path):
    data = result("fig5", hurst=[0.7])
    v = xr.DataArray(data.velocity.values, dims="velocity")
    data = add(data, mu_1=v, mu_2=1.2 * v, jump=0.2 * v)
    write_datasets(tmp_path / "fig5.nc", {"": data, "paper_step": data})
    page = written(tmp_path, "fig5")
    drawn = r'<circle cx="([\d.]+)" cy="([\d.]+)" r="4"><title>(.*?)</title>'
    points = re.findall(drawn, page, re.DOTALL)
    # Panels, loads of both steps, velocities; some are below the axes.
    assert 20 < len(points) <= 2 * (2 + 3) * 7
    texts = [text for _, _, text in points]
    for name in ("µ₁", "Δµ₀/(Δv/v₁)"):
        (first, *_) = (text for text in texts if text.startswith(f"{name} = 0.01 ± 0.0001"))
        assert "\nv₁ = 10 mm/s, H = 0.7, F_N = 0.1 N, " in first
    width, height = map(int, re.search(r'viewBox="0 0 (\d+) (\d+)"', page).groups())
    assert all(0 < float(x) < width and 0 < float(y) < height for x, y, _ in points)


def test_page_names_missing_studies_and_how_to_run_them(page):
    missing = [name for name in study_names() if name not in REPORTED]
    assert f"{len(missing)} of {len(missing) + 2} studies have no" in page
    for name in study_names():
        assert (f"<code>make study-{name}</code>" in page) == (name in missing)


def test_same_results_give_the_same_bytes(folder, report, tmp_path):
    for name in REPORTED:
        shutil.copy(folder / f"{name}.nc", tmp_path)
    assert report(tmp_path).read_bytes() == (folder / "report.html").read_bytes()


def write_bare(folder, name, **attributes):
    """Write a result without estimates: nothing can be drawn, which is quick."""
    write_datasets(folder / f"{name}.nc", {"": result(name).assign_attrs(attributes)})


def test_report_of_chosen_studies_and_a_figure_that_cannot_be_drawn(capsys, tmp_path):
    write_bare(tmp_path, "fig6")
    path = tmp_path / "report.html"
    assert output(capsys, "report", "fig8", "fig6", "--out", str(tmp_path)) == f"{path}\n"
    assert "1 of 2 studies have no" in path.read_text(encoding="utf-8")
    page = written(tmp_path, "fig6")
    assert 'id="missing"' not in page
    assert "fig6.nc: cannot be used by fig6" in page
    assert "normal force F<sub>N</sub>" in page


def test_a_measured_study_shows_its_settings_and_no_time_stepping(powers, tmp_path):
    run_measured(read_study("powers"), tmp_path / "powers.nc")
    (powers / "figure.py").unlink()
    page = written(tmp_path, "powers")
    assert "Powers of two" in page
    assert "<td>base</td><td>2.0</td>" in page
    assert "Time stepping" not in page
    assert "the study has no figure script" in page


def test_an_empty_folder_is_one_line(capsys, tmp_path):
    message = refusal(capsys, "report", "--out", str(tmp_path))
    assert message.startswith(f"error: {tmp_path}: holds no result of fig2, fig3")


def test_text_of_a_result_is_escaped_and_other_code_and_settings_are_pointed_out(tmp_path):
    text = result("fig6").attrs["study"].replace('"seed": ', '"seed": 1')
    write_bare(tmp_path, "fig6", title="<b>&amp; x", commit="<i>", code="0123", study=text)
    write_bare(tmp_path, "fig5")
    page = written(tmp_path, "fig5", "fig6")
    assert "<b>" not in page
    assert "<i>" not in page
    assert "&lt;b&gt;&amp;amp; x" in page
    assert "computed by 2 versions of the numerical code" in page
    assert "Not as in study.toml" in page
    assert "study.seed" in page


SENTENCE = r"[A-Z][^.]*(?:(?:eqs?\.|\d\.\d)[^.]*)*\."


@pytest.mark.parametrize("name", known_studies())
def test_every_study_has_a_caption_of_two_sentences(name):
    assert re.fullmatch(f"{SENTENCE} {SENTENCE}", figure._script(read_study(name), None).CAPTION)


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
    (message,) = shown["troubles"]
    assert message.startswith(f"No figure: {tmp_path}/fig6.nc: cannot be used by fig6")
    assert shown["files"] == ["fig6.nc", "fig6.csv", "fig6-columns.csv"]


def test_a_study_whose_table_cannot_be_made_has_a_message(tmp_path, monkeypatch):
    def refuse(*_):
        raise UserError("there is no disk")

    monkeypatch.setattr("elastomer_friction.workflow.report.page.write_tables", refuse)
    shown = section(read_study("fig6"), {"": result("fig6")}, tmp_path)
    assert shown["troubles"][1:] == ["No table: there is no disk"]
    assert shown["files"] == ["fig6.nc"]


def test_a_result_that_was_changed_has_a_note(tmp_path):
    (tmp_path / "fig6.nc").write_bytes(b"edited")
    (tmp_path / "store").mkdir()
    journal.append(tmp_path / "store", [{"result": "fig6.nc", "digest": "0"}])
    shown = section(read_study("fig6"), {"": result("fig6")}, tmp_path)
    assert shown["troubles"][0].startswith("fig6.nc was changed or replaced since a run wrote it")


@pytest.mark.parametrize(
    ("text", "html"),
    [
        ("q_max, F_N, D_c", "q<sub>max</sub>, F<sub>N</sub>, D<sub>c</sub>"),
        ("(v q)^(H−1), x^-0.10", "(v q)<sup>H−1</sup>, x<sup>−0.10</sup>"),
        ("1.7e-06, 1e+07", "1.7·10<sup>−6</sup>, 1·10<sup>7</sup>"),
        ("x < 1 & 2 %", "x\u00a0&lt;\u00a01 &amp; 2\u00a0%"),
        ("paper_step, a-1, -1", "paper_step, a-1, −1"),
    ],
)
def test_formulas(text, html):
    assert formula(text) == html


@pytest.mark.parametrize(
    ("verdict", "colour"),
    [
        ("holds", "holds"),
        ("holds within 5 %", "holds"),
        ("holds within 0.05", "holds"),
        ("holds within a factor 1.3", "holds"),
        ("holds within 20 % (rms), 43 % at worst", "only"),
        ("holds if dx = 5.9 µm", "only"),
        ("holds for 60 % of the points", "only"),
        ("only with one implicit Euler step per dx", "only"),
        ("not found", "not"),
        ("cannot be judged: the error is too large", "cannot"),
    ],
)
def test_a_verdict_on_a_condition_is_amber(verdict, colour):
    assert verdict_class(verdict) == colour
