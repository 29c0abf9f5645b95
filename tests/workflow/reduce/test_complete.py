"""What the result says of every task: those that failed are marked."""

import numpy as np

from elastomer_friction.workflow.reduce.complete import completed
from tests.support.small import small_plan

PLAN = small_plan('scene.quantities=["steady"]')
VARIANT = PLAN.variants[0]


def test_failed_tasks_are_marked_and_others_keep_their_values():
    count = len(VARIANT.tasks)
    sound = np.arange(1, count)
    estimates = {
        "mu_1": np.ones(count - 1),
        "samples_per_contact": np.full(count - 1, 9.0),
        "flag": np.zeros(count - 1, np.int8),
    }
    counts = np.full(count, 4, np.int32)
    found = completed(PLAN, VARIANT, estimates, sound, counts)
    assert np.isnan(found["mu_1"][0])
    assert found["flag"][0] == -1
    assert (found["mu_1"][1:] == 1.0).all()
    assert (found["rms_slope"] > 0.0).all()
    assert found["realizations"] is counts


def test_where_none_failed_estimates_are_not_copied():
    count = len(VARIANT.tasks)
    estimates = {"mu_1": np.ones(count), "samples_per_contact": np.full(count, 9.0)}
    found = completed(PLAN, VARIANT, estimates, np.arange(count), np.full(count, 4, np.int32))
    assert found["mu_1"] is estimates["mu_1"]


def test_when_a_trace_is_kept_has_an_error_only_where_it_differs_from_line_to_line():
    count = len(VARIANT.tasks)
    estimates = {"mu_1": np.ones(count), "samples_per_contact": np.full(count, 9.0)}
    estimates |= dict.fromkeys(("trace_time", "trace_velocity"), np.ones((count, 3)))
    estimates["trace_time_error"] = np.full((count, 3), [0.0, 0.0, np.nan])
    estimates["trace_velocity_error"] = np.full((count, 3), [0.0, 0.1, np.nan])
    found = completed(PLAN, VARIANT, estimates, np.arange(count), np.full(count, 4, np.int32))
    assert "trace_time_error" not in found
    assert found["trace_velocity_error"] is estimates["trace_velocity_error"]
