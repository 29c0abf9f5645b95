"""The report: what the page holds, and what it says of results that are missing or broken."""

import base64
import re
import shutil

import pytest
from matplotlib import pyplot as plt

from tests.workflow.synthetic import result, with_alpha
from workflow.cli import main
from workflow.errors import UserError
from workflow.report.page import formula
from workflow.report.report import study_names, write_report
from workflow.result.netcdf import write_datasets


@pytest.fixture(autouse=True)
def _closed_figures():
    yield
    plt.close("all")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Return a folder with a result of figure 8, alpha = 1 - H + 0.05, and its report."""
    folder = tmp_path_factory.mktemp("results")
    write_figure_8(folder)
    write_report(folder, [])
    plt.close("all")
    return folder


def write_figure_8(folder, **attributes):
    """Write a result of figure 8, with its comparison."""
    dataset = result(
        "fig8", hurst=[0.0, 0.5, 1.0], velocity=[1e-3] + [0.1 * k for k in range(1, 8)]
    )
    dataset = with_alpha(dataset, 1.05 - dataset.hurst).assign_attrs(attributes)
    write_datasets(folder / "fig8.nc", {"": dataset, "paper_step": dataset})


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


def test_page_holds_the_figure(folder):
    found = re.findall(r"data:image/png;base64,([^\"]+)", page(folder))
    assert [base64.b64decode(image) for image in found] == [(folder / "fig8.png").read_bytes()]
    assert 'alt="Figure of the study fig8: ' in page(folder)


def test_page_holds_the_claims_that_can_be_judged(folder):
    text = page(folder)
    assert text.count("holds within 0.05") == 2
    assert "9 of 11 claims cannot be judged" in text


def test_page_says_where_a_result_comes_from(folder):
    text = page(folder)
    for words in ("Seed", "2014", "Commit", "numpy", "10 each", "implicit-euler", "shear modulus"):
        assert words in text
    assert "0.001 … 0.7 (8 values)" in text
    assert "2·10<sup>−6</sup>" in text


def test_page_names_missing_studies_and_how_to_run_them(folder):
    text = page(folder)
    missing = [name for name in study_names() if name != "fig8"]
    assert f"{len(missing)} of {len(missing) + 1} studies have no" in text
    assert all(f"<code>make study-{name}</code>" in text for name in missing)
    assert "<code>make study-fig8</code>" not in text


def test_same_results_give_the_same_bytes(folder, tmp_path):
    shutil.copy(folder / "fig8.nc", tmp_path)
    assert write_report(tmp_path, []).read_bytes() == (folder / "report.html").read_bytes()


def test_report_of_chosen_studies(capsys, folder, tmp_path):
    shutil.copy(folder / "fig8.nc", tmp_path)
    assert main(["report", "fig8", "fig6", "--out", str(tmp_path)]) == 0
    assert capsys.readouterr().out == f"{tmp_path / 'report.html'}\n"
    assert "1 of 2 studies have no" in page(tmp_path)
    write_report(tmp_path, ["fig8"])
    assert 'id="missing"' not in page(tmp_path)


def test_text_of_a_result_is_escaped(tmp_path):
    write_figure_8(tmp_path, title="<b>&amp; x", commit="<i>", code="other")
    write_report(tmp_path, ["fig8"])
    assert "<b>" not in page(tmp_path)
    assert "<i>" not in page(tmp_path)
    assert "&lt;b&gt;&amp;amp; x" in page(tmp_path)


def test_a_figure_that_cannot_be_drawn_leaves_the_rest(tmp_path):
    write_datasets(tmp_path / "fig6.nc", {"": result("fig6")})
    write_report(tmp_path, ["fig6"])
    assert "fig6.nc: cannot be used by fig6" in page(tmp_path)
    assert "normal force F<sub>N</sub>" in page(tmp_path)


def test_a_study_without_a_figure_script(finished, tmp_path):
    from tests.workflow.small import write_study

    study = write_study(tmp_path)
    shutil.copy(finished.path, tmp_path)
    write_report(tmp_path, [study])
    assert "the study has no figure script" in page(tmp_path)
    assert "coarse" in page(tmp_path)


def test_an_empty_folder_is_one_line(capsys, tmp_path):
    assert main(["report", "--out", str(tmp_path)]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert err.startswith(f"error: {tmp_path}: holds no result of fig2, fig3")
    assert err.count("\n") == 1


def test_an_unknown_study_is_one_line(capsys, tmp_path):
    assert main(["report", "nowhere", "--out", str(tmp_path)]) == 2
    assert "study 'nowhere': not among" in capsys.readouterr().err


def test_files_that_are_no_results_are_refused(tmp_path):
    (tmp_path / "fig8.nc").write_text("no netCDF")
    with pytest.raises(UserError, match=r"fig8.nc: cannot be read as netCDF"):
        write_report(tmp_path, [])
    dataset = result("fig8").drop_attrs()
    write_datasets(tmp_path / "fig8.nc", {"": dataset})
    with pytest.raises(UserError, match="not a result of this program"):
        write_report(tmp_path, [])


def test_results_of_different_code_are_pointed_out(tmp_path):
    write_figure_8(tmp_path, code="0123")
    write_datasets(tmp_path / "fig6.nc", {"": result("fig6")})
    write_report(tmp_path, ["fig6", "fig8"])
    assert "computed by 2 versions of the numerical code" in page(tmp_path)


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
