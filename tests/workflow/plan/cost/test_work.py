"""The cost model: additive, increasing, and true in what does not depend on a machine."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from elastomer_friction.kernels import KELVIN, Quantities, Slide, Spectrum
from elastomer_friction.workflow.plan.cost.work import (
    DRAWING,
    PARTS,
    Work,
    kind_of,
    typical_seconds,
)
from elastomer_friction.workflow.simulate.tasks import Problem, Recording
from tests.workflow.plan.cost.problems import PROBLEMS

ALL = Quantities()
BRANCH = Spectrum((1.0,), (1.0,), 1.0)


def parts(elements=2500, march_steps=100, asked=ALL):
    """Return the typical time of a task by part."""
    problem = Problem(0.7, elements, 0.05, 1.0, 1.2)
    return typical_seconds(asked, Work(problem, 4, march_steps), Recording(64))


def parts_of(problem, steps, march_steps, loads=1):
    """Return the typical time of a problem by part, where so many loads share its sweeps."""
    work = Work(problem, steps, march_steps, True, loads, loads)
    return typical_seconds(ALL, work, Recording(64))


def seconds(**what):
    """Return the typical time of a task."""
    return sum(parts(**what).values())


@pytest.mark.parametrize(
    "less",
    [
        {"elements": 1250},
        {"march_steps": 50},
        {"asked": ALL._replace(jump=False)},
        {"asked": ALL._replace(steady=False, relaxation=False)},
    ],
)
def test_more_work_takes_more_time(less):
    assert seconds() > seconds(**less)


def test_loads_at_a_speed_and_tasks_on_lines_share_what_they_can():
    def whole(count, **shared):
        problem = Problem(0.7, 2500, 0.05, 1.0, 1.2)
        work = Work(problem, 4, 100, True, **shared)
        return {part: count * t for part, t in typical_seconds(ALL, work, Recording(64)).items()}

    alone, together = whole(20), whole(20, loads=20, tasks=20)
    for part in ("steady", "jump", "calls"):
        assert whole(1)[part] < together[part] < 0.8 * alone[part]
    assert together["marching"] == alone["marching"]
    on_a_line = whole(20, tasks=20)  # at speeds of their own
    assert on_a_line["steady"] == alone["steady"]
    assert together["calls"] < on_a_line["calls"] < alone["calls"]


def test_every_part_is_told_and_what_is_not_asked_for_takes_none():
    assert set(parts()) == set(PARTS)
    steady = parts(asked=ALL._replace(jump=False, relaxation=False), march_steps=0)
    assert steady["jump"] == steady["marching"] == 0.0 < steady["steady"]


def test_branches_and_programmes_are_work_of_another_kind():
    marched = Recording(64, asked=("trace",))
    kinds = [kind_of(*of) for of in ((KELVIN, Recording(64)), (BRANCH, Recording(64)))]
    assert len({*kinds, kind_of(KELVIN, marched)}) == 3
    assert kind_of(BRANCH, marched) == kind_of(KELVIN, marched)


def scene(*legs, speed=1.0, ratio=1.0, asked=ALL, start="steady"):
    """Return the typical time of elements with a branch that are taken through legs, by part."""
    problem = Problem(0.7, 500, 0.1, speed, ratio, BRANCH, programme=legs, start=start)
    return typical_seconds(asked, Work(problem, 4, 0), Recording(64, asked=("trace",)))


def test_steps_to_between_the_samples_are_dear():
    whole, between = (scene(Slide(1.0, distance)) for distance in (10.0, 10.1))
    assert between["marching"] > whole["marching"]  # one step more, to a line that is shifted
    whole, between = (scene(*[Slide(1.0, d)] * 20)["marching"] for d in (0.25, 0.2))
    assert between > 1.5 * whole  # the same number of steps


def test_a_scene_that_begins_in_steady_sliding_finds_that_first():
    steady, rest = (scene(Slide(1.0, 1.0), start=start) for start in ("steady", "rest"))
    assert steady["marching"] > 2.0 * rest["marching"]


def test_steady_states_of_other_slides_are_calls():
    legs = Slide(1.0, 1.0), Slide(2.0, 1.0)
    same, other = scene(*legs, ratio=2.0), scene(*legs, Slide(1.0, 1.0), ratio=2.0)
    assert other["calls"] == pytest.approx(same["calls"] + same["steady"])


def test_fast_sliding_takes_more_sweeps():
    slow, fast = (scene(Slide(v, 1.0), speed=v)["steady"] for v in (1.0, 1e6))
    assert fast > 1.5 * slow


@given(PROBLEMS, st.sampled_from([1, 4, 6, 64]), st.integers(8, 10_000))
def test_all_parts_of_any_problem_take_some_time_whichever_way_it_slides(problem, m, march):
    here = parts_of(problem, m, march)
    assert here.pop(DRAWING) == 0.0  # the line exists
    assert all(np.isfinite(value) and value > 0.0 for value in here.values())
    back = parts_of(problem._replace(speed=-problem.speed), m, march)
    assert here == {name: back[name] for name in here}


def test_full_contact_takes_no_marching_to_speak_of():
    light, heavy = (
        parts_of(Problem(0.7, 10_000, load, 1.0, 1.2), 4, 200) for load in (0.1, 1000.0)
    )
    assert heavy["marching"] < 0.1 * light["marching"]
    assert heavy["steady"] < light["steady"]


def test_narrow_contacts_are_dear_where_they_are_refined():
    at = Problem(0.2, 10_000, 0.1, 30.0, 1.2)
    refined, plain = (parts_of(at, m, 20, loads=20)["steady"] for m in (8, 2))
    assert refined > 5.0 * plain > 0.0
