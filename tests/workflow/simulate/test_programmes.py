"""Programmes in batches: the same bits whatever the cut, and steady values of their own slides."""

import numpy as np
import pytest

from tests.support.small import cut_batches, small_plan
from tests.workflow.plan.test_motion import PROGRAMME, TEXT
from workflow.simulate.realizations import block_means
from workflow.simulate.tasks import SCALARS

SMALL = "material.temperature=20.0", "grid.velocity=0.03", "numerics.samples=16"
PLAN = small_plan(PROGRAMME, *SMALL, "numerics.steps_per_spacing=1", text=TEXT)


def records(target):
    """Return (key, block) -> scalars and row of all records, in batches of a length."""
    found = {}
    for batch in cut_batches(PLAN, set(), target):
        done = block_means(batch)
        for row, task in enumerate(batch.tasks):
            for block in range(batch.blocks):
                width = PLAN.widest_row(PLAN.variants[0])
                values = np.full(width, np.nan)
                values[: done.curves.shape[2]] = done.curves[row, block]
                place = task.key, batch.first_block + block
                found[place] = done.scalars[row, block].tobytes(), values.tobytes()
    return found


def test_no_batching_shows():
    whole = records(1e9)
    assert len(whole) == 2 * 2
    assert records(1e-9) == whole


def test_mu_1_and_mu_2_belong_to_the_first_and_the_last_slide():
    """Without a velocity step in a row, as there is a hold between them."""
    batch = next(cut_batches(PLAN, set(), 1e9))
    scalars = dict(zip(SCALARS, block_means(batch).scalars[0, 0], strict=True))
    fast = small_plan(
        "scene.programme=[{slide={ratio=2.0, distance=1e-3}}]",
        *SMALL,
        "numerics.steps_per_spacing=1",
        text=TEXT,
    )
    other = next(cut_batches(fast, set(), 1e9))
    expected = dict(zip(SCALARS, block_means(other).scalars[0, 0], strict=True))
    assert scalars["mu_2"] == pytest.approx(expected["mu_1"], rel=1e-12)
    assert scalars["mu_1"] != pytest.approx(scalars["mu_2"], rel=1e-3)
