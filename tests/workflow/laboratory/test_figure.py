"""The figure of a fit: data, both laws and residuals of each step, then what all say together."""

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib import pyplot as plt

from elastomer_friction.workflow.laboratory.figure import MOST_STEPS, draw_fit, figure_of
from elastomer_friction.workflow.laboratory.together import Known, fit_records
from elastomer_friction.workflow.report.panels import STYLE
from tests.workflow.laboratory.given import record, records


@pytest.fixture(autouse=True)
def _style():
    with mpl.rc_context(STYLE):
        yield
    plt.close("all")


def test_residuals_are_what_the_fit_leaves():
    fit = fit_records([record()], Known())
    upper, lower = figure_of(fit).axes
    (step,) = fit.steps
    shown = lower.lines[1].get_ydata()
    np.testing.assert_allclose(shown, step.step.after - step.curve)
    assert upper.get_title(loc="left") == "r0.txt\n0.1 to 0.12 m/s"


def test_several_steps_have_their_rates_and_jumps_drawn_with_errors(tmp_path):
    fit = fit_records(records([0.03, 0.1, 0.4]), Known())
    figure = figure_of(fit)
    assert len(figure.axes) == 2 * 3 + 2
    rates, jumps = figure.axes[-2:]
    assert len(rates.containers[0].lines[0].get_xdata()) == 3
    assert rates.get_legend().get_texts()
    assert jumps.get_legend() is not None
    files = draw_fit(fit, tmp_path / "f.png")
    assert [file.name for file in files] == ["f.png", "f.pdf"]


def test_more_steps_than_fit_on_a_page_are_said():
    fit = fit_records([record(seed, n=60, span=1.0) for seed in range(MOST_STEPS + 1)], Known())
    figure = figure_of(fit)
    assert len(figure.axes) == 2 * MOST_STEPS + 2
    assert figure._supxlabel.get_text().startswith("The first 12 of 13 steps are drawn.")


def test_a_step_without_a_rate_is_drawn_too():
    fit = fit_records([record(jump=0.02), record(1, jump=0.02)], Known())
    assert len(figure_of(fit).axes) == 4
