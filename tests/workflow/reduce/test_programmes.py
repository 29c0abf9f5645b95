"""What a programme was asked for, from block means that are known."""

import numpy as np
import pytest

from elastomer_friction.kernels import Hold, Oscillation, Slide
from elastomer_friction.workflow.reduce.blocks import Blocks
from elastomer_friction.workflow.reduce.traces import reduce_programmes, reduce_steps

EVENTS = 5
TIME = np.array([[0.0, 1.0, 2.0, 3.0, np.nan]])
ALIKE = np.repeat(TIME[:, None, :], 3, axis=1)  # in every block
MOVED = {"trace_time": ALIKE, "trace_distance": 0.7 * ALIKE, "trace_velocity": 0.0 * ALIKE + 0.7}
LEGS = 0.0 * TIME


def blocks(quantities, **values):
    """Return one task of three blocks with parts of its row."""
    rng = np.random.default_rng(3)
    made = {name: value + 0.01 * rng.standard_normal((1, 3, 1)) for name, value in values.items()}
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
    found = blocks(("energy",), **energies)
    made = {name: v + np.zeros((1, 3, 1)) for name, v in energies.items()}
    found = found._replace(values=MOVED | made)
    reduce_programmes(estimates, found)
    assert estimates["balance_residual"] == pytest.approx([(9.9 - 3.0 - 6.0 - 0.3) / 6.0])
    assert estimates["trace_segment"].tolist() == [[0, 0, 0, 0, -1]]


def test_traces_are_means_with_errors_and_nothing_else_is_there():
    estimates = {}
    trace = np.broadcast_to(TIME[:, None, :], (1, 3, EVENTS))
    reduce_programmes(estimates, blocks(("steady",), trace_mu=trace))
    assert not estimates
    names = ("mu", "indentation", "normal_force", "friction_force", "contact_fraction")
    parts = {f"trace_{name}": trace for name in names}
    reduce_programmes(estimates, blocks(("trace",), **parts))
    assert estimates["trace_mu"][0, :4] == pytest.approx([0.0, 1.0, 2.0, 3.0], abs=0.05)
    assert (estimates["trace_mu_error"][0, :4] > 0.0).all()


def test_when_and_where_is_exact_where_all_lines_move_alike_and_else_a_mean_with_its_error():
    trace = np.zeros((1, 3, EVENTS))
    others = ("mu", "indentation", "normal_force", "friction_force", "contact_fraction")
    parts = {f"trace_{name}": trace for name in others}
    slower = MOVED["trace_velocity"] - np.array([0.0, 0.1, 0.2])[:, None]
    estimates = {}
    found = blocks(("trace",), **parts, trace_velocity=slower)
    reduce_programmes(estimates, found._replace(values=MOVED | parts | {"trace_velocity": slower}))
    for name in ("trace_time", "trace_distance"):
        np.testing.assert_array_equal(estimates[name], MOVED[name][:, 0])
        assert (estimates[f"{name}_error"][0, :4] == 0.0).all()
    assert estimates["trace_velocity"][0, :4] == pytest.approx([0.6] * 4)
    assert estimates["trace_velocity_error"][0, :4] == pytest.approx([0.1 / np.sqrt(3.0)] * 4)


def test_a_change_counts_from_the_leg_before_and_its_error_is_that_of_the_difference():
    trace = np.array([1.0, 2.0, 5.0, 7.0, np.nan]) + np.arange(3.0)[None, :, None]
    parts = dict.fromkeys(("trace_normal_force", "trace_friction_force"), trace)
    parts |= dict.fromkeys(("trace_mu", "trace_indentation", "trace_contact_fraction"), trace)
    legs = np.array([[0.0, 0.0, 1.0, 1.0, np.nan]])
    found = blocks(("trace",), **parts)._replace(values=MOVED | parts, legs=legs)
    estimates = {}
    reduce_programmes(estimates, found)
    for name in ("trace_mu", "trace_indentation"):
        assert estimates[f"{name}_change"][0, :4] == pytest.approx([0.0, 1.0, 3.0, 5.0])
        assert estimates[f"{name}_change_error"][0, :4] == pytest.approx(0.0, abs=1e-12)
        assert (estimates[f"{name}_error"][0, :4] > 0.5).all()


def test_the_peak_is_that_above_the_friction_before():
    time = np.linspace(0.0, 2.0, 41)[None]
    curves = (1.0 + 0.5 * time * np.exp(1.0 - time))[:, None, :] + np.zeros((1, 4, 1))
    before, after = np.ones((1, 4)), np.full((1, 4), 1.1)
    estimates = {}
    found = blocks(("peak",), initial_rate=np.ones((1, 3)))
    found = found._replace(values={"initial_rate": np.ones((1, 3))})
    reduce_steps(estimates, found, time, curves, {"mu_1": before, "mu_2": after})
    assert estimates["peak"] == pytest.approx([0.5], rel=1e-3)
    assert estimates["peak_time"] == pytest.approx([1.0], rel=1e-3)
    assert estimates["initial_rate"].tolist() == [1.0]


@pytest.mark.parametrize(
    ("before", "after", "expected"),
    [(1.0, 2.0, -0.1), (-1.0, -2.0, 0.1), (1.0, 1.0, np.nan), (1.0, -2.0, np.nan)],
)
def test_a_minus_b_is_the_slope_of_steady_friction(before, after, expected):
    """Sliding back, friction is negative: weakening is then a rise."""
    time = np.linspace(0.0, 2.0, 41)[None]
    change = -0.1 * np.log(2.0)
    steady = {"mu_1": np.full((1, 4), before), "mu_2": np.full((1, 4), before + change)}
    curves = steady["mu_2"][..., None] + np.zeros((1, 4, time.size))
    estimates = {}
    found = blocks(("rate_state",))._replace(speeds=np.array([[before, after]]))
    reduce_steps(estimates, found, time, curves, steady)
    assert estimates["rate_state_a_minus_b"] == pytest.approx([expected], nan_ok=True)
    assert estimates["rate_state_a_minus_b_error"] == pytest.approx(
        [0.0 * expected], nan_ok=True, abs=1e-12
    )


def of_blocks(programme, leg, **values):
    """Return blocks of one task that took a programme, and what is asked of its legs."""
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
    found = of_blocks(
        programme,
        [0.0, 1.0, 2.0, 2.0, np.nan],
        trace_mu=trace,
        trace_friction_force=trace,
        contact_length=lengths,
    )
    reduce_programmes(estimates, found)
    error = 0.1 / np.sqrt(3.0)  # of the mean of three
    assert estimates["mu_end_of_hold"] == pytest.approx([0.2])
    assert estimates["mu_end_of_hold_error"] == pytest.approx([error])
    assert estimates["static_peak"] == pytest.approx([0.7])
    assert estimates["static_peak_error"] == pytest.approx([error])
    assert np.isnan(estimates["loop_work"]).all()  # of four samples
    assert estimates["contact_length"].tolist() == [[3.0, 2.0]]
    assert estimates["contact_length_error"] == pytest.approx(np.array([[2.0 / np.sqrt(3.0), 0.0]]))
