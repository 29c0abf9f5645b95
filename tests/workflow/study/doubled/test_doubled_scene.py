"""What is said of doubled keys of [scene] is so."""

from elastomer_friction.workflow.simulate import programme_steps
from tests.support.documents import without
from tests.support.small import small_plan

TEXT = without("grid.velocity_step", "grid.velocity")
SLIDE = "scene.programme=[{slide={velocity=0.1, distance=%g}}]"


def steps(*settings):
    """Return the time steps of a scene of one slide."""
    task = small_plan(*settings, text=TEXT).variants[0].tasks[0]
    return programme_steps(task.problem, task.steps_per_spacing).leg.size


def test_a_programme_repeated_twice_as_often_takes_twice_the_steps():
    assert steps(SLIDE % 1e-3, "scene.repeat=2") == 2 * steps(SLIDE % 1e-3)


def test_a_distance_doubled_takes_twice_the_steps():
    assert steps(SLIDE % 2e-3) == 2 * steps(SLIDE % 1e-3)
