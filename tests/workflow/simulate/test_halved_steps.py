"""Changes due to halved steps on a few measured lines, and the bias derived from them."""

import numpy as np
import pytest

from elastomer_friction.kernels import (
    Case,
    Line,
    Quantities,
    amplitudes,
    draw_phases,
    run_case,
    sample_line,
)
from elastomer_friction.workflow import scene
from elastomer_friction.workflow.simulate.layout import row_layout, unpack
from elastomer_friction.workflow.simulate.realizations import block_means
from elastomer_friction.workflow.simulate.recorded_steps import curve_times, record_steps
from tests.support.documents import without
from tests.support.small import cut_batches, small_plan

MEASURED = without("surface.length", "grid.hurst", "grid.spacing", "grid.roughness")
TWO = (
    'surface.file="two.csv"',
    "surface.columns=[0, 1, 2]",
    "study.realizations=2",
    "grid.normal_force=[1e-9]",
    "grid.velocity=[1e-3]",
    "material.relaxation_time=1e-3",
)
QUANTITIES = Quantities(steady=True, jump=True, relaxation=True)


@pytest.fixture(scope="module")
def batch():
    return next(cut_batches(small_plan(*TWO, text=MEASURED), set(), 1e9))


def outcome(batch, line, times):
    (task,) = batch.tasks
    problem, steps = task.problem, times * task.steps_per_spacing
    kept = times * record_steps(task.march_steps, batch.recording.samples, problem.spectrum)
    case = Case(problem.load, problem.speed, (problem.ratio,), (kept,), batch.scheme)
    return run_case(Line.measured(batch.heights[line], steps), case, QUANTITIES)


def test_records_of_measured_lines_hold_the_changes_due_to_halved_steps(batch):
    (task,) = batch.tasks
    places = row_layout(task, batch.quantities, batch.scheme, batch.recording)
    parts = unpack(block_means(batch).curves[0], places)
    for line in range(2):
        coarse, fine = outcome(batch, line, 1), outcome(batch, line, 2)
        changes = fine.mu_1 - coarse.mu_1, fine.jump[0] - coarse.jump[0], fine.mu_2[0]
        expected = [1.0, *changes[:2], changes[2] - coarse.mu_2[0]]
        np.testing.assert_allclose(parts["halved_steps"][line], expected, rtol=1e-9, atol=1e-15)
        # Interpolation between late samples, far from the start, adds a negligible error.
        change = parts["halved_steps_curve"][line][: coarse.curves[0].size]
        steps = record_steps(task.march_steps, batch.recording.samples)
        per_tau = task.problem.speed * task.problem.ratio * task.steps_per_spacing
        times = curve_times(steps, per_tau, batch.scheme)
        halved = curve_times(2 * steps, 2.0 * per_tau, batch.scheme)
        read = np.interp(times[1:], halved, fine.curves[0])
        np.testing.assert_allclose(change[1:], read - coarse.curves[0][1:], rtol=1e-9, atol=1e-15)


def test_changes_do_not_depend_on_the_cut(batch):
    whole = block_means(batch).curves
    cut = [block_means(b).curves for b in cut_batches(small_plan(*TWO, text=MEASURED), set(), 1e-9)]
    cut = [curves for curves in cut if curves.shape[2] == whole.shape[2]][:2]
    np.testing.assert_array_equal(np.concatenate(cut, axis=1), whole)


@pytest.mark.parametrize("settings", [(), (*TWO, "numerics.steps_per_spacing=4")])
def test_lines_with_a_law_or_steps_of_the_user_are_run_once(settings):
    plan = small_plan(*settings, text=MEASURED) if settings else small_plan()
    assert {variant.recording.refined_blocks for variant in plan.variants} == {0}


@pytest.mark.parametrize("seed", [4, 5, 6])
@pytest.mark.parametrize("load", [2e-7, 2e-6, 2e-5])
def test_the_bias_of_measured_lines_bounds_their_error(tmp_path, load, seed):
    """The reference are the same lines at 256 times the steps."""
    phases = draw_phases(np.random.default_rng(seed), 256)
    z, _ = sample_line(amplitudes(0.6, 256, "modal"), phases, 256, 1)
    np.save(tmp_path / "line.npy", np.c_[1e-6 * np.arange(256), 1e-6 * z])
    arguments = {
        "surface": {"file": str(tmp_path / "line.npy"), "units": ["m", "m"], "periodic": "none"},
        "material": {"shear_modulus": 1e6, "relaxation_time": 1e-3},
        "normal_force": load,
        "programme": [{"slide": {"velocity": 0.01, "distance": 1e-5}}],
        "quantities": ["steady"],
    }
    coarse = scene.run(**arguments)
    fine = scene.run(**arguments, numerics={"steps_per_spacing": 1024})
    assert np.isnan(fine.mu_1_bias)
    assert abs(float(coarse.mu_1 / fine.mu_1) - 1.0) <= float(coarse.mu_1_bias) + 5e-4
    assert int(coarse.resolution_status) == (2 if float(coarse.bias_bound) <= 0.02 else 1)
