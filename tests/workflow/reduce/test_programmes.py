"""Estimates of programmes from known traces: peaks, healing, loops and energy balances."""

import math

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from elastomer_friction.kernels import Hold, Oscillation, Slide
from elastomer_friction.workflow.reduce.blocks import Blocks
from elastomer_friction.workflow.reduce.extremum import extremum
from elastomer_friction.workflow.reduce.healing import healing, last_hold
from elastomer_friction.workflow.reduce.loop import loop
from elastomer_friction.workflow.reduce.traces import reduce_programmes, reduce_steps


@given(st.floats(0.06, 0.94), st.floats(-3.0, 3.0), st.sampled_from([1.0, -1.0]))
@example(0.08, 1.0, 1.0)  # the largest sample is the second
@example(0.92, 1.0, 1.0)  # the last but one
def test_the_peak_of_a_parabola_is_found_on_any_samples(place, height, sign):
    x = np.array([0.0, 0.1, 0.15, 0.4, 0.7, 0.9, 1.0])
    curves = height - sign * (x - place) ** 2 + np.zeros((3, 1))
    value, where = extremum(x, curves, sign)
    assert value == pytest.approx(np.full(3, height), abs=1e-12)
    assert where == pytest.approx(np.full(3, place), abs=1e-12)


def test_at_an_end_the_sample_is_the_peak_and_nan_stays_nan():
    curves = np.array([[3.0, 2.0, 1.0], [1.0, 2.0, 3.0], [1.0, np.nan, 2.0], [2.0, 2.0, 2.0]])
    value, where = extremum(np.arange(3.0), curves, 1.0)
    assert value.tolist()[:2] == [3.0, 3.0]
    assert where.tolist()[:2] == [0.0, 2.0]
    assert np.isnan([value[2], where[2]]).all()
    assert value[3] == 2.0


HOLDING = (Slide(-2.0, 3.0), Hold(5.0), Slide(-2.0, 4.0))
HOLD_TRACES = (  # leg, distance and friction of the samples
    np.array([[0.0, 0, 1, 1, 2, 2, 2, 2]]),
    np.array([[0.0, -3, -3, -3, -4, -5, -6, -7]]),
    -np.array([[0.4, 0.5, 0.3, 0.2, 0.6, 0.8, 0.7, 0.5]]),
)


def test_peak_and_end_of_the_hold_have_the_sign_of_the_motion():
    actual = healing(HOLDING, *HOLD_TRACES)
    assert actual.mu_end_of_hold.tolist() == [-0.2]
    assert actual.static_peak[0] == pytest.approx(-0.8, abs=0.01)
    assert actual.healing[0] == actual.static_peak[0] + 0.5
    assert actual.peak_distance[0] == pytest.approx(2.2, abs=0.1)


def test_the_last_hold_that_is_slid_after_counts():
    twice = (*HOLDING, Hold(1.0), Slide(3.0, 1.0), Hold(1.0))
    assert last_hold(HOLDING) == (1, -2.0)
    assert last_hold(twice) == (3, 3.0)


@pytest.mark.parametrize("programme", [(Slide(1.0, 1.0),), (Hold(1.0), Hold(1.0))])
def test_healing_is_nan_without_a_hold_before_a_slide(programme):
    assert np.isnan(healing(programme, *HOLD_TRACES)).all()


SWINGING = (Slide(2.0, 3.0), Hold(0.7), Oscillation(0.0, 0.4, 0.5, 3))
START, PERIOD = 2.2, 2.0


def cycles(count):
    """Return times, phases and the displacement of three cycles, ``count`` samples each."""
    time = START + PERIOD * np.arange(1, 3 * count + 1) / count
    phase = math.pi * (time - START)
    return time, phase


@pytest.mark.parametrize("count", [16, 64])
def test_the_response_in_the_last_cycle_is_found(count):
    time, phase = cycles(count)
    decay = np.where(time < START + 2.0 * PERIOD, 3.0, 1.0)  # earlier cycles do not count
    mu = decay * (0.3 * np.sin(phase) + 0.2 * np.cos(phase) + 0.05 * np.sin(3.0 * phase) + 0.7)
    actual = loop(SWINGING, time[None], mu[None], mu[None])
    assert actual.mu_in_phase[0] == pytest.approx(0.3, rel=1e-9)
    assert actual.mu_quadrature[0] == pytest.approx(0.2, rel=1e-9)
    assert actual.loop_work[0] == pytest.approx(math.pi * 0.4 * 0.2, rel=1e-9)


def test_work_is_that_of_a_force_along_the_whole_way():
    programme = (Oscillation(1.5, 0.1, 2.0, 2),)
    time = np.arange(1, 33) / 32.0
    actual = loop(programme, time[None], np.ones((2, 32)), np.ones((2, 32)))
    assert actual.loop_work == pytest.approx([0.75, 0.75])  # force times mean speed times period


def test_the_loop_is_nan_without_oscillation_or_samples():
    time, phase = cycles(16)
    assert np.isnan(loop(SWINGING[:2], time[None], phase[None], phase[None])).all()
    assert np.isnan(loop(SWINGING, time[None, :5], phase[None, :5], phase[None, :5])).all()


EVENTS = 5
TIME = np.array([[0.0, 1.0, 2.0, 3.0, np.nan]])
ALIKE = np.repeat(TIME[:, None, :], 3, axis=1)  # in every block
MOVED = {"trace_time": ALIKE, "trace_distance": 0.7 * ALIKE, "trace_velocity": 0.0 * ALIKE + 0.7}
LEGS = 0.0 * TIME
TRACES = ("trace_mu", "trace_indentation", "trace_contact_fraction")
TRACES += ("trace_normal_force", "trace_friction_force")


def blocks(quantities, noise=0.0, **values):
    """Return one task of three blocks with parts of its row."""
    rng = np.random.default_rng(3)
    made = {name: value + noise * rng.standard_normal((1, 3, 1)) for name, value in values.items()}
    speeds, programmes = np.array([[1.0, 2.0]]), ((Slide(2.0, 6.0),),)
    slopes, scalars = np.ones(1), np.zeros((1, 3, 6))
    how = quantities, False, speeds, programmes, LEGS
    return Blocks(scalars, MOVED | made, TIME[:, 1:], slopes, *how)


def test_the_balance_is_taken_at_the_last_sample_that_is_there():
    way = TIME[:, None, :]
    energies = {
        "stored_energy": 5.0 + way,
        "dissipated_energy": 2.0 * way,
        "work": 3.3 * way,
        "closing_work": 0.1 * way,
    }
    estimates = {}
    reduce_programmes(estimates, blocks(("energy",), **energies))
    assert estimates["balance_residual"] == pytest.approx([(9.9 - 3.0 - 6.0 - 0.3) / 6.0])
    assert estimates["trace_segment"].tolist() == [[0, 0, 0, 0, -1]]


def test_traces_are_means_with_errors_and_only_on_request():
    estimates = {}
    trace = np.broadcast_to(TIME[:, None, :], (1, 3, EVENTS))
    reduce_programmes(estimates, blocks(("steady",), trace_mu=trace))
    assert not estimates
    reduce_programmes(estimates, blocks(("trace",), 0.01, **dict.fromkeys(TRACES, trace)))
    assert estimates["trace_mu"][0, :4] == pytest.approx([0.0, 1.0, 2.0, 3.0], abs=0.05)
    assert (estimates["trace_mu_error"][0, :4] > 0.0).all()


def test_times_and_positions_are_exact_for_equal_motions_else_means_with_errors():
    parts = dict.fromkeys(TRACES, np.zeros((1, 3, EVENTS)))
    slower = MOVED["trace_velocity"] - np.array([0.0, 0.1, 0.2])[:, None]
    estimates = {}
    reduce_programmes(estimates, blocks(("trace",), **parts, trace_velocity=slower))
    for name in ("trace_time", "trace_distance"):
        np.testing.assert_array_equal(estimates[name], MOVED[name][:, 0])
        assert (estimates[f"{name}_error"][0, :4] == 0.0).all()
    assert estimates["trace_velocity"][0, :4] == pytest.approx([0.6] * 4)
    assert estimates["trace_velocity_error"][0, :4] == pytest.approx([0.1 / np.sqrt(3.0)] * 4)


def test_a_change_counts_from_the_leg_before_and_its_error_is_that_of_the_difference():
    trace = np.array([1.0, 2.0, 5.0, 7.0, np.nan]) + np.arange(3.0)[None, :, None]
    legs = np.array([[0.0, 0.0, 1.0, 1.0, np.nan]])
    actual = blocks(("trace",), **dict.fromkeys(TRACES, trace))._replace(legs=legs)
    estimates = {}
    reduce_programmes(estimates, actual)
    for name in ("trace_mu", "trace_indentation"):
        assert estimates[f"{name}_change"][0, :4] == pytest.approx([0.0, 1.0, 3.0, 5.0])
        assert estimates[f"{name}_change_error"][0, :4] == pytest.approx(0.0, abs=1e-12)
        assert (estimates[f"{name}_error"][0, :4] > 0.5).all()


def test_the_peak_is_that_above_the_friction_before():
    time = np.linspace(0.0, 2.0, 41)[None]
    curves = (1.0 + 0.5 * time * np.exp(1.0 - time))[:, None, :] + np.zeros((1, 4, 1))
    before, after = np.ones((1, 4)), np.full((1, 4), 1.1)
    estimates = {}
    actual = blocks(("peak",))._replace(values={"initial_rate": np.ones((1, 3))})
    reduce_steps(estimates, actual, time, curves, {"mu_1": before, "mu_2": after})
    assert estimates["peak"] == pytest.approx([0.5], rel=1e-3)
    assert estimates["peak_time"] == pytest.approx([1.0], rel=1e-3)
    assert estimates["initial_rate"].tolist() == [1.0]


@pytest.mark.parametrize(
    ("before", "after", "expected"),
    [(1.0, 2.0, -0.1), (-1.0, -2.0, 0.1), (1.0, 1.0, np.nan), (1.0, -2.0, np.nan)],
)
def test_a_minus_b_is_the_slope_of_steady_friction(before, after, expected):
    """For backward sliding friction is negative, so that weakening is an increase."""
    time = np.linspace(0.0, 2.0, 41)[None]
    change = -0.1 * np.log(2.0)
    steady = {"mu_1": np.full((1, 4), before), "mu_2": np.full((1, 4), before + change)}
    curves = steady["mu_2"][..., None] + np.zeros((1, 4, time.size))
    estimates = {}
    actual = blocks(("rate_state",))._replace(speeds=np.array([[before, after]]))
    reduce_steps(estimates, actual, time, curves, steady)
    assert estimates["rate_state_a_minus_b"] == pytest.approx([expected], nan_ok=True)
    assert estimates["rate_state_a_minus_b_error"] == pytest.approx(
        [0.0 * expected], nan_ok=True, abs=1e-12
    )


def of_blocks(programme, leg, **values):
    """Return blocks of one task with a programme, its legs and parts of its row."""
    made = MOVED | {name: np.array([each]) for name, each in values.items()}
    return blocks(("healing", "loop", "contact_lengths"))._replace(
        values=made, legs=np.array([leg]), programmes=(programme,)
    )


def test_every_task_has_its_peak_its_loop_and_its_contacts_with_errors():
    swing = Oscillation(1.0, 0.0, 1.0, 1)  # a steady slide: the work is the force times the way
    programme = (Slide(2.0, 0.0), Hold(0.5), Slide(2.0, 1.0), swing)
    trace = np.array([[0.2, 0.1, 0.6, 0.4, np.nan]]) + 0.1 * np.arange(3.0)[:, None]
    lengths = np.array([[1.0, 2.0], [3.0, 2.0], [5.0, 2.0]])
    estimates = {}
    actual = of_blocks(
        programme,
        [0.0, 1.0, 2.0, 2.0, np.nan],
        trace_mu=trace,
        trace_friction_force=trace,
        contact_length=lengths,
    )
    reduce_programmes(estimates, actual)
    error = 0.1 / np.sqrt(3.0)  # of the mean of three
    assert estimates["mu_end_of_hold"] == pytest.approx([0.2])
    assert estimates["mu_end_of_hold_error"] == pytest.approx([error])
    assert estimates["static_peak"] == pytest.approx([0.7])
    assert estimates["static_peak_error"] == pytest.approx([error])
    assert np.isnan(estimates["loop_work"]).all()  # of four samples
    assert estimates["contact_length"].tolist() == [[3.0, 2.0]]
    assert estimates["contact_length_error"] == pytest.approx(np.array([[2.0 / np.sqrt(3.0), 0.0]]))
