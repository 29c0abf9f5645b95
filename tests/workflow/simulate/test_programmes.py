"""Programmes in batches: recorded steps, their times, and equal bits for any cut."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from elastomer_friction.kernels import (
    MOTION_TRACES,
    QUARTET,
    SCHEMES,
    Case,
    Hold,
    Line,
    Oscillation,
    Quantities,
    Slide,
    Spectrum,
    amplitudes,
    draw_phases,
    run_case,
    run_scene,
)
from elastomer_friction.workflow.simulate.drawing import line_generator
from elastomer_friction.workflow.simulate.layout import row_layout, row_width, unpack
from elastomer_friction.workflow.simulate.programmes import scene_of
from elastomer_friction.workflow.simulate.realizations import block_means
from elastomer_friction.workflow.simulate.recorded_steps import (
    curve_times,
    programme_steps,
    record_steps,
    trace_steps,
)
from elastomer_friction.workflow.simulate.tasks import SCALARS, Problem, Recording, Task
from tests.support.small import HOLDING, PROGRAMME, cut_batches, small_plan


@given(st.integers(8, 10**6), st.integers(8, 600))
def test_recorded_steps_run_from_the_first_to_the_last(march, samples):
    recorded = record_steps(march, samples)
    assert (recorded[0], recorded[-1]) == (1, march)
    assert np.all(np.diff(recorded) >= 1)
    assert recorded.size <= samples - 1
    assert recorded.size == samples - 1 or march < 2 * samples


def deviation(moments, steps, lag=None):
    """Return mu - mu_2 of 8 lines at moments of slow creep after a jump, with m = ``steps``.

    lag : of friction within a step, in place of that of the scheme.
    """
    speed, total = 0.3, 0.0
    steps_per_tau = 1.2 * speed * steps
    recorded = np.arange(1, int(3 * steps_per_tau))
    times = curve_times(recorded, steps_per_tau, "exponential")
    if lag is not None:
        times = (recorded - lag) / steps_per_tau
    for seed in range(8):
        phases = draw_phases(np.random.default_rng(seed), 200)
        line = Line.self_affine(amplitudes(0.0, 200), phases, 200, steps)
        case = Case(0.1, speed, (1.2,), (recorded,), "exponential")
        outcome = run_case(line, case, Quantities())
        total += np.interp(moments, times, outcome.curves[0] - outcome.mu_2[0])
    return total


def test_recorded_friction_belongs_to_its_times():
    moments = np.linspace(0.5, 2.0, 12)
    limit = deviation(moments, 256)
    error = {m: np.abs(deviation(moments, m) / limit - 1.0).max() for m in (16, 64)}
    at_the_end = np.abs(deviation(moments, 16, lag=0.0) / limit - 1.0).max()
    assert error[16] < 0.02
    assert error[64] < 0.002
    assert at_the_end > 0.08  # of first order


@pytest.mark.parametrize("scheme", SCHEMES)
def test_recorded_times_lie_within_their_steps(scheme):
    recorded = np.array([1, 2, 7])
    for steps_per_tau in (0.1, 1.0, 30.0):
        times = curve_times(recorded, steps_per_tau, scheme) * steps_per_tau
        assert np.all((times <= recorded) & (times > recorded - 1))
        lag = SCHEMES[scheme](1.0 / steps_per_tau).lag
        np.testing.assert_allclose(times, recorded - lag, rtol=1e-12)


def test_friction_of_branches_belongs_to_the_end_of_its_step():
    """Their displacement grows linearly over a step, that of a Kelvin element does not."""
    branches = Spectrum((2.0, 1.0), (0.1, 1.0), 0.0)
    times = curve_times(np.array([1, 2, 7]), 4.0, "exponential", branches)
    np.testing.assert_allclose(times, np.array([0.25, 0.5, 1.75]), rtol=1e-15)


SWING = (Slide(1.0, 6.0), Hold(50.0), Slide(1.0, 6.0), Oscillation(0.0, 2.0, 0.1, 2))
PROBLEM = Problem(0.7, 64, 0.1, 1.0, 1.0, programme=SWING)


@pytest.mark.parametrize("record", ["time", "distance", "log"])
@pytest.mark.parametrize("dense", [(), ("healing", "loop")])
def test_a_trace_runs_from_the_start_to_the_end(record, dense):
    march = programme_steps(PROBLEM, 4)
    kept = trace_steps(PROBLEM, 4, Recording(40, record, dense=dense))
    assert (kept[0], kept[-1]) == (0, march.time.size)
    assert (np.diff(kept) > 0).all()
    legs = set(march.leg[kept[1:] - 1])
    assert legs >= ({0, 2, 3} if record == "distance" else {0, 1, 2, 3})
    if record == "log":  # the first and the last step of every leg
        ends = np.flatnonzero(np.diff(march.leg, prepend=-1, append=9)) + 1
        assert set(ends[:-1]) | set(ends[1:] - 1) <= set(kept)
    if not dense:
        assert 30 <= kept.size <= 42


@pytest.mark.parametrize("record", ["time", "log"])
def test_a_hold_of_no_duration_adds_no_steps(record):
    plain = PROBLEM._replace(programme=(Slide(1.0, 6.0), Slide(1.0, 6.0)))
    held = PROBLEM._replace(programme=(Slide(1.0, 6.0), Hold(0.0), Slide(1.0, 6.0)))
    recording = Recording(60, record, dense=("healing",))
    first, second = (trace_steps(problem, 4, recording).tolist() for problem in (plain, held))
    assert (
        (first[0], first[-1]) == (second[0], second[-1]) == (0, programme_steps(held, 4).time.size)
    )


def test_every_kth_step_is_recorded_on_request():
    steps = programme_steps(PROBLEM, 4).time.size
    assert trace_steps(PROBLEM, 4, Recording(40, every=1)).size == 1 + steps
    third = trace_steps(PROBLEM, 4, Recording(40, every=3))
    assert (third[:-1] % 3 == 0).all()


@pytest.mark.parametrize("record", ["time", "distance"])
def test_samples_that_fall_on_steps_are_those_steps(record):
    """The last bit of a sum of steps has no effect."""
    even = PROBLEM._replace(programme=(Slide(1.0, 30.0),))
    assert programme_steps(even, 8).time.size == 240
    for interval in (2, 3, 5):
        steps = trace_steps(even, 8, Recording(240 // interval + 1, record))
        assert steps.tolist() == list(range(0, 241, interval))


def test_the_leg_after_a_hold_is_dense_at_its_beginning():
    march = programme_steps(PROBLEM, 16)
    kept = trace_steps(PROBLEM, 16, Recording(8, dense=("healing",)))
    first = int(np.searchsorted(march.leg, 2))
    assert {first, first + 1, first + 2, first + 3} <= set(kept.tolist())


@pytest.mark.parametrize("m", [2, 4, 64])
def test_the_last_cycle_of_an_oscillation_is_a_closed_loop(m):
    """It has at most 256 samples, from one period before the end on, or all steps if fewer."""
    time = np.append(0.0, programme_steps(PROBLEM, m).time)
    first = int(np.abs(time - (time[-1] - 1.0 / SWING[-1].frequency)).argmin())
    kept = trace_steps(PROBLEM, m, Recording(2, dense=("loop",)))
    loop = kept[1:]  # 0 is the start
    assert (loop[0], loop[-1]) == (first, time.size - 1)
    assert loop.size == min(256, time.size - first)


SPECTRUM = Spectrum((2.0, 1.0), (0.1, 1.0), 0.0)
HELD = (Slide(1.0, 4.0), Hold(2.0), Slide(1.0, 4.0))
BRANCHED = Problem(0.7, 16, 0.1, 1.0, 1.0, spectrum=SPECTRUM, programme=HELD)
TASK = Task(BRANCHED, 2, 8, "")
REQUESTED = ("trace", "energy", "contact_lengths", "snapshots", "state")


@pytest.mark.parametrize("count", range(6))
def test_the_layout_has_no_gaps_and_unpacks_to_its_shapes(count):
    recording = Recording(20, requested=REQUESTED[:count])
    quantities = Quantities(initial_rate=True)
    places = row_layout(TASK, quantities, "exponential", recording)
    width = row_width(places)
    rows = np.arange(3.0 * width).reshape(3, width)
    parts = unpack(rows, places)
    blocks = unpack(np.stack([rows, -rows], axis=1), places)  # of tasks and blocks
    assert all(np.array_equal(blocks[name][:, 1], -parts[name]) for name in parts)
    joined = np.concatenate([part.reshape(3, -1) for part in parts.values()], axis=1)
    assert np.array_equal(joined, rows)
    assert parts["curve"].shape == (3, 19)
    assert parts["initial_rate"].shape == (3,)


def batch_of(programme):
    """Return the first batch of a small study with a programme."""
    small = "material.temperature=20.0", "grid.velocity=0.03", "numerics.samples=16"
    plan = small_plan(programme, *small, "numerics.steps_per_spacing=1", text=HOLDING)
    return next(cut_batches(plan, set(), 1e9))


BATCH = batch_of(PROGRAMME)


def last_task(batch):
    """Return the traces of the last task, shape (blocks, samples), its scene, and its quartets."""
    task = batch.tasks[-1]
    places = row_layout(task, batch.quantities, batch.scheme, batch.recording)
    hurst, elements = task.problem.hurst, task.problem.elements

    def quartet(number):
        phases = draw_phases(line_generator(batch.seed, hurst, elements, number), elements)
        return Line.quartet(amplitudes(hurst, elements), phases, elements, 1)

    traces = unpack(block_means(batch).curves[-1], places)
    return traces, scene_of(task, batch.scheme, batch.recording), quartet


def test_mu_1_and_mu_2_belong_to_the_first_and_the_last_slide():
    """A hold lies between them, so that the programme has no velocity step."""
    scalars = dict(zip(SCALARS, block_means(BATCH).scalars[0, 0], strict=True))
    fast = batch_of("scene.programme=[{slide={ratio=2.0, distance=1e-3}}]")
    expected = dict(zip(SCALARS, block_means(fast).scalars[0, 0], strict=True))
    assert scalars["mu_2"] == pytest.approx(expected["mu_1"], rel=1e-12)
    assert scalars["mu_1"] != pytest.approx(scalars["mu_2"], rel=1e-3)


def test_a_trace_is_the_mean_over_the_lines_of_its_block():
    traces, scene, quartet = last_task(BATCH)
    assert BATCH.realizations_per_block == QUARTET
    for block, actual in enumerate(traces["trace_mu"]):
        lines = quartet(block)
        expected = np.mean([run_scene(line, scene)["trace_mu"] for line in lines], axis=0)
        np.testing.assert_allclose(actual, expected, rtol=1e-12, equal_nan=True)


def test_times_and_positions_of_a_trace_are_those_of_each_line_to_the_bit():
    means, scene, quartet = last_task(replace(BATCH, realizations_per_block=12))
    expected = run_scene(next(iter(quartet(0))), scene)
    for name in MOTION_TRACES:
        for block in means[name]:
            np.testing.assert_array_equal(block, expected[name])


def test_snapshots_are_taken_on_request():
    task, plain = BATCH.tasks[0], BATCH.recording
    requested = plain._replace(requested=("trace", "snapshots"))
    assert scene_of(task, BATCH.scheme, plain).frames.size == 0
    steps = trace_steps(task.problem, task.steps_per_spacing, requested)
    assert scene_of(task, BATCH.scheme, requested).frames.tolist() == steps.tolist()
