"""Style and content of figures; the same result gives the same files."""

import matplotlib as mpl
import numpy as np
import pytest
import xarray as xr
from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from elastomer_friction.workflow.reduce.resolution import COARSE, RESOLVED, UNRESOLVED
from elastomer_friction.workflow.report.figure import write_figure
from elastomer_friction.workflow.report.in_words import unit_in_words, with_unit
from elastomer_friction.workflow.report.panels import (
    STYLE,
    error_bars,
    foot_line,
    hover_points,
    log_bars,
)
from elastomer_friction.workflow.report.usual_figure import MAX_ROWS, draw
from elastomer_friction.workflow.study.axes import COMMON_AXES
from tests.support.commands import besides_notes
from tests.support.results import assert_refused, call
from tests.support.synthetic import add, result, with_rates


@pytest.fixture(autouse=True)
def _style():
    with mpl.rc_context(STYLE):
        yield
    plt.close("all")


def test_bars_are_symmetric_in_the_logarithm_and_at_most_a_decade():
    value, error = np.array([1.0, 2.0, 5.0]), np.array([0.1, 0.4, 1e9])
    below, above = log_bars(value, error)
    np.testing.assert_allclose((value + above) / value, value / (value - below), rtol=1e-12)
    np.testing.assert_allclose(above[:2], error[:2], rtol=0.15)  # small ones: the error itself
    assert (value + above)[2] == pytest.approx(50.0)


def test_the_caption_states_size_and_seed():
    figure = Figure(figsize=(8.0, 3.0))
    foot_line(figure, result("fig7"), "And a note.")
    assert figure.get_label() == (
        "Bars show one jackknife standard error; 28 grid points, 10 realizations each, seed 2014. "
        "And a note."
    )


@pytest.fixture
def over_velocity():
    """Return a result over velocity alone."""
    dataset = result("fig7", hurst=[0.7], normal_force=[0.1])
    return dataset.isel(hurst=0, normal_force=0, spacing=0, roughness=0, velocity_step=0)


@pytest.fixture
def points(over_velocity):
    """Return a result over velocity whose first point is unresolved, and the second coarse."""
    status = np.full(over_velocity.rms_slope.shape, RESOLVED, np.int8)
    status[:2] = UNRESOLVED, COARSE
    return over_velocity.assign(resolution_status=("velocity", status))


def rings(ax):
    """Return the abscissae of all points that are drawn hollow."""
    hollow = [line for line in ax.lines if line.get_markerfacecolor() == "white"]
    return [x for line in hollow for x in line.get_xdata()]


def test_points_that_are_not_resolved_are_drawn_as_rings_of_their_colour(points):
    _, ax = plt.subplots()
    error_bars(ax, points, "rms_slope", "velocity", fmt="o", color="C3", ms=2.0)
    assert rings(ax) == points.velocity.values[:2].tolist()
    (ring,) = [line for line in ax.lines if line.get_markerfacecolor() == "white"]
    assert ring.get_marker() == "o"
    assert ring.get_markersize() > 2.0  # larger than filled ones
    assert plt.matplotlib.colors.same_color(ring.get_color(), "C3")
    _, filled = plt.subplots()
    error_bars(filled, points.isel(velocity=slice(2, None)), "rms_slope", "velocity", fmt="o")
    assert rings(filled) == []


def test_a_legend_and_the_caption_explain_hollow_markers(points):
    figure, ax = plt.subplots(layout="constrained")
    error_bars(ax, points, "rms_slope", "velocity", fmt="s")
    foot_line(figure, points)
    (legend,) = figure.legends
    (text,) = legend.get_texts()
    assert text.get_text() == "hollow: not resolved"
    message = "Hollow markers (2 of the points shown) have contacts of fewer than 4 samples."
    assert figure.get_label().endswith(message)
    plain, ax = plt.subplots(layout="constrained")
    error_bars(ax, points.isel(velocity=slice(2, None)), "rms_slope", "velocity", fmt="s")
    foot_line(plain, points)
    assert not plain.legends


def test_a_bias_is_added_to_the_bars(points):
    _, ax = plt.subplots()
    error_bars(ax, points, "rms_slope", "velocity", bias=points.rms_slope, fmt="o")
    half = [np.ptp(bar[:, 1]) / 2.0 for bar in ax.collections[0].get_segments()]
    np.testing.assert_allclose(half, points.rms_slope_error + points.rms_slope, rtol=1e-12)


@pytest.fixture
def ax():
    """Return axes from 0 to 1 that fill the figure."""
    figure = plt.figure()
    return figure.add_axes((0.0, 0.0, 1.0, 1.0), xlim=(0.0, 1.0), ylim=(0.0, 1.0))


def test_hover_points_have_the_places_and_values_of_drawn_points(ax, over_velocity):
    over_velocity = over_velocity.assign(
        share=0.5 + 0.0 * over_velocity.rms_slope, share_error=0.1 + 0 * over_velocity.rms_slope
    )
    over_velocity = over_velocity.assign_coords(
        velocity=("velocity", np.linspace(0.2, 1.4, 7), {"units": "m s-1"})
    )
    error_bars(ax, over_velocity, "share", "velocity", bias=0.05, fmt="o")
    ax.set(xlim=(0.0, 1.0), ylim=(0.0, 1.0))
    points = hover_points(ax.figure)
    assert len(points) == 5  # 0.2 ... 1.0; the others lie outside
    assert [point.x for point in points] == pytest.approx([0.2, 0.4, 0.6, 0.8, 1.0])
    assert [point.y for point in points] == pytest.approx([0.5] * 5)
    value, place = points[1].text.split("\n")
    assert value == "share = 0.5 ± 0.15"
    assert place.startswith("v₁ = 0.4 m/s, H = 0.7, F_N = 0.1 N, Δx = 2 µm, h = 10 µm")


def estimates():
    """Return a result with mu_1, jump and b over velocity, H and load."""
    data = result("fig7", hurst=[0.3, 0.5, 0.7])
    data = add(data, mu_1=data.velocity, jump=0.2 * data.velocity)
    return with_rates(data, data.speed_ratio ** (1.0 - data.hurst))


def with_curves(data):
    """Return the result with relaxation curves; those of the first velocity are lost."""
    time = xr.DataArray(np.linspace(0.0, 3.0, 9), dims="sample")
    mu = (data.mu_1 * (1.0 + 0.1 * np.exp(-time))).where(data.velocity > 2e-4)
    error = 0.01 * mu
    return data.assign(time=time + 0.0 * mu, mu=mu, deviation_error=error)


def test_estimates_are_drawn_over_the_longest_axis_with_a_colour_for_the_next_and_rows_for_others():
    figure = draw({"": estimates()})
    axes = np.reshape(figure.axes, (-1, 3))  # a row for each load
    assert len(axes) == estimates().sizes["normal_force"] > 1
    for row in axes:
        labels = [ax.get_ylabel().partition("$")[0] for ax in row]
        assert labels == ["steady friction ", "jump ", "relaxation rate "]
        assert all(len(ax.containers) == 3 for ax in row)
        assert {(ax.get_xscale(), ax.get_yscale()) for ax in row} == {("log", "log")}
    assert all("m/s" in ax.get_xlabel() for ax in axes[-1])
    assert [ax.get_title("left") for ax in axes[:, 0]] == ["$F_N$ = 0.1 N", "$F_N$ = 1 N"]
    legend = axes[0, 0].get_legend()
    assert [text.get_text() for text in legend.get_texts()] == ["H = 0.3", "H = 0.5", "H = 0.7"]


def test_the_caption_states_how_many_places_are_drawn():
    data = xr.concat(
        [estimates().assign_coords(temperature=t) for t in (0.0, 20.0, 60.0)], "temperature"
    )
    figure = draw({"": data})
    assert len(figure.axes) == 3 * MAX_ROWS
    assert "Of 6 places on the other axes 4 are drawn." in figure.get_label()
    titles = [ax.get_title("left") for ax in figure.axes]
    assert any("60" in title for title in titles)


def test_a_comparison_is_drawn_beside_the_study():
    data = estimates()
    figure = draw({"": data, "coarse": data})
    assert len(figure.axes[0].containers) == 6
    assert "coarse" in [text.get_text() for text in figure.axes[0].get_legend().get_texts()]


def test_a_single_point_has_its_curve_alone_and_its_numbers_in_the_caption():
    figure = draw({"": with_curves(estimates()).isel(velocity=[3], hurst=[0], normal_force=[0])})
    assert len(figure.axes) == 1
    assert "Estimates: µ₁ = " in figure.get_label()


def test_unresolved_traces_are_dotted_and_counted_in_the_caption():
    data = result("fig7", hurst=[0.7], normal_force=[0.1, 1.0], velocity=[0.1])
    shape = tuple(data.sizes[axis] for axis in COMMON_AXES)
    trace = np.full((*shape, 4), [0.1, 0.2, 0.3, 0.2])
    actual = {"trace_mu": trace, "trace_mu_error": 0.1 * trace, "trace_time": trace.cumsum(-1)}
    data = data.assign({name: ((*COMMON_AXES, "event"), values) for name, values in actual.items()})
    for status, dotted in (([RESOLVED] * 2, 0), ([UNRESOLVED, RESOLVED], 1), ([COARSE] * 2, 2)):
        flags = xr.DataArray(np.reshape(status, shape).astype(np.int8), dims=COMMON_AXES)
        figure = draw({"": data.assign(trace_resolution_status=flags)})
        assert sum(line.get_linestyle() == ":" for line in figure.axes[0].lines) == dotted
        message = f"Dotted curves ({dotted}) are not resolved: contacts of fewer than 4 samples"
        assert (message in figure.get_label()) == bool(dotted)


def test_points_that_failed_leave_gaps_and_what_failed_everywhere_is_not_drawn():
    data = estimates()
    some = data.assign(mu_1=data.mu_1.where(data.velocity > 2e-4))
    none = data.assign(mu_1=data.mu_1 * np.nan)
    rows = data.sizes["normal_force"]
    for failed, panels in ((some, 3), (none, 2)):
        figure = draw({"": failed})
        figure.canvas.draw()
        assert len(figure.axes) == panels * rows


@pytest.mark.parametrize(
    ("value", "unit", "said"),
    [
        (1e-5, "s", "10 µs"),
        (1e6, "Pa", "1 MPa"),
        (0.24, "m/s", "0.24 m/s"),
        (4e-3, "m/s", "4 mm/s"),
        (-30.0, "°C", "−30 °C"),
        (2e-5, "", "2·10⁻⁵"),
        (1e-6, "1/s", "10⁻⁶ 1/s"),
        (1234.0, "", "1230"),
    ],
)
def test_numbers_are_written_as_people_do(value, unit, said):
    assert with_unit(value, unit) == said


def test_units_are_written_as_people_do():
    units = {"m s-1": "m/s", "s-1": "1/s", "N m-1": "N/m", "degree_Celsius": "°C", "1": ""}
    for unit, words in units.items():
        assert unit_in_words(xr.DataArray(0.0, attrs={"units": unit})) == words


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
        assert (status, besides_notes(err)) == (0, [])
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
def test_a_script_that_cannot_draw_is_refused_and_its_figures_closed(capsys, shown, script, said):
    (shown / "figure.py").write_text(script)
    assert f"{shown}/{said}" in assert_refused(capsys, "figure", shown)
    assert plt.get_fignums() == []


def test_a_study_without_a_script_has_the_usual_figure(capsys, shown):
    (shown / "figure.py").unlink()
    status, out, err = call(capsys, "figure", shown)
    assert (status, err) == (0, "")
    assert out.split() == [str(shown / f"small.{kind}") for kind in ("png", "pdf")]
    assert b" over sliding velocity" in (shown / "small.png").read_bytes()


def test_a_given_script_draws_instead(capsys, shown, tmp_path):
    script = tmp_path / "mine.py"
    script.write_text((shown / "figure.py").read_text().replace(".plot(", ".hist("))
    call(capsys, "figure", shown)
    usual = (shown / "small.png").read_bytes()
    assert call(capsys, "figure", shown, "--script", str(script))[0] == 0
    assert (shown / "small.png").read_bytes() != usual
    message = assert_refused(capsys, "figure", shown, "--script", str(tmp_path / "none.py"))
    assert f"{tmp_path}/none.py: not found" in message


def test_several_figures_go_by_their_names(tmp_path):
    drawn = write_figure(lambda: {"": Figure(), "more": Figure()}, tmp_path / "a.nc")
    files = [file for picture in drawn for file in (picture.png, picture.pdf)]
    names = ["a.png", "a.pdf", "a-more.png", "a-more.pdf"]
    assert [file.name for file in files] == names
    assert all(file.is_file() for file in files)
