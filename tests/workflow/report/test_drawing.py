"""How figures look: bars, hollow markers and what a legend says of them, the foot."""

import numpy as np
import pytest
from matplotlib import pyplot as plt
from matplotlib.figure import Figure

from elastomer_friction.workflow.reduce import RESOLVED, UNRESOLVED
from elastomer_friction.workflow.report.panels import error_bars, foot_line, log_bars
from tests.support.synthetic import result


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
    assert ring.get_marker() == "o"
    assert ring.get_markersize() > 2.0  # larger than filled ones
    assert plt.matplotlib.colors.same_color(ring.get_color(), "C3")
    _, filled = plt.subplots()
    error_bars(filled, points.isel(point=slice(2, None)), "rms_slope", "velocity", fmt="o")
    assert rings(filled) == []
    plt.close("all")


def test_a_legend_says_what_hollow_markers_are_and_how_many():
    points = partly_resolved().stack(point=["velocity"]).squeeze()
    figure, ax = plt.subplots(layout="constrained")
    error_bars(ax, points, "rms_slope", "velocity", fmt="s")
    foot_line(figure, points)
    (legend,) = figure.legends
    (text,) = legend.get_texts()
    assert text.get_text() == "hollow: contacts of fewer than 4 samples (2 of the points shown)"
    plain, ax = plt.subplots(layout="constrained")
    error_bars(ax, points.isel(point=slice(2, None)), "rms_slope", "velocity", fmt="s")
    foot_line(plain, points)
    assert not plain.legends
    plt.close("all")


def test_a_bias_is_added_to_the_bars():
    points = result("fig7", hurst=[0.7], normal_force=[0.1]).stack(point=["velocity"]).squeeze()
    _, ax = plt.subplots()
    error_bars(ax, points, "rms_slope", "velocity", bias=points.rms_slope, fmt="o")
    half = [np.ptp(bar[:, 1]) / 2.0 for bar in ax.collections[0].get_segments()]
    np.testing.assert_allclose(half, points.rms_slope_error + points.rms_slope, rtol=1e-12)
    plt.close("all")
