"""How far results are from the limit of fine samples: what is said of contacts and of biases."""

import numpy as np
import pytest

from elastomer_friction.workflow.plan import LAWS
from elastomer_friction.workflow.reduce.complete import (
    COARSE,
    RESOLVED,
    UNRESOLVED,
    resolution,
    resolution_status,
)
from elastomer_friction.workflow.simulate import Problem, Task
from elastomer_friction.workflow.study import Numerics

NAMES = ("mu_1", "jump", "relaxation_rate")
PROBLEM = Problem(0.7, 1000, 0.1, 1.0, 1.2)
AUTO = Numerics()


def found(steps=8, numerics=AUTO, samples=12.0, problem=PROBLEM, names=NAMES):
    """Return the resolution of one task whose contacts have so many samples and whose b is 2."""
    estimates = {"samples_per_contact": np.array([samples]), "relaxation_rate": np.array([2.0])}
    return resolution([Task(problem, steps, 100, "key")], estimates, names, numerics)


def test_status_follows_the_samples_per_contact():
    status = resolution_status(np.array([0.5, 1.0, 1.5, 3.9, 4.0, 1e3, np.nan]))
    assert status.tolist() == [UNRESOLVED] * 2 + [COARSE] * 2 + [RESOLVED] * 2 + [-1]


def test_biases_follow_the_laws_and_fall_with_finer_steps():
    coarse, fine = found(8), found(64)
    for name in NAMES[:2]:
        assert coarse[f"{name}_bias"] == LAWS[name].error(PROBLEM, 8)
    for name in NAMES:
        assert 0.0 < fine[f"{name}_bias"] < coarse[f"{name}_bias"]
        assert coarse["bias_bound"] >= coarse[f"{name}_bias"]


def test_each_task_has_a_bound_of_its_own():
    tasks = [Task(PROBLEM, steps, 100, "key") for steps in (8, 64)]
    estimates = {"samples_per_contact": np.full(2, 12.0), "relaxation_rate": np.full(2, 2.0)}
    both = resolution(tasks, estimates, NAMES, AUTO)
    expected = [found(steps)["bias_bound"].item() for steps in (8, 64)]
    assert both["bias_bound"].tolist() == expected


def test_rate_is_judged_by_the_contacts_that_were_found():
    assert found(samples=2.0)["relaxation_rate_bias"] > found(samples=50.0)["relaxation_rate_bias"]


@pytest.mark.parametrize("name", NAMES)
def test_first_order_has_a_larger_bias(name):
    first_order = found(numerics=Numerics("implicit-euler"))
    assert first_order[f"{name}_bias"] > found()[f"{name}_bias"]


def test_steps_that_are_given_have_the_bias_of_their_own_samples():
    light = PROBLEM._replace(load=1e-3, speed=100.0)
    given, chosen = found(4, Numerics(steps_per_spacing=4), problem=light), found(4, problem=light)
    for name in ("mu_1", "jump"):
        assert given[f"{name}_bias"] > 10.0 * chosen[f"{name}_bias"]
    assert given["relaxation_rate_bias"] == chosen["relaxation_rate_bias"]


def test_no_bias_is_beyond_the_value_itself():
    assert found(1, samples=0.5)["bias_bound"] == 1.0


def test_no_law_is_known_for_lines_that_were_measured():
    measured = PROBLEM._replace(surface=PROBLEM.surface._replace(measured="lines"))
    assert np.isnan(found(problem=measured)["mu_1_bias"]).all()


def test_nothing_is_said_where_nothing_steady_is_asked_for():
    assert found(names=()) == {}
