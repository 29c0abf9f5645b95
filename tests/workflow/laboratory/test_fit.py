"""Records in, everything that they determine out: in numbers, in sentences, as a figure."""

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib import pyplot as plt

from elastomer_friction.workflow.kinetic_law import KineticLaw
from elastomer_friction.workflow.laboratory.estimate import Estimate
from elastomer_friction.workflow.laboratory.figure import MAX_DRAWN_STEPS, figure_of_fit
from elastomer_friction.workflow.laboratory.sentences import describe, shown
from elastomer_friction.workflow.laboratory.together import Known, fit_records
from elastomer_friction.workflow.report import write_figure
from elastomer_friction.workflow.report.panels import STYLE
from tests.workflow.laboratory.given import HURST, Q_MAX, SLOPE, TAU, record, records


def test_the_law_that_made_the_records_is_found_again_and_python_takes_it():
    fit = fit_records(records([3e-3, 6e-3, 0.03, 0.1, 0.4]), Known())
    assert fit.rates is not None
    found = (fit.rates.relaxation_time, fit.rates.hurst, fit.rates.q_max, fit.slope)
    for each, true in zip(found, (TAU, HURST, Q_MAX, SLOPE), strict=True):
        assert abs(each.value - true) < 4.0 * each.error
        assert each.error < 0.2 * true
    assert not fit.rates.time_below_one
    lines = describe(fit)
    assert not any("not determined" in line for line in lines)
    (call,) = [line for line in lines if line.startswith("KineticLaw(")]
    law = eval(call, {"KineticLaw": KineticLaw})
    assert law.relaxation_times(0.1) == pytest.approx(1.0 / 25.1, rel=0.05)
    assert any("b is x, as eq. 13 has it" in line for line in lines)


def test_what_is_known_and_the_window_are_taken():
    fit = fit_records([record()], Known(relaxation_time=TAU), window=1.0)
    assert fit.rates is not None
    assert fit.rates.relaxation_time == (TAU, 0.0)
    assert fit.steps[0].step.time[-1] <= 1.0
    assert fit.known.relaxation_time == pytest.approx(TAU)


@pytest.mark.parametrize(
    ("value", "error", "text"),
    [
        (0.30123, 0.00234, "0.3012 ± 0.0023"),
        (-0.0301, 0.02, "-0.030 ± 0.020"),
        (12345.6, 240.0, "(1.235 ± 0.024)e4"),
        (1.5e-7, 2e-9, "(1.500 ± 0.020)e-7"),
        (812.3, 12.0, "812 ± 12"),
        (0.1, 0.0, "0.1"),
        (float("nan"), float("nan"), "not determined"),
    ],
)
def test_an_estimate_is_shown_to_two_digits_of_its_error(value, error, text):
    assert shown(Estimate(value, error)) == text


def test_one_step_has_a_jump_and_a_rate_and_no_tau():
    lines = describe(fit_records([record()], Known()))
    text = "\n".join(lines)
    assert lines[0] == "r0.txt: from 0.1 to 0.12 m/s"
    assert "1 step at 1 speed with a rate" in lines
    assert "  jump                    0.0" in text
    assert "  Ruina's law (eq. 6)     a = " in text
    assert "  Dieterich's law         a = " in text
    (left,) = [line for line in lines if "not determined" in line and "tau" in line]
    assert "tau, H and q_max: one speed determines one rate" in left
    assert not any(line.startswith(("  tau ", "  H ", "  q_max ")) for line in lines)


def test_nothing_that_is_not_determined_has_a_number():
    fit = fit_records([record(jump=0.02), record(1, jump=0.02)], Known())
    assert fit.rates is None
    assert len(figure_of_fit(fit).axes) == 4
    lines = describe(fit)
    assert lines[-1] == "no step determines its rate; tau, H and q_max are not determined"
    assert any(line.endswith("rate: no relaxation exceeds the noise") for line in lines)
    assert not any("nan" in line or "relaxation rate" in line for line in lines)
    low = describe(fit_records(records([2e-4, 4e-4], size=1e-6), Known()))
    assert any("the rms slope: the jumps are proportional" in line for line in low)


def test_what_is_given_drift_and_correlated_noise_are_said():
    one = record(size=1e-3, correlation=0.9)
    drifting = one._replace(friction=one.friction + 0.05 * np.minimum(one.time, 0.0))
    text = "\n".join(describe(fit_records([drifting], Known(relaxation_time=0.1))))
    assert "tau                     0.1 s, given" in text
    assert "friction still changes, by 0.05" in text
    assert "is correlated; errors are " in text


@pytest.fixture(autouse=True)
def _style():
    with mpl.rc_context(STYLE):
        yield
    plt.close("all")


def test_residuals_are_what_the_fit_leaves():
    fit = fit_records([record()], Known())
    upper, lower = figure_of_fit(fit).axes
    (step,) = fit.steps
    shown = lower.lines[1].get_ydata()
    np.testing.assert_allclose(shown, step.step.after - step.curve)
    assert upper.get_title(loc="left") == "r0.txt\n0.1 to 0.12 m/s"


def test_several_steps_have_their_rates_and_jumps_drawn_with_errors(tmp_path):
    fit = fit_records(records([0.03, 0.1, 0.4]), Known())
    figure = figure_of_fit(fit)
    assert len(figure.axes) == 2 * 3 + 2
    rates, jumps = figure.axes[-2:]
    assert len(rates.containers[0].lines[0].get_xdata()) == 3
    assert rates.get_legend().get_texts()
    assert jumps.get_legend() is not None
    (drawn,) = write_figure(lambda: figure_of_fit(fit), tmp_path / "f.png")
    assert (drawn.png.name, drawn.pdf.name) == ("f.png", "f.pdf")


def test_more_steps_than_fit_on_a_page_are_said():
    fit = fit_records(
        [record(seed, n=60, span=1.0) for seed in range(MAX_DRAWN_STEPS + 1)], Known()
    )
    figure = figure_of_fit(fit)
    assert len(figure.axes) == 2 * MAX_DRAWN_STEPS + 2
    assert figure.get_label().startswith("The first 12 of 13 steps are drawn.")
