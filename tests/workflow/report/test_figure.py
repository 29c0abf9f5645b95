"""Drawing: the script is handed the opened result; the same result gives the same files."""

import numpy as np
import pytest
from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from tests.support.results import assert_refused, call
from tests.support.synthetic import result
from workflow.report.figure import foot_line, log_bars

OLD_FORM = "def draw(result):\n    raise AssertionError('is not called')\n"
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
        (None, "figure.py: not found; the study has no figure script"),
        (OLD_FORM, "figure.py: draw takes the path of a result; write draw(groups) instead"),
        (BROKEN, "small.nc: cannot be used by small ('there is no such group')"),
    ],
    ids=["none", "of the old form", "broken"],
)
def test_a_script_that_cannot_draw_says_why_and_leaves_no_figure_open(capsys, shown, script, said):
    (shown / "figure.py").unlink()
    if script:
        (shown / "figure.py").write_text(script)
    assert f"{shown}/{said}" in assert_refused(capsys, "figure", shown)
    assert plt.get_fignums() == []


def test_bars_are_symmetric_in_the_logarithm_and_at_most_a_decade():
    value, error = np.array([1.0, 2.0, 5.0]), np.array([0.1, 0.4, 1e9])
    below, above = log_bars(value, error)
    np.testing.assert_allclose((value + above) / value, value / (value - below), rtol=1e-12)
    np.testing.assert_allclose(above[:2], error[:2], rtol=0.15)  # small ones: the error itself
    assert (value + above)[2] == pytest.approx(50.0)


def test_the_foot_says_how_large_the_study_was():
    figure = Figure(figsize=(8.0, 3.0))
    foot_line(figure, result("fig7"), "and a note")
    (text, note) = figure._supxlabel.get_text().splitlines()
    assert text.startswith("28 grid points, 10 realizations each, seed 2014; bars: one jackknife")
    assert note == "and a note"
