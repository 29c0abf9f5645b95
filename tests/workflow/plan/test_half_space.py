"""What a half-space is sized by: errors that were measured, steps that keep them, maps that fit."""

import numpy as np
import pytest

from elastomer_friction.kernels import Case, Quantities
from elastomer_friction.kernels.half_space.cases import run_case
from elastomer_friction.kernels.half_space.surface import Surface, ring_amplitudes, rms_slope_of
from elastomer_friction.workflow.plan.half_space import (
    LAWS_OF_MAPS,
    MOST_SAMPLES,
    expected_area,
    expected_error,
    map_error,
    steps_for,
)
from elastomer_friction.workflow.plan.problems import line_slope
from elastomer_friction.workflow.simulate.tasks import LineShape, Problem
from tests.support.small import complaint, small_plan

MAP = LineShape(body="half-space")


def on_a_map(load, x, elements=16):
    """Return a problem at sigma_0/(E* grad z) = load."""
    problem = Problem(0.7, elements, 1.0, x / np.pi, 1.2, surface=MAP)
    return problem._replace(load=load * line_slope(problem) * elements)


@pytest.mark.parametrize(("load", "x"), [(0.05, 1.0), (0.2, 0.3)])
def test_the_error_of_mu_1_is_within_its_bound(load, x):
    """Of one map, m = 2 and 4 against m = 8: a mean of four is within it, one within twice."""
    amplitude = ring_amplitudes(0.7, 16)
    pressed = load * rms_slope_of(amplitude, 16) * 16
    case = Case(pressed, x / np.pi, (), (), "exponential")
    steady = Quantities(jump=False, relaxation=False)
    found = {
        m: run_case(Surface.drawn(np.random.default_rng(2), amplitude, 16, m), case, steady).mu_1
        for m in (2, 4, 8)
    }
    for m in (2, 4):
        assert abs(found[m] / found[8] - 1.0) < 2.0 * map_error("mu_1", m, 100.0)


@pytest.mark.parametrize("wanted", [0.1, 0.02, 0.005])
def test_auto_takes_the_least_steps_that_keep_an_error(wanted):
    for load in (0.005, 0.05, 0.5):
        problem = on_a_map(load, 3.0)
        steps = int(steps_for(problem, wanted))
        errors = [
            max(expected_error(name, problem, m) for name in ("mu_1", "jump")) for m in (4, 8)
        ]
        assert steps == 4 if errors[0] <= wanted else steps > 4
        assert steps <= 8 or errors[1] > wanted


def test_where_patches_are_small_the_jump_is_not_known():
    assert map_error("jump", 4, 100.0) < 0.05
    assert map_error("jump", 4, 4.0) > 0.3
    assert map_error("mu_1", 8, 4.0) == map_error("mu_1", 8, 100.0)


def test_a_map_that_does_not_fit_is_refused_before_anything_is_computed():
    side = int(MOST_SAMPLES**0.5)
    assert "samples, more than 4096 x 4096; take a larger spacing" in complaint(
        "scene.body=half-space", f"grid.spacing={0.01 / side!r}", "numerics.steps_per_spacing=4"
    )


def test_memory_of_a_map_goes_with_its_samples():
    own = ("scene.body=half-space", "numerics.steps_per_spacing=4")
    few, many = (
        small_plan(*own, f"grid.spacing={spacing}").predicted_worker_bytes()
        for spacing in (2e-4, 1e-4)
    )
    samples = [(0.01 / spacing * 4) ** 2 for spacing in (2e-4, 1e-4)]
    assert many - few == pytest.approx(260.0 * (samples[1] - samples[0]))


@pytest.mark.parametrize(("load", "x"), [(0.02, 0.3), (0.2, 1.0)])
def test_maps_scatter_and_touch_as_the_laws_of_an_accuracy_say(load, x):
    """Of 16 maps: a standard deviation is known to a sixth, the law to 1.6 for two in three."""
    amplitude = ring_amplitudes(0.7, 16)
    problem = on_a_map(load, x)
    case = Case(problem.load, problem.speed, (1.2,), (), "exponential")
    generator, asked = np.random.default_rng(5), Quantities(relaxation=False)
    found = [run_case(Surface.drawn(generator, amplitude, 16, 4), case, asked) for _ in range(16)]
    for name, of in (
        ("mu_1", np.array([one.mu_1 for one in found])),
        ("jump", np.array([one.jump[0] for one in found])),
    ):
        scatter = of.std(ddof=1) / abs(of.mean())
        assert 0.4 < scatter / LAWS_OF_MAPS[name].scatter(problem) < 2.5
    area = np.mean([one.contact_fraction for one in found])
    assert 0.7 < area / expected_area(problem) < 1.3


def test_an_accuracy_chooses_steps_and_maps_of_a_half_space():
    own = ("scene.body=half-space", 'scene.quantities=["steady", "jump"]')
    coarse, fine = (small_plan(*own, f"numerics.accuracy={wanted}") for wanted in (0.1, 0.02))
    for rough, close in zip(coarse.variants[0].tasks, fine.variants[0].tasks, strict=True):
        assert close.steps_per_spacing >= rough.steps_per_spacing
        assert fine.expected[close.key] > 4 * coarse.expected[rough.key]
