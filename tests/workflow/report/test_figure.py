"""Drawing: the script is handed the opened result; the same result gives the same files."""

import numpy as np
import pytest
from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from tests.support.results import assert_refused, call
from tests.support.synthetic import result
from workflow.reduce import RESOLVED, UNRESOLVED
from workflow.report.figure import error_bars, foot_line, log_bars

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


COARSE = 1


def partly_resolved():
    """Return a result whose first point is unresolved, whose second is coarse, and no other."""
    dataset = result("fig7", hurst=[0.7], normal_force=[0.1])
    status = np.full(dataset.rms_slope.shape, RESOLVED, np.int8)
    status.flat[:2] = UNRESOLVED, COARSE
    return dataset.assign(resolution_status=(dataset.rms_slope.dims, status))


def rings(ax):
    """Return the abscissae of all points that are drawn hollow."""
    hollow = [line for line in ax.lines if line.get_markerfacecolor() == "white"]
    return [x for line in hollow for x in line.get_xdata()]


def test_points_that_are_not_resolved_are_drawn_as_rings_of_their_colour():
    points = partly_resolved().stack(point=["velocity"]).squeeze()
    _, ax = plt.subplots()
    error_bars(ax, points, "rms_slope", "velocity", fmt="o", color="C3", ms=2.0)
    assert rings(ax) == points.velocity.values[:2].tolist()
    (ring,) = [line for line in ax.lines if line.get_markerfacecolor() == "white"]
    assert (ring.get_marker(), ring.get_markersize()) == ("o", 2.0)
    assert plt.matplotlib.colors.same_color(ring.get_color(), "C3")
    _, filled = plt.subplots()
    error_bars(filled, points.isel(point=slice(2, None)), "rms_slope", "velocity", fmt="o")
    assert rings(filled) == []
    plt.close("all")


def test_the_foot_says_how_many_points_are_hollow():
    figure = Figure(figsize=(8.0, 3.0))
    foot_line(figure, partly_resolved())
    assert figure._supxlabel.get_text().endswith("contacts of fewer than 4 samples (2 points)")


def test_a_bias_is_added_to_the_bars():
    points = result("fig7", hurst=[0.7], normal_force=[0.1]).stack(point=["velocity"]).squeeze()
    _, ax = plt.subplots()
    error_bars(ax, points, "rms_slope", "velocity", bias=points.rms_slope, fmt="o")
    half = [np.ptp(bar[:, 1]) / 2.0 for bar in ax.collections[0].get_segments()]
    np.testing.assert_allclose(half, points.rms_slope_error + points.rms_slope, rtol=1e-12)
    plt.close("all")
