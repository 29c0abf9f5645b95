"""Goals: fine enough, not finer than pays, never beyond what fits, and the same every time."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from elastomer_friction.workflow.errors import UserError
from elastomer_friction.workflow.plan.error_laws import LAWS, relaxing_share
from elastomer_friction.workflow.plan.goal import (
    LEAST_BLOCKS,
    LEAST_FOR_RATE,
    MAX_SAMPLES_PER_LINE,
    allowed,
    goal_of,
    whole_blocks,
)
from elastomer_friction.workflow.plan.problems import together
from elastomer_friction.workflow.simulate.tasks import Problem
from elastomer_friction.workflow.study.numerics import Numerics
from elastomer_friction.workflow.study.study import Scene
from tests.support.small import small_plan, small_study

PROBLEMS = st.builds(
    lambda *numbers: Problem(*numbers),  # a builder of Problem would draw the fields of scenes too
    st.floats(0.0, 1.0),
    st.integers(100, 5000),
    st.floats(1e-3, 10.0),
    st.floats(0.03, 100.0),
    st.floats(0.5, 2.0),
)
WANTED = st.floats(0.003, 0.3)
SCENES = st.sampled_from([("steady",), ("steady", "jump"), ("steady", "jump", "relaxation")])


@given(PROBLEMS, WANTED, SCENES)
def test_half_of_the_accuracy_at_most_is_discretisation(problem, wanted, asked):
    goal = goal_of(problem, Scene(asked), Numerics(accuracy=wanted))
    coarse = problem.elements * goal.steps * 2 > MAX_SAMPLES_PER_LINE
    assert coarse or max(goal.bias.values()) <= 0.5 * wanted
    assert problem.elements * goal.steps <= MAX_SAMPLES_PER_LINE
    for name, bias in goal.bias.items():
        assert bias == LAWS[name].error(problem, goal.steps)
        need = (LAWS[name].scatter(problem) / allowed(wanted, bias)) ** 2
        assert goal.realizations >= need * (1 - 1e-12)


@given(PROBLEMS, WANTED, SCENES)
def test_twice_the_accuracy_never_takes_fewer_realizations(problem, wanted, asked):
    once = goal_of(problem, Scene(asked), Numerics(accuracy=wanted))
    twice = goal_of(problem, Scene(asked), Numerics(accuracy=wanted / 2))
    assert twice.realizations >= once.realizations


@given(PROBLEMS, WANTED)
def test_given_steps_stand_and_their_error_is_not_counted(problem, wanted):
    goal = goal_of(problem, Scene(), Numerics(steps_per_spacing=3, accuracy=wanted))
    assert goal.steps == 3
    assert set(goal.bias.values()) == {0.0}


def test_blocks_are_whole_and_capped():
    study = small_study("study.realizations=16")
    assert whole_blocks(study, 1.0, 1000) == LEAST_FOR_RATE
    assert whole_blocks(study, 129.0, 1000) == 33
    assert whole_blocks(study, 1e9, 1000) == 250
    steady = small_study("study.realizations=16", 'scene.quantities=["steady", "jump"]')
    assert whole_blocks(steady, 1.0, 1000) == LEAST_BLOCKS


def test_a_cap_below_the_least_is_one_clear_line():
    with pytest.raises(UserError, match=r"^numerics.max_realizations = 31: must be at least 8 "):
        small_plan("numerics.accuracy=0.1", "numerics.max_realizations=31")


def test_an_accuracy_changes_steps_and_realizations_and_nothing_else():
    plain, wanted = small_plan(), small_plan("numerics.accuracy=0.05")
    assert not plain.variants[0].goals
    assert set(plain.first.values()) == set(plain.expected.values()) == {4}
    problems = [[task.problem for task in plan.variants[0].tasks] for plan in (plain, wanted)]
    assert problems[0] == problems[1]
    for key, blocks in wanted.expected.items():
        assert LEAST_FOR_RATE <= wanted.first[key] <= blocks
    assert wanted.records > plain.records


def test_a_rate_of_next_to_nothing_asks_for_nothing():
    slow = Problem(0.7, 1000, 1.0, 0.1, 1.2)  # below 1e-3 of the jump relaxes
    fast = slow._replace(load=0.01, speed=30.0)
    asked = Scene()
    for problem, share in ((slow, 0.01), (slow, 0.0), (fast, 0.01), (fast, 1.0)):
        goal = goal_of(problem, asked, Numerics(accuracy=0.1, negligible=share))
        assert (goal.scatter["relaxation_rate"] > 0.0) == (relaxing_share(problem) >= share)
        assert goal.realizations >= (goal.scatter["mu_1"] / 0.1) ** 2


@given(st.lists(PROBLEMS, min_size=2, max_size=5), WANTED, SCENES)
def test_goals_of_many_problems_are_those_of_each(problems, wanted, asked):
    scene, numerics = Scene(asked), Numerics(accuracy=wanted)
    found = [
        goal
        for rows, many in together(problems)
        for goal in goal_of(many, scene, numerics).each(rows.size)
    ]
    for problem, goal in zip(problems, found, strict=True):
        (alone,) = goal_of(problem, scene, numerics).each(1)
        assert goal.steps == alone.steps
        assert goal.realizations == pytest.approx(alone.realizations, rel=1e-9)
        assert goal.bias == pytest.approx(alone.bias, rel=1e-9)
