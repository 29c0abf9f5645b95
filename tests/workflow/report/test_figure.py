"""Drawing: the script is handed the opened result; the same result gives the same files."""

import pytest
from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from elastomer_friction.workflow.report.figure import write_figure
from tests.support.results import assert_refused, call

BROKEN = """
from matplotlib import pyplot as plt

def draw(groups):
    plt.figure()
    return groups["there is no such group"]
"""


def test_the_same_result_gives_the_same_figure_as_png_and_pdf(capsys, shown):
    drawn = []
    for _ in range(2):
        status, out, err = call(capsys, "figure", shown)
        assert (status, err) == (0, "")
        assert out.split() == [str(shown / f"small.{kind}") for kind in ("png", "pdf")]
        drawn.append([(shown / f"small.{kind}").read_bytes() for kind in ("png", "pdf")])
    assert drawn[0] == drawn[1]
    assert drawn[0][0].startswith(b"\x89PNG")
    assert drawn[0][1].startswith(b"%PDF")


@pytest.mark.parametrize(
    ("script", "said"),
    [
        ("x = 1\n", "figure.py: has no function draw(groups)"),
        (BROKEN, "small.nc: cannot be used by small ('there is no such group')"),
    ],
    ids=["without draw", "broken"],
)
def test_a_script_that_cannot_draw_says_why_and_leaves_no_figure_open(capsys, shown, script, said):
    (shown / "figure.py").write_text(script)
    assert f"{shown}/{said}" in assert_refused(capsys, "figure", shown)
    assert plt.get_fignums() == []


def test_a_study_without_a_script_has_the_usual_figure(capsys, shown):
    (shown / "figure.py").unlink()
    status, out, err = call(capsys, "figure", shown)
    assert (status, err) == (0, "")
    assert out.split() == [str(shown / f"small.{kind}") for kind in ("png", "pdf")]


def test_a_script_that_is_asked_for_draws_instead(capsys, shown, tmp_path):
    script = tmp_path / "mine.py"
    script.write_text((shown / "figure.py").read_text().replace(".plot(", ".hist("))
    call(capsys, "figure", shown)
    usual = (shown / "small.png").read_bytes()
    assert call(capsys, "figure", shown, "--script", str(script))[0] == 0
    assert (shown / "small.png").read_bytes() != usual
    said = assert_refused(capsys, "figure", shown, "--script", str(tmp_path / "none.py"))
    assert f"{tmp_path}/none.py: not found" in said


def test_several_figures_go_by_their_names(tmp_path):
    files = write_figure(lambda: {"": Figure(), "more": Figure()}, tmp_path / "a.nc")
    names = ["a.png", "a.pdf", "a-more.png", "a-more.pdf"]
    assert [file.name for file in files] == names
    assert all(file.is_file() for file in files)
