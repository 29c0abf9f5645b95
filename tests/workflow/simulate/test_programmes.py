"""Programmes in batches: the same bits whatever the cut, and steady values of their own slides."""

from dataclasses import replace

import numpy as np
import pytest

from elastomer_friction.kernels import MOTION, QUARTET, Line, amplitudes, draw_phases, run_scene
from elastomer_friction.workflow.simulate import realizations
from elastomer_friction.workflow.simulate.drawing import line_generator
from elastomer_friction.workflow.simulate.kept import kept_steps
from elastomer_friction.workflow.simulate.layout import row_layout, unpack
from elastomer_friction.workflow.simulate.programmes import scene_of
from elastomer_friction.workflow.simulate.realizations import block_means
from elastomer_friction.workflow.simulate.tasks import PHASES, SCALARS
from tests.support.small import cut_batches, small_plan
from tests.workflow.plan.test_motion import PROGRAMME, TEXT

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


def test_a_trace_is_the_mean_over_the_lines_of_its_block():
    batch = next(cut_batches(PLAN, set(), 1e9))
    done = block_means(batch)
    task = batch.tasks[-1]
    places = row_layout(task, batch.quantities, batch.scheme, batch.recording)
    found = unpack(done.curves[-1], places)["trace_mu"]
    scene = scene_of(task, batch.scheme, batch.recording)
    hurst, elements = task.problem.hurst, task.problem.elements
    for block in range(batch.blocks):
        assert batch.realizations_per_block == QUARTET
        phases = draw_phases(line_generator(batch.seed, hurst, elements, block), elements)
        lines = Line.quartet(amplitudes(hurst, elements), phases, elements, 1)
        expected = np.mean([run_scene(line, scene)["trace_mu"] for line in lines], axis=0)
        np.testing.assert_allclose(found[block], expected, rtol=1e-12, equal_nan=True)


def test_when_and_where_is_that_of_the_lines_to_the_bit_whatever_their_number():
    batch = next(cut_batches(PLAN, set(), 1e9))
    batch = replace(batch, realizations_per_block=12)
    done = block_means(batch)
    task = batch.tasks[-1]
    places = row_layout(task, batch.quantities, batch.scheme, batch.recording)
    found = unpack(done.curves[-1], places)
    scene = scene_of(task, batch.scheme, batch.recording)
    hurst, elements = task.problem.hurst, task.problem.elements
    phases = draw_phases(line_generator(batch.seed, hurst, elements, 0), elements)
    line = next(iter(Line.quartet(amplitudes(hurst, elements), phases, elements, 1)))
    expected = run_scene(line, scene)
    for name in MOTION:
        for block in found[name]:
            np.testing.assert_array_equal(block, expected[name])


def test_the_time_of_a_programme_is_booked_to_marching(monkeypatch):
    """Here it takes a million seconds for each line, and everything else far less."""
    monkeypatch.setattr(realizations, "add_programme", lambda *_: 1e6)
    batch = next(cut_batches(PLAN, set(), 1e9))
    booked = block_means(batch).spent // 1e6
    lines = batch.blocks * batch.realizations_per_block
    assert (booked[:, PHASES.index("marching")] == lines).all()
    assert booked.sum() == lines * len(batch.tasks)


def test_snapshots_are_taken_where_they_are_asked_for():
    batch = next(cut_batches(PLAN, set(), 1e9))
    task, plain = batch.tasks[0], batch.recording
    asked = plain._replace(asked=("trace", "snapshots"))
    assert scene_of(task, batch.scheme, plain).frames.size == 0
    kept = kept_steps(task.problem, task.steps_per_spacing, asked)
    assert scene_of(task, batch.scheme, asked).frames.tolist() == kept.tolist()
