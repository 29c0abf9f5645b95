"""What a run says it did: every second booked once, the costliest points first."""

import dataclasses

import numpy as np
import pytest

from elastomer_friction.workflow.run.failures import point_in_words
from elastomer_friction.workflow.run.summary import Summary
from elastomer_friction.workflow.simulate.tasks import PHASES
from tests.support.documents import without
from tests.support.small import cut_batches, random_result, small_plan

PLAN = small_plan("grid.velocity=[0.03, 0.05, 0.1]")
BATCH = next(cut_batches(PLAN, set(), 1e9))


def spent(weights):
    """Return the result of the batch whose task i took weights[i] seconds in every phase."""
    each = np.outer(weights, np.ones(len(PHASES)))
    return random_result(BATCH)._replace(spent=each, seconds=each.sum() + 1)


def counted(weights):
    """Return the summary of that batch alone."""
    summary = Summary(predicted=10.0, wall=30.0, start=5.0, workers=2, files=0.25)
    summary.count(BATCH, spent(weights))
    return summary


def test_seconds_of_phases_and_of_tasks_add_up():
    summary = counted([1.0, 5.0, 2.0, 0.5, 4.0, 3.0])
    assert sum(summary.phases.values()) == pytest.approx(summary.used)
    assert summary.phases["calls"] == pytest.approx(1.0)
    assert sum(summary.tasks.values()) == pytest.approx(summary.used - 1.0)


def test_seconds_of_other_tasks_than_those_of_the_batch_are_none_of_it():
    result = spent([1.0] * 6)
    with pytest.raises(ValueError, match="shorter"):
        Summary().count(BATCH, result._replace(spent=result.spent[1:]))


def test_the_points_that_cost_most_come_first():
    weights = [1.0, 5.0, 2.0, 0.5, 4.0, 3.0]
    lines = counted(weights).lines(PLAN)
    top = lines[lines.index("points that cost most:") + 1 :]
    for line, number in zip(top, (1, 4, 5), strict=True):
        share = weights[number] / (sum(weights) + 1.0 / len(PHASES))  # a second went in calls
        assert line.startswith(f"  {share:4.0%}  hurst=")
        problem = BATCH.tasks[number].problem
        velocity = problem.speed * 1e-4 / 1e-3
        assert f"hurst={problem.hurst:g} " in line
        assert "spacing=" not in line  # which is the same at all points
        assert f"velocity={velocity:.4g} " in line
        assert line.endswith(f"m={BATCH.tasks[number].steps_per_spacing}")


def test_shares_are_of_the_time_all_workers_had():
    (where,) = [line for line in counted([1.0] * 6).lines(PLAN) if line.startswith("start 5 s")]
    assert "then 2 workers: surfaces 12%" in where  # 6 s of 2 x 25 s
    assert "scheduling, waiting 50%" in where
    assert where.endswith("files 0.2 s in the driver")


def test_shares_of_less_than_a_second_are_shares_too():
    short = Summary(wall=0.5, start=0.1)
    idle = np.zeros((len(BATCH.tasks), len(PHASES)))
    short.count(BATCH, random_result(BATCH)._replace(spent=idle, seconds=0.1))
    (where,) = [line for line in short.lines(PLAN) if line.startswith("start 0 s")]
    assert "calls 25%, scheduling, waiting 75%" in where


def test_a_run_that_had_nothing_to_do_says_only_that():
    (said,) = Summary(reused=7, wall=1.0).lines(PLAN)
    assert "7 records reused" in said


def test_what_was_used_is_compared_with_what_was_predicted_for_it():
    begun = dataclasses.replace(counted([0.0] * 6), used=1.5 * BATCH.seconds, predicted=7200.0)
    assert begun.predicted_done == BATCH.seconds
    assert begun.lines(PLAN)[0].endswith("predicted for them (factor 1.50), of 2.0 h for the whole")
    done = dataclasses.replace(begun, written=True)
    assert done.lines(PLAN)[0].endswith("predicted for them (factor 1.50)")


def test_a_run_says_what_was_read_of_a_file_of_lines():
    left_out = ("surface.length", "grid.hurst", "grid.spacing", "grid.roughness")
    plan = small_plan('surface.file="line.csv"', text=without(*left_out, "study.realizations"))
    (said,) = [line for line in Summary().lines(plan) if line.startswith("lines: ")]
    assert said.startswith("lines: line.csv: 1 line of 10 samples, 1e-06 m apart in the mean")
    assert not any(line.startswith("lines: ") for line in Summary().lines(PLAN))


def test_a_run_states_realizations_that_were_rounded_up():
    done = dataclasses.replace(counted([0.0] * 6), tasks={})
    said = done.lines(small_plan("study.realizations=5"))
    assert "realizations: 8 each (5 rounded up to 2 blocks of 4)" in said
    assert not any(line.startswith("realizations") for line in done.lines(PLAN))


def test_a_point_of_measured_lines_names_no_hurst_exponent():
    point = {"hurst": float("nan"), "velocity": 0.1}
    assert point_in_words(point) == "velocity=0.1"
