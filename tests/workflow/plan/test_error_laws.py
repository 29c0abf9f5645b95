"""The laws of error and scatter hold for lines that they were not fitted to."""

import numpy as np
import pytest

from kernels import Quantities
from workflow.plan.error_laws import LAWS, Error
from workflow.simulate.realizations import block_means
from workflow.simulate.tasks import SCALARS, Batch, Problem, Recording, Task

POINTS = [
    Problem(0.3, 600, 0.05, 5.0, 1.2),
    Problem(0.7, 600, 0.01, 2.0, 1.2),
    Problem(0.7, 600, 0.5, 0.2, 1.2),
    Problem(0.0, 600, 0.2, 10.0, 1.2),
    Problem(1.0, 600, 0.02, 0.5, 1.2),
]
LINES = 24
FINE = 64


def scalars(problem, steps):
    """Return the scalars of every line, shape (lines, scalars)."""
    task = Task(problem, steps, 0, "")
    asked = Quantities(relaxation=False)
    batch = Batch(3, "modal", asked, "exponential", Recording(16), (task,), 0, LINES, 1, 0.0)
    return block_means(batch).scalars[0]


@pytest.fixture(scope="module", params=POINTS, ids=str)
def measured(request):
    """Return a problem with its fine scalars."""
    return request.param, scalars(request.param, FINE)


@pytest.mark.parametrize("name", ["mu_1", "jump"])
def test_discretisation_errors_keep_their_bound(measured, name):
    problem, fine = measured
    column = SCALARS.index(name)
    for steps in (4, 8):
        bound = LAWS[name].error(problem).at(steps)
        found = scalars(problem, steps)[:, column].mean() / fine[:, column].mean() - 1.0
        assert abs(found) <= 1.7 * bound + 1e-4  # the worst of the measurement


@pytest.mark.parametrize("name", ["mu_1", "jump"])
def test_scatter_is_that_of_the_lines(measured, name):
    problem, fine = measured
    values = fine[:, SCALARS.index(name)]
    ratio = values.std(ddof=1) / values.mean() / LAWS[name].scatter(problem)
    assert 1 / 3 < ratio < 3


def test_an_error_falls_with_the_steps():
    error = Error(0.001, 0.1, 0.4)
    assert error.at(2) == pytest.approx(0.001 + 0.05 + 0.1)
    assert np.all(np.diff([error.at(m) for m in (1, 2, 4, 8)]) < 0)
