"""Reduction of block means to estimates with errors, biases and flags, task by task."""

import numpy as np
import pytest

from elastomer_friction.workflow.plan.error_laws import LAWS
from elastomer_friction.workflow.reduce.blocks import blocks_of, enter, reduction_of
from elastomer_friction.workflow.reduce.complete import completed
from elastomer_friction.workflow.reduce.estimates import reduce_blocks
from elastomer_friction.workflow.reduce.fits import FITTED
from elastomer_friction.workflow.reduce.resolution import (
    COARSE,
    RESOLVED,
    UNRESOLVED,
    resolution,
    resolution_status,
)
from elastomer_friction.workflow.simulate import Problem, Task
from elastomer_friction.workflow.simulate.tasks import SCALARS
from elastomer_friction.workflow.study import Numerics
from tests.support.curves import RATE, exponential_blocks
from tests.support.small import HOLDING, PROGRAMME, small_plan

PLAN = small_plan(PROGRAMME, "material.temperature=20.0", "grid.velocity=0.03", text=HOLDING)
VARIANT = PLAN.variants[0]


def test_traces_of_tasks_are_filled_up_to_the_longest():
    tasks = VARIANT.tasks
    rows = np.ones((len(tasks), 4, PLAN.widest_row(VARIANT)))
    scalars = np.ones((len(tasks), 4, len(SCALARS)))
    actual = blocks_of(reduction_of(VARIANT), tasks, scalars, rows)
    assert actual.values["trace_mu"].shape == (2, 4, VARIANT.events)
    for row in range(2):
        kept = np.isfinite(actual.legs[row])
        assert np.array_equal(kept, np.isfinite(actual.values["trace_mu"][row, 0]))
        assert set(np.diff(actual.legs[row][kept])) == {0.0, 1.0}
    assert actual.programmes == tuple(task.problem.programme for task in tasks)
    assert not actual.jumps


def test_an_estimate_of_one_block_has_no_error():
    estimates = {}
    enter(estimates, "mu_1", np.array([[2.0], [3.0]]))
    assert estimates["mu_1"].tolist() == [2.0, 3.0]
    assert np.isnan(estimates["mu_1_error"]).all()


BLOCKS = exponential_blocks()
FOUND = reduce_blocks(BLOCKS)
COUNT = BLOCKS.scalars.shape[1]


VALUES = dict(zip(SCALARS, np.moveaxis(BLOCKS.scalars, 2, 0), strict=True))
VALUES = {name: values for name, values in VALUES.items() if name in FOUND}
START = VALUES["mu_1"] + VALUES["jump"]  # just after the jump
VALUES["mu"] = np.concatenate([START[..., None], BLOCKS.values["curve"]], axis=2)
VALUES["deviation"] = VALUES["mu"] - VALUES["mu_2"][..., None]


@pytest.mark.parametrize("name", VALUES)
def test_estimate_is_the_mean_and_its_error_the_classical_one(name):
    values = VALUES[name]
    np.testing.assert_allclose(FOUND[name], values.mean(axis=1), rtol=1e-12, atol=1e-14)
    classical = values.std(axis=1, ddof=1) / np.sqrt(COUNT)
    np.testing.assert_allclose(FOUND[f"{name}_error"], classical, rtol=1e-6, atol=1e-14)


def test_curve_starts_just_after_the_jump():
    assert FOUND["time"][:, 0].tolist() == [0.0] * 3
    assert np.array_equal(FOUND["time"][:, 1:], BLOCKS.time, equal_nan=True)


def test_rate_of_each_task_is_found_with_mu_2_known_and_free():
    assert FOUND["fit_status"].tolist() == [FITTED] * 3
    expected = RATE * np.array([1.0, 2.0, 3.0])
    np.testing.assert_allclose(FOUND["relaxation_rate"], expected, rtol=1e-6)
    np.testing.assert_allclose(FOUND["relaxation_rate_free"], expected, rtol=1e-5)


def test_amplitude_varies_as_the_curves_do():
    shares = VALUES["deviation"][0, :, 1] * np.exp(RATE * BLOCKS.time[0, 0])
    assert FOUND["amplitude"][0] == pytest.approx(shares.mean(), rel=1e-6)
    error = shares.std(ddof=1) / np.sqrt(COUNT)
    assert FOUND["amplitude_error"][0] == pytest.approx(error, rel=1e-4)


def test_reduction_of_a_task_does_not_depend_on_other_tasks():
    alone = reduce_blocks(
        BLOCKS._replace(
            scalars=BLOCKS.scalars[1:2],
            values={"curve": BLOCKS.values["curve"][1:2]},
            time=BLOCKS.time[1:2],
            rms_slope=BLOCKS.rms_slope[1:2],
        )
    )
    for name, values in alone.items():
        assert values.tobytes() == FOUND[name][1:2].tobytes()


STEADY_PLAN = small_plan('scene.quantities=["steady"]')
STEADY_VARIANT = STEADY_PLAN.variants[0]


def test_failed_tasks_are_marked_and_others_keep_their_values():
    count = len(STEADY_VARIANT.tasks)
    sound = np.arange(1, count)
    estimates = {
        "mu_1": np.ones(count - 1),
        "samples_per_contact": np.full(count - 1, 9.0),
        "flag": np.zeros(count - 1, np.int8),
    }
    counts = np.full(count, 4, np.int32)
    actual = completed(STEADY_PLAN, STEADY_VARIANT, estimates, sound, counts)
    assert np.isnan(actual["mu_1"][0])
    assert actual["flag"][0] == -1
    assert (actual["mu_1"][1:] == 1.0).all()
    assert (actual["rms_slope"] > 0.0).all()
    assert actual["realizations"] is counts


JUDGED = ("mu_1", "jump", "relaxation_rate")
PROBLEM = Problem(0.7, 1000, 0.1, 1.0, 1.2)
AUTO = Numerics()


def resolved(steps=8, numerics=AUTO, samples=12.0, problem=PROBLEM):
    """Return the resolution of one task with b = 2 and a number of samples per contact."""
    estimates = {"samples_per_contact": np.array([samples]), "relaxation_rate": np.array([2.0])}
    return resolution([Task(problem, steps, 100, "key")], estimates, JUDGED, numerics)


def test_status_follows_the_samples_per_contact():
    status = resolution_status(np.array([0.5, 1.0, 1.5, 3.9, 4.0, 1e3, np.nan]))
    assert status.tolist() == [UNRESOLVED] * 2 + [COARSE] * 2 + [RESOLVED] * 2 + [-1]


def test_biases_follow_the_laws_and_fall_with_finer_steps():
    coarse, fine = resolved(8), resolved(64)
    for name in JUDGED[:2]:
        assert coarse[f"{name}_bias"] == LAWS[name].error(PROBLEM, 8)
    for name in JUDGED:
        finer = name == "relaxation_rate"  # steady friction and jumps are followed at both
        assert 0.0 < fine[f"{name}_bias"] <= coarse[f"{name}_bias"]
        assert (fine[f"{name}_bias"] < coarse[f"{name}_bias"]) == finer
        assert coarse["bias_bound"] >= coarse[f"{name}_bias"]


def test_each_task_has_a_bound_of_its_own():
    tasks = [Task(PROBLEM, steps, 100, "key") for steps in (8, 64)]
    estimates = {"samples_per_contact": np.full(2, 12.0), "relaxation_rate": np.full(2, 2.0)}
    both = resolution(tasks, estimates, JUDGED, AUTO)
    expected = [resolved(steps)["bias_bound"].item() for steps in (8, 64)]
    assert both["bias_bound"].tolist() == expected


def test_bias_of_the_rate_follows_the_measured_contacts():
    assert (
        resolved(samples=2.0)["relaxation_rate_bias"]
        > resolved(samples=50.0)["relaxation_rate_bias"]
    )


def test_given_steps_have_the_bias_of_their_samples():
    light = PROBLEM._replace(load=1e-3, speed=100.0)
    given, chosen = (
        resolved(4, Numerics(steps_per_spacing=4), problem=light),
        resolved(4, problem=light),
    )
    for name in ("mu_1", "jump"):
        assert given[f"{name}_bias"] > 10.0 * chosen[f"{name}_bias"]
    assert given["relaxation_rate_bias"] == chosen["relaxation_rate_bias"]


def test_no_bias_is_beyond_the_value_itself():
    assert resolved(1, samples=0.5)["bias_bound"] == 1.0


def test_no_law_is_known_for_lines_that_were_measured():
    measured = PROBLEM._replace(surface=PROBLEM.surface._replace(measured="lines"))
    assert np.isnan(resolved(problem=measured)["mu_1_bias"]).all()


def test_sample_times_have_errors_only_if_they_differ_between_lines():
    count = len(STEADY_VARIANT.tasks)
    estimates = {"mu_1": np.ones(count), "samples_per_contact": np.full(count, 9.0)}
    estimates |= dict.fromkeys(("trace_time", "trace_velocity"), np.ones((count, 3)))
    estimates["trace_time_error"] = np.full((count, 3), [0.0, 0.0, np.nan])
    estimates["trace_velocity_error"] = np.full((count, 3), [0.0, 0.1, np.nan])
    actual = completed(
        STEADY_PLAN, STEADY_VARIANT, estimates, np.arange(count), np.full(count, 4, np.int32)
    )
    assert "trace_time_error" not in actual
    assert actual["trace_velocity_error"] is estimates["trace_velocity_error"]
