"""Goals: fine enough, not finer than pays, never beyond what fits, and the same every time."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.workflow.small import small_plan, small_study
from workflow.errors import UserError
from workflow.plan.error_laws import LAWS
from workflow.plan.goal import JACKKNIFE_GROUPS, allowed, goal_of, whole_blocks
from workflow.plan.resolution import MAX_SAMPLES_PER_LINE
from workflow.run.rounds import next_blocks
from workflow.simulate.tasks import Problem
from workflow.study.numerics import Numerics
from workflow.study.study import Scene

PROBLEMS = st.builds(
    Problem,
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
        assert bias == LAWS[name].error(problem).at(goal.steps)
        need = (LAWS[name].scatter(problem) / allowed(wanted, bias)) ** 2
        assert goal.realizations >= need * (1 - 1e-12)


@given(PROBLEMS, WANTED, SCENES)
def test_twice_the_accuracy_never_takes_fewer_realizations(problem, wanted, asked):
    once, twice = (
        goal_of(problem, Scene(asked), Numerics(accuracy=value)) for value in (wanted, wanted / 2)
    )
    assert twice.realizations >= once.realizations


@given(PROBLEMS, WANTED)
def test_given_steps_stand_and_their_error_is_not_counted(problem, wanted):
    goal = goal_of(problem, Scene(), Numerics(steps_per_spacing=3, accuracy=wanted))
    assert goal.steps == 3
    assert set(goal.bias.values()) == {0.0}


@given(st.integers(1, 20), st.floats(0.0, 1e9), st.integers(1, 500))
def test_the_next_round_grows_within_the_cap(layers, growth, most):
    now, most = JACKKNIFE_GROUPS * layers, JACKKNIFE_GROUPS * max(layers, most)
    found = next_blocks(now, growth, most)
    assert found % JACKKNIFE_GROUPS == 0
    assert found <= most
    if growth <= 1.0 or now == most:
        assert found == now
    else:
        assert now < found <= 4 * now + JACKKNIFE_GROUPS
        assert found == most or found >= min(growth, 4.0) * now - 1e-6


def test_an_unknown_error_quadruples_the_realizations():
    most = 100 * JACKKNIFE_GROUPS
    assert next_blocks(JACKKNIFE_GROUPS, float("inf"), most) == 4 * JACKKNIFE_GROUPS


def test_blocks_are_whole_and_capped():
    study = small_study("study.realizations=8", "study.realizations_per_block=2")
    assert whole_blocks(study, 1.0, 1000) == JACKKNIFE_GROUPS
    assert whole_blocks(study, 2 * JACKKNIFE_GROUPS + 1, 1000) == 2 * JACKKNIFE_GROUPS
    assert whole_blocks(study, 1e9, 1000) == 15 * JACKKNIFE_GROUPS  # 960 realizations


def test_a_cap_below_the_least_is_one_clear_line():
    with pytest.raises(UserError, match=r"^numerics.max_realizations = 31: must be at least 32 "):
        small_plan("numerics.accuracy=0.1", "numerics.max_realizations=31")


BAD = {
    "numerics.accuracy=0": "must lie between 0.0001 and 0.3",
    "numerics.accuracy=1": "must lie between",
    "numerics.accuracy=nan": "must be a finite number",
    'numerics.accuracy="high"': "must be a finite number",
    "numerics.max_realizations=0": "must be a whole number",
    "compare.coarse.accuracy=-1": "compare.coarse.accuracy = -1.0: must lie",
}


@pytest.mark.parametrize("setting", BAD)
def test_bad_accuracy_names_the_key(setting):
    with pytest.raises(UserError) as error:
        small_plan(setting)
    assert BAD[setting] in str(error.value)


def test_a_scheme_of_first_order_is_refused_where_the_steps_are_chosen():
    with pytest.raises(UserError, match=r"numerics.scheme = 'implicit-euler'"):
        small_plan("numerics.accuracy=0.1", "numerics.scheme=implicit-euler")


def test_an_accuracy_changes_steps_and_realizations_and_nothing_else():
    plain, wanted = small_plan(), small_plan("numerics.accuracy=0.05")
    assert not plain.variants[0].goals
    assert set(plain.first.values()) == set(plain.expected.values()) == {4}
    assert [t.problem for t in wanted.variants[0].tasks] == [
        t.problem for t in plain.variants[0].tasks
    ]
    for key, blocks in wanted.expected.items():
        assert blocks % JACKKNIFE_GROUPS == 0
        assert JACKKNIFE_GROUPS <= wanted.first[key] <= blocks
    assert wanted.records > plain.records


def test_below_one_percent_the_march_is_longer_unless_a_horizon_is_given():
    settings = (), ("numerics.accuracy=0.01",), ("numerics.accuracy=0.005",)
    horizons = [small_study(*some).variants[""].horizon for some in settings]
    assert horizons == [4.0, 4.0, 6.0]
    given = small_study("numerics.accuracy=0.005", "numerics.horizon=3")
    assert given.variants[""].horizon == 3.0
