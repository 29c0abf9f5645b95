"""Predicted cost: positive, additive, and increasing with every kind of work."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from elastomer_friction.kernels import Quantities, Slide, Spectrum
from elastomer_friction.workflow.plan.cost import COST_FACTOR, realization_seconds
from elastomer_friction.workflow.plan.problems import stack_problems
from elastomer_friction.workflow.simulate.realizations import block_means
from elastomer_friction.workflow.simulate.tasks import LineShape, Problem, Recording
from tests.support.small import HOLDING, PROGRAMME, cut_batches, small_plan

ALL = Quantities()
BRANCH = Spectrum((1.0,), (1.0,), 1.0)
MAP = LineShape(body="half-space")
# H, N, Fbar, vbar, r = v2/v1
PROBLEMS = st.builds(
    lambda *numbers: Problem(*numbers),
    st.floats(0.0, 1.0),
    st.integers(100, 100_000),
    st.floats(1e-4, 100.0),
    st.floats(1e-3, 1e4),
    st.floats(0.1, 10.0),
)
AT = Problem(0.7, 2500, 0.05, 1.0, 1.2)


def cost(steps=4, march_steps=100, quantities=ALL, scheme="exponential", **changes):
    """Return the predicted time of a problem that differs from AT in some fields."""
    problem = AT._replace(**changes)
    recording = Recording(64, requested=("trace",) if problem.programme else ())
    return realization_seconds(problem, steps, march_steps, quantities, recording, scheme)


SLIDES = {"programme": (Slide(1.0, 10.0),), "spectrum": BRANCH}
SMALL_MAP = {"elements": 32, "surface": MAP}


@pytest.mark.parametrize(
    ("cheap", "dear"),
    [
        ({"elements": 1250}, {}),
        ({"march_steps": 50}, {}),
        ({"quantities": ALL._replace(relaxation=False)}, {}),
        ({"spectrum": BRANCH, "march_steps": 50}, {"spectrum": BRANCH}),
        ({}, {"spectrum": BRANCH}),
        (SLIDES | {"programme": (Slide(1.0, 5.0),)}, SLIDES),
        (SLIDES | {"start": "rest"}, SLIDES),
        (SLIDES, SLIDES | {"scheme": "implicit-euler"}),
        (SMALL_MAP | {"march_steps": 50}, SMALL_MAP),
        (SMALL_MAP | {"elements": 16}, SMALL_MAP),
        (SMALL_MAP | {"quantities": ALL._replace(jump=False)}, SMALL_MAP),
    ],
)
def test_more_work_takes_more_time(cheap, dear):
    assert cost(**cheap) < cost(**dear)


@given(PROBLEMS, st.sampled_from([1, 4, 64]), st.integers(8, 10_000), st.booleans())
def test_many_problems_at_once_cost_what_each_costs_alone(problem, steps, march_steps, branches):
    other = problem._replace(load=2.0 * problem.load, elements=2 * problem.elements)
    problems = [own._replace(spectrum=BRANCH) if branches else own for own in (problem, other)]
    ((_, many),) = stack_problems(problems)
    counts, marches = np.array([steps, 2 * steps]), np.array([march_steps, 8])
    found = realization_seconds(many, counts, marches, ALL, Recording(64), "exponential")
    alone = [
        realization_seconds(own, int(m), int(march), ALL, Recording(64), "exponential")
        for own, m, march in zip(problems, counts, marches, strict=True)
    ]
    np.testing.assert_allclose(found, alone)
    assert np.isfinite(found).all()
    assert (found > 0.0).all()


@pytest.mark.exhaustive  # measures time, which a busy machine may stretch
@pytest.mark.parametrize(
    "plan",
    [
        small_plan("study.realizations=400"),
        small_plan("study.realizations=80", "material.branches=[[5e6, 1e-2]]"),
        small_plan(PROGRAMME, "study.realizations=80", text=HOLDING),
        small_plan("scene.body=half-space", "grid.spacing=5e-4"),
    ],
)
def test_small_studies_of_each_kind_take_about_as_long_as_predicted(plan):
    batches = list(cut_batches(plan, set(), 1e9))
    used = min(sum(block_means(batch).seconds for batch in batches) for _ in range(2))
    assert 0.3 / COST_FACTOR < used / plan.predicted_seconds() < 3.0 * COST_FACTOR
