"""Rows of the store as they are reduced: parts by name, traces of equal length."""

import numpy as np

from elastomer_friction.workflow.reduce.blocks import blocks_of, enter
from elastomer_friction.workflow.simulate.tasks import SCALARS
from tests.support.small import small_plan
from tests.workflow.plan.test_motion import PROGRAMME, TEXT

PLAN = small_plan(PROGRAMME, "material.temperature=20.0", "grid.velocity=0.03", text=TEXT)
VARIANT = PLAN.variants[0]


def test_traces_of_tasks_are_filled_up_to_the_longest():
    tasks = VARIANT.tasks
    rows = np.ones((len(tasks), 4, PLAN.widest_row(VARIANT)))
    found = blocks_of(PLAN, VARIANT, tasks, np.ones((len(tasks), 4, len(SCALARS))), rows)
    assert found.values["trace_mu"].shape == (2, 4, VARIANT.events)
    for row in range(2):
        kept = np.isfinite(found.legs[row])
        assert np.array_equal(kept, np.isfinite(found.values["trace_mu"][row, 0]))
        assert set(np.diff(found.legs[row][kept])) == {0.0, 1.0}
    assert found.programmes == tuple(task.problem.programme for task in tasks)
    assert not found.jumps


def test_an_estimate_of_one_block_has_no_error():
    estimates = {}
    enter(estimates, "mu_1", np.array([[2.0], [3.0]]))
    assert estimates["mu_1"].tolist() == [2.0, 3.0]
    assert np.isnan(estimates["mu_1_error"]).all()
