"""Goals and steps: within the accuracy, cheapest, and within the memory of a worker."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.plan.error_laws import LAWS, relaxing_share, window_rate
from elastomer_friction.workflow.plan.goal import (
    BIAS,
    MAX_SAMPLES_PER_LINE,
    MIN_BLOCKS,
    MIN_RATE_BLOCKS,
    MOST_FOR_CONTACTS,
    allowed,
    goal_of,
    horizon_steps,
    least_steps,
    rung,
    steps_per_spacing,
    whole_blocks,
)
from elastomer_friction.workflow.plan.problems import stack_problems
from elastomer_friction.workflow.simulate.tasks import Problem
from elastomer_friction.workflow.study.numerics import Numerics
from elastomer_friction.workflow.study.study import Scene
from tests.support.small import small_plan, small_study

MANY = st.builds(
    lambda *numbers: Problem(*numbers),  # a builder of Problem would draw the fields of scenes too
    st.floats(0.0, 1.0),
    st.integers(100, 5000),
    st.floats(1e-3, 10.0),
    st.floats(0.03, 100.0),
    st.floats(0.5, 2.0),
)
WANTED = st.floats(0.003, 0.3)
SCENES = st.sampled_from([("steady",), ("steady", "jump"), ("steady", "jump", "relaxation")])


@given(MANY, WANTED, SCENES)
def test_half_of_the_accuracy_at_most_is_discretisation(problem, wanted, asked):
    goal = goal_of(problem, Scene(asked), Numerics(accuracy=wanted))
    coarse = problem.elements * goal.steps * 2 > MAX_SAMPLES_PER_LINE
    assert coarse or max(goal.bias.values()) <= 0.5 * wanted
    assert problem.elements * goal.steps <= MAX_SAMPLES_PER_LINE
    for name, bias in goal.bias.items():
        assert bias == LAWS[name].error(problem, goal.steps)
        need = (LAWS[name].scatter(problem) / allowed(wanted, bias)) ** 2
        assert goal.realizations >= need * (1 - 1e-12)


@given(MANY, WANTED, SCENES)
def test_twice_the_accuracy_never_takes_fewer_realizations(problem, wanted, asked):
    once = goal_of(problem, Scene(asked), Numerics(accuracy=wanted))
    twice = goal_of(problem, Scene(asked), Numerics(accuracy=wanted / 2))
    assert twice.realizations >= once.realizations


@given(MANY, WANTED)
def test_given_steps_stand_and_their_error_is_not_counted(problem, wanted):
    goal = goal_of(problem, Scene(), Numerics(steps_per_spacing=3, accuracy=wanted))
    assert goal.steps == 3
    assert set(goal.bias.values()) == {0.0}


def test_blocks_are_whole_and_capped():
    study = small_study("study.realizations=16")
    assert whole_blocks(study, 1.0, 1000) == MIN_RATE_BLOCKS
    assert whole_blocks(study, 129.0, 1000) == 33
    assert whole_blocks(study, 1e9, 1000) == 250
    steady = small_study("study.realizations=16", 'scene.quantities=["steady", "jump"]')
    assert whole_blocks(steady, 1.0, 1000) == MIN_BLOCKS


def test_an_accuracy_changes_steps_and_realizations_and_nothing_else():
    plain, wanted = small_plan(), small_plan("numerics.accuracy=0.05")
    assert not plain.variants[0].goals
    assert set(plain.first.values()) == set(plain.expected.values()) == {4}
    problems = [[task.problem for task in plan.variants[0].tasks] for plan in (plain, wanted)]
    assert problems[0] == problems[1]
    for key, blocks in wanted.expected.items():
        assert MIN_RATE_BLOCKS <= wanted.first[key] <= blocks
    assert wanted.records > plain.records


def test_a_negligible_relaxation_requires_no_realizations():
    slow = Problem(0.7, 1000, 1.0, 0.1, 1.2)  # below 1e-3 of the jump relaxes
    fast = slow._replace(load=0.01, speed=30.0)
    asked = Scene()
    for problem, share in ((slow, 0.01), (slow, 0.0), (fast, 0.01), (fast, 1.0)):
        goal = goal_of(problem, asked, Numerics(accuracy=0.1, negligible=share))
        assert (goal.scatter["relaxation_rate"] > 0.0) == (relaxing_share(problem) >= share)
        assert goal.realizations >= (goal.scatter["mu_1"] / 0.1) ** 2


@given(st.lists(MANY, min_size=2, max_size=5), WANTED, SCENES)
def test_goals_of_many_problems_are_those_of_each(problems, wanted, asked):
    scene, numerics = Scene(asked), Numerics(accuracy=wanted)
    found = [
        goal
        for rows, many in stack_problems(problems)
        for goal in goal_of(many, scene, numerics).split(rows.size)
    ]
    for problem, goal in zip(problems, found, strict=True):
        (alone,) = goal_of(problem, scene, numerics).split(1)
        assert goal.steps == alone.steps
        assert goal.realizations == pytest.approx(alone.realizations, rel=1e-9)
        assert goal.bias == pytest.approx(alone.bias, rel=1e-9)


HURST = st.floats(0.0, 1.0)
SPEED = st.floats(1e-3, 1e3)
RATIO = st.floats(0.1, 10.0)
LOAD = st.floats(1e-3, 25.0)
ALL = Scene()


def problem(hurst=0.7, elements=100, speed=1.0, ratio=1.2):
    """Return a problem."""
    return Problem(hurst, elements, 0.1, speed, ratio)


@given(HURST, SPEED, RATIO)
def test_automatic_steps_resolve_the_relaxation_at_the_slower_speed(hurst, speed, ratio):
    one = problem(hurst, 100, speed, ratio)
    steps = steps_per_spacing(one, ALL, Numerics())
    assert steps >= 4
    rate = max(1.0, (math.pi * speed) ** (1.0 - hurst))
    share = rate / (steps * speed * min(1.0, ratio))  # of a relaxation time, in a step
    assert share <= (0.27 if math.pi * speed >= 1.0 else 1.0) * (1 + 1e-6)


@given(HURST, st.integers(100, 10_000), LOAD, st.floats(0.03, 1e3), RATIO)
def test_automatic_steps_keep_two_per_cent_or_go_to_the_end_and_are_no_finer(
    hurst, elements, load, speed, ratio
):
    one = Problem(hurst, elements, load, speed, ratio)
    steps = steps_per_spacing(one, ALL, Numerics())
    kept = [law.error(one, steps) <= BIAS for law in LAWS.values()]
    assert all(kept) or steps >= MOST_FOR_CONTACTS
    if steps > 4:
        coarser = max(m for m in range(4, steps) if m == rung(m))
        bad = LAWS["relaxation_rate"].error(one, coarser) > BIAS
        assert bad or coarser < least_steps(one, ALL)


@given(HURST, SPEED, RATIO)
def test_four_steps_without_a_relaxation(hurst, speed, ratio):
    scene = Scene(("steady", "jump"))
    assert steps_per_spacing(problem(hurst, 100, speed, ratio), scene, Numerics()) == 4


@given(st.floats(0.1, 1e6))
def test_a_rung_is_at_most_half_as_much_again_as_is_needed(need):
    assert need * (1 - 1e-9) <= rung(need) <= max(1.0, 1.5 * need, need + 1.0)


def test_the_longest_line_allowed_is_allowed():
    numerics = Numerics(steps_per_spacing=MAX_SAMPLES_PER_LINE // 100)
    assert steps_per_spacing(problem(elements=100), ALL, numerics) == MAX_SAMPLES_PER_LINE // 100
    with pytest.raises(UserError, match=r"^numerics.steps_per_spacing = 60000: "):
        steps_per_spacing(problem(elements=101), ALL, numerics)


@given(HURST, SPEED, RATIO, st.floats(1.0, 100.0), st.integers(1, 1024))
def test_march_covers_the_horizon_and_no_more(hurst, speed, ratio, horizon, steps):
    one = problem(hurst, 100, speed, ratio)
    march = horizon_steps(one, Numerics(horizon=horizon), steps)
    needed = horizon / window_rate(one) * steps * speed * ratio
    assert window_rate(one) >= max(1.0, (math.pi * speed) ** (1.0 - hurst)) * (1.0 - 1e-12)
    assert march >= 8
    assert march >= needed
    assert march == 8 or march < needed * (1 + 1e-9) + 1
