"""Rough cost: positive and additive, it grows with the work and covers every kind of it."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from elastomer_friction.kernels import (
    Line,
    Quantities,
    Slide,
    Spectrum,
    amplitudes,
    draw_phases,
    rms_slope,
)
from elastomer_friction.kernels.model.steady import steady_sliding
from elastomer_friction.kernels.motion.slide import touchable
from elastomer_friction.kernels.rheology.kelvin import SCHEMES
from elastomer_friction.workflow.plan.cost import COST_FACTOR, drawing_seconds, realization_seconds
from elastomer_friction.workflow.plan.error_laws import touchable_share
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


def test_lines_of_more_samples_take_longer_to_draw():
    assert (np.diff(drawing_seconds(np.geomspace(1.0, 1e7, 50))) > 0.0).all()


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


def states(count=40, elements=1000, steps=4):
    """Yield (H, Fbar, viscous pressure, touchable share) of random problems."""
    rng = np.random.default_rng(8)
    for _ in range(count):
        hurst, load, speed = rng.uniform(0, 1), 10 ** rng.uniform(-3, 0.5), 10 ** rng.uniform(0, 2)
        amplitude = amplitudes(hurst, elements)
        line = Line.self_affine(amplitude, draw_phases(rng, elements), elements, steps)
        law = SCHEMES["exponential"](1.0 / (steps * speed))
        (_, d), _ = steady_sliding(law, line.z, load * line.z.size)
        start, stop = touchable(line.z, 1.02 * d)
        share = np.sum(stop - start) / line.z.size
        yield hurst, load, speed * rms_slope(amplitude, elements), share


def test_touchable_shares_are_those_of_the_kernels():
    share = [np.log(row[3] / touchable_share(*row[:3])) for row in states()]
    assert np.median(np.abs(share)) < np.log(1.5)
    assert abs(np.mean(share)) < np.log(1.3)
