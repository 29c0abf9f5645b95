"""The quantity persson: beside mu_1 in a result, and the same in full contact."""

import numpy as np
import pytest

from elastomer_friction.workflow.reduce import reduce_blocks
from elastomer_friction.workflow.reduce.blocks import blocks_of, reduction_of
from elastomer_friction.workflow.reduce.complete import completed
from elastomer_friction.workflow.simulate.realizations import block_means
from tests.support.small import cut_batches, small_plan

FULL = (
    'scene.quantities=["steady", "persson"]',
    "scene.body=half-space",
    "grid.spacing=2.5e-3",  # 4 elements a side
    "grid.normal_force=1e7",
    "grid.hurst=0.7",
    "numerics.steps_per_spacing=16",
    "study.realizations=2",
)


def test_in_full_contact_it_is_mu_1():
    plan = small_plan(*FULL)
    variant = plan.variants[0]
    batch = next(b for b in cut_batches(plan, set(), 1e9) if b.tasks[0] in variant.tasks)
    actual = block_means(batch)
    tasks, how = list(batch.tasks), reduction_of(plan, variant)
    estimates = reduce_blocks(blocks_of(how, tasks, actual.scalars, actual.curves))
    rows, counts = np.arange(len(variant.tasks)), np.full(len(variant.tasks), 2, np.int32)
    whole = completed(plan, variant, estimates, rows, counts)
    assert whole["contact_fraction"] == pytest.approx(np.ones(rows.size))
    assert whole["area_persson"] == pytest.approx(np.ones(rows.size))
    assert whole["mu_persson"] == pytest.approx(whole["mu_1"], rel=0.02)
