"""Sizes of half-spaces: measured errors, steps that bound them, maps that fit a worker."""

import numpy as np
import pytest

from elastomer_friction.kernels import Case, Quantities, Spectrum
from elastomer_friction.kernels.half_space.cases import run_case
from elastomer_friction.kernels.half_space.surface import Surface, ring_amplitudes, rms_slope_of
from elastomer_friction.workflow.plan.choices import map_choices
from elastomer_friction.workflow.plan.half_space import (
    AUTO_BYTES,
    LAWS_OF_MAPS,
    MAX_MAP_SAMPLES,
    STEPS_OF_MAPS,
    equivalent_steps,
    expected_area,
    largest_error,
    map_error,
    steps_for,
)
from elastomer_friction.workflow.plan.problems import line_slope
from elastomer_friction.workflow.plan.shortest_wave import shortest_wave
from elastomer_friction.workflow.simulate.tasks import LineShape, Problem
from elastomer_friction.workflow.study.surfaces.profile import profile_of_array
from elastomer_friction.workflow.study.surfaces.surface import Surface as StudySurface
from tests.support.small import complaint, small_plan

MAP = LineShape(body="half-space")
RUBBER = Spectrum((1.0,) * 5, (0.01, 0.1, 1.0, 10.0, 100.0), 0.0)
STEADY = ("steady",)
ON_MAP = ("scene.body=half-space", "compare.coarse.steps_per_spacing=4")


def on_a_map(load, x):
    """Return a problem at sigma_0/(E* grad z) = load."""
    problem = Problem(0.7, 16, 1.0, x / np.pi, 1.2, surface=MAP)
    return problem._replace(load=load * line_slope(problem) * 16)


@pytest.mark.parametrize(("load", "x"), [(0.05, 1.0), (0.2, 0.3)])
def test_the_error_of_mu_1_is_within_its_bound(load, x):
    """The bound is that of means of four maps; a single map may have twice this error."""
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
        steps = int(steps_for(problem, ("steady", "jump"), wanted))
        coarser = [m for m in STEPS_OF_MAPS if m < steps]
        assert all(largest_error(problem, ("steady", "jump"), m) > wanted for m in coarser)
        assert steps == 16 or largest_error(problem, ("steady", "jump"), steps) <= wanted
        assert steps_for(problem, STEADY, wanted) <= steps


def wave_of(heights):
    """Return the shortest wave of a map of heights."""
    profile = profile_of_array(heights, 1.0, as_map=True)
    surface = StudySurface(1.0, profile=profile, body="half-space")
    assert shortest_wave(surface._replace(lines="random-phase"), len(heights)) > 0.0
    return shortest_wave(surface, len(heights))


def sphere(side):
    """Return the heights of a paraboloid whose periodic images meet in kinks."""
    x = (np.arange(side) / side - 0.5)[None, :]
    return -0.5 * (x**2 + x.T**2)


def test_the_shortest_wave_follows_the_wavelength_and_ignores_kinks():
    x = 2.0 * np.pi * np.arange(64)[None, :] / 64
    waves = [0.01 * (np.cos(k * x) + np.cos(k * x.T)) for k in (2, 4)]
    assert wave_of(waves[0]) == pytest.approx(2.0 * wave_of(waves[1]), rel=0.05)
    assert wave_of(sphere(64)) > 0.4 * 64
    assert wave_of(sphere(128)) == pytest.approx(2.0 * wave_of(sphere(64)), rel=0.05)
    rough = Surface.drawn(np.random.default_rng(1), ring_amplitudes(0.7, 64), 64, 1).z
    assert wave_of(0.001 * rough) == pytest.approx(2.0, rel=0.2)


def test_a_smooth_map_is_resolved_by_few_steps_unless_fast_branches_or_a_dashpot_dissipate():
    smooth, rough = MAP._replace(shortest=20.0), MAP
    slow = Problem(0.7, 64, 1.0, 1.0, 1.0, RUBBER, smooth)
    assert equivalent_steps(slow, 2) > 3.0 * 2
    assert equivalent_steps(slow._replace(speed=1e-4), 2) == pytest.approx(2.0, rel=0.05)
    for equal in (slow._replace(surface=rough), Problem(0.7, 64, 1.0, 1.0, 1.0, surface=smooth)):
        assert equivalent_steps(equal, 2) == pytest.approx(2.0, rel=1e-12)


@pytest.mark.parametrize("speed", [0.1, 1.0])
def test_auto_keeps_the_error_of_a_sphere_on_rubber(speed):
    heights = 64.0 * sphere(64)
    problem = Problem(0.8, 64, 0.0, speed, 1.0, RUBBER, MAP._replace(shortest=wave_of(heights)))
    steps = int(steps_for(problem, STEADY, 0.02))
    assert steps <= 2  # 8 on a rough surface
    case = Case(0.3 * heights.size**0.5, speed, (), (), "exponential", RUBBER)
    mu = [
        run_case(Surface.measured(heights, m), case, Quantities(jump=False, relaxation=False)).mu_1
        for m in (steps, 6)
    ]
    assert abs(mu[0] / mu[1] - 1.0) < 0.02


def test_auto_does_not_need_more_than_its_memory_and_states_the_rest_of_the_error():
    problem = Problem(0.7, 512, 1.0, 1.0, 1.0, RUBBER, MAP)
    steps = int(steps_for(problem, STEADY, 1e-3))
    assert steps < 16
    assert largest_error(problem, STEADY, steps) > 1e-3
    assert int(steps_for(problem._replace(elements=2048), STEADY, 1e-3)) == 1
    twelve = Spectrum((0.02,) * 12, tuple(np.geomspace(1e-3, 1e3, 12)), 0.0)
    many = problem._replace(elements=1024, spectrum=twelve)  # a jump stores their pressures
    assert steps_for(many, STEADY, 1e-3) > steps_for(many, ("steady", "jump"), 1e-3)


def test_a_plan_offers_a_coarser_and_a_finer_map():
    plan = small_plan(*ON_MAP, 'scene.quantities=["steady"]', "grid.spacing=5e-4")
    choices = map_choices(plan)
    assert [choice.chosen for choice in choices] == [False, True, False]
    (chosen,) = (choice for choice in choices if choice.chosen)
    assert chosen.steps_per_spacing == plan.variants[0].tasks[0].steps_per_spacing
    assert chosen.predicted_core_seconds == pytest.approx(plan.predicted_seconds())
    assert chosen.predicted_worker_bytes == round(plan.predicted_worker_bytes()) <= AUTO_BYTES
    for finer, coarser in zip(choices[1:], choices[:-1], strict=True):
        assert finer.predicted_worker_bytes > coarser.predicted_worker_bytes
        assert finer.predicted_core_seconds > coarser.predicted_core_seconds
        assert finer.bias_bound < coarser.bias_bound
    assert map_choices(small_plan()) == []


def test_the_jump_is_uncertain_for_small_patches():
    assert map_error("jump", 4, 100.0) < 0.05
    assert map_error("jump", 4, 4.0) > 0.3
    assert map_error("mu_1", 8, 4.0) == map_error("mu_1", 8, 100.0)


def test_a_map_that_does_not_fit_is_refused_before_anything_is_computed():
    side = int(MAX_MAP_SAMPLES**0.5)
    large = "scene.body=half-space", f"grid.spacing={0.02 / side!r}"
    assert "4096 x 4096 samples; set it to 2, or take a larger grid.spacing" in complaint(
        *large, "numerics.steps_per_spacing=4"
    )


@pytest.mark.parametrize(("load", "x"), [(0.02, 0.3), (0.2, 1.0)])
def test_maps_scatter_and_touch_as_the_laws_of_an_accuracy_say(load, x):
    """The scatter of 16 maps is known to a sixth; two in three laws hold within a factor 1.6."""
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
