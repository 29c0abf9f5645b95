"""The laws of error and scatter hold for lines that they were not fitted to."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from elastomer_friction.kernels import Quantities
from elastomer_friction.kernels.quick.contacts.between_samples import MIN_SMOOTH_STEPS
from elastomer_friction.workflow.plan.error_laws import FOLLOWED, LAWS, contact_width, rate_error
from elastomer_friction.workflow.plan.problems import expected_rate
from elastomer_friction.workflow.simulate.realizations import block_means
from elastomer_friction.workflow.simulate.tasks import SCALARS, Batch, Problem, Recording, Task

POINTS = [
    Problem(0.3, 600, 0.05, 5.0, 1.2),
    Problem(0.7, 600, 0.01, 2.0, 1.2),
    Problem(0.7, 600, 0.5, 0.2, 1.2),
    Problem(0.0, 600, 0.2, 10.0, 1.2),
    Problem(1.0, 600, 0.02, 0.5, 1.2),
]
OUTER = [  # where the bound was once ten times too small
    Problem(0.2, 660, 0.0016, 0.025, 1.2),
    Problem(0.7, 1580, 19.0, 870.0, 1.2),
]
LINES = 24
FINE = 61  # a prime number, all samples of which are taken


def scalars(problem, steps):
    """Return the scalars of every line, shape (lines, scalars)."""
    task = Task(problem, steps, 0, "")
    asked = Quantities(relaxation=False)
    batch = Batch(3, "modal", asked, "exponential", Recording(16), (task,), 0, LINES, 1, 0.0)
    return block_means(batch).scalars[0]


@pytest.fixture(scope="module", params=POINTS + OUTER, ids=str)
def measured(request):
    """Return a problem with its fine scalars."""
    return request.param, scalars(request.param, FINE)


@pytest.mark.parametrize("name", ["mu_1", "jump"])
def test_discretisation_errors_keep_their_bound(measured, name):
    problem, fine = measured
    column = SCALARS.index(name)
    for steps in (4, 8):
        bound = LAWS[name].error(problem, steps)
        found = scalars(problem, steps)[:, column].mean() / fine[:, column].mean() - 1.0
        assert abs(found) <= 2.0 * bound  # the worst of the measurement


@pytest.mark.parametrize("measured", POINTS, indirect=True, ids=str)
@pytest.mark.parametrize("name", ["mu_1", "jump"])
def test_scatter_is_that_of_the_lines(measured, name):
    problem, fine = measured
    values = fine[:, SCALARS.index(name)]
    ratio = values.std(ddof=1) / values.mean() / LAWS[name].scatter(problem)
    assert 1 / 3 < ratio < 3


PROBLEMS = st.tuples(
    st.floats(0.0, 1.0),
    st.integers(100, 100_000),
    st.floats(1e-3, 25.0),
    st.floats(0.01, 1000.0),
    st.floats(0.5, 2.0),
).map(lambda numbers: Problem(*numbers))


@given(PROBLEMS, st.sampled_from(sorted(LAWS)))
def test_an_error_falls_with_the_steps(problem, name):
    steps = np.array([1, 2, 4, 6, 8, 16, 64])
    followed = (steps >= MIN_SMOOTH_STEPS) & (name != "relaxation_rate")
    errors = np.array([LAWS[name].error(problem, m) for m in steps])
    assert np.all(np.diff(errors[~followed]) < 0.0)
    assert np.all(errors[followed] == FOLLOWED)
    assert not followed.any() or errors[~followed][-1] > FOLLOWED


@given(PROBLEMS, st.integers(1, 64), st.floats(0.1, 100.0), st.floats(1.1, 10.0))
def test_wider_contacts_and_slower_relaxations_have_smaller_errors(problem, steps, samples, by):
    rate = 1.5 * expected_rate(problem)
    here = rate_error(problem, steps, samples, rate)
    assert rate_error(problem, steps, by * samples, rate) <= here
    assert rate_error(problem, steps, samples, by * rate) >= here


@given(PROBLEMS, st.floats(1.1, 100.0))
def test_contacts_are_wider_under_heavier_loads(problem, by):
    assert contact_width(problem._replace(load=by * problem.load)) > contact_width(problem)


NARROW = [  # H, N, Fbar, x: width in dx, of lines of the other seed of the measurement
    (Problem(0.7, 500, 1e-3, 1e3 / np.pi, 1.2), 0.14),
    (Problem(0.1, 5980, 0.00516, 363 / np.pi, 1.2), 0.48),
    (Problem(0.3, 4060, 0.178, 194 / np.pi, 1.2), 1.17),
    (Problem(0.8, 2240, 0.0903, 259 / np.pi, 1.2), 7.0),
]


@pytest.mark.parametrize(("problem", "width"), NARROW)
def test_the_width_of_contacts_is_about_that_measured(problem, width):
    assert 0.5 < contact_width(problem) / width < 2.0


def test_a_single_contact_narrows_with_the_root_of_the_speed():
    """The front of a parabola: its width is sqrt(2 R F_N / (4 G v tau))."""
    slow = Problem(0.7, 500, 1e-4, 300.0, 1.2)
    ratio = contact_width(slow._replace(speed=100 * slow.speed)) / contact_width(slow)
    assert ratio == pytest.approx(0.1, rel=0.3)
