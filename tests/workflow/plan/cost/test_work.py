"""The cost model: additive, increasing, and true in what does not depend on a machine."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from elastomer_friction.kernels import (
    KELVIN,
    Line,
    Quantities,
    Slide,
    Spectrum,
    amplitudes,
    draw_phases,
    rms_slope,
)
from elastomer_friction.kernels.model.steady import steady_sliding
from elastomer_friction.kernels.motion.stretches import touchable
from elastomer_friction.kernels.quick.contacts.steady_friction import (
    AtSpeed,
    Grounds,
    follow_contacts,
    steady_friction,
)
from elastomer_friction.kernels.rheology.kelvin import SCHEMES
from elastomer_friction.workflow.plan.cost.timing import PROBES, batch, factors, typical
from elastomer_friction.workflow.plan.cost.work import (
    DRAWING,
    PARTS,
    Work,
    drawing_seconds,
    followed_patches,
    gone_back,
    kind_of,
    touchable_share,
    typical_seconds,
)
from elastomer_friction.workflow.simulate.tasks import LineShape, Problem, Recording

# H, N, Fbar, vbar, r = v2/v1
PROBLEMS = st.builds(
    lambda *numbers: Problem(*numbers),
    st.floats(0.0, 1.0),
    st.integers(100, 100_000),
    st.floats(1e-4, 100.0),
    st.floats(1e-3, 1e4),
    st.floats(0.1, 10.0),
)


ALL = Quantities()
BRANCH = Spectrum((1.0,), (1.0,), 1.0)


def parts_of(problem, steps=4, march_steps=100, asked=ALL, **how):
    """Return the typical time of a problem by part."""
    kept = ("trace",) if problem.programme else ()
    work = Work(problem, steps, march_steps, **how)
    return typical_seconds(asked, work, Recording(64, requested=kept))


AT = Problem(0.7, 2500, 0.05, 1.0, 1.2)


def parts(**what):
    """Return the typical time of a task by part."""
    fields = {name: what.pop(name) for name in Problem._fields if name in what}
    return parts_of(AT._replace(**fields), **what)


def slides(distance, count=1, **what):
    """Return what takes an element with a branch through slides, in whole steps or not."""
    return {"programme": (Slide(1.0, distance),) * count, "spectrum": BRANCH, **what}


LONG = {"elements": 10_000, "load": 0.1, "march_steps": 200}
FULL = LONG | {"load": 1000.0}
NARROW = {"hurst": 0.2, "elements": 10_000, "load": 0.1, "speed": 30.0, "loads": 20, "tasks": 20}
LIGHT, HEAVY = ({"elements": 5000, "load": load, "spectrum": BRANCH} for load in (0.01, 10.0))


@pytest.mark.parametrize(
    ("part", "cheap", "dear", "factor"),
    [
        (None, {"elements": 1250}, {}, 1.0),
        (None, {"march_steps": 50}, {}, 1.0),
        (None, {"asked": ALL._replace(jump=False)}, {}, 1.0),
        (None, {"asked": ALL._replace(steady=False, relaxation=False)}, {}, 1.0),
        ("marching", LIGHT, HEAVY, 3.0),  # what cannot touch is left out
        ("marching", slides(10.0), slides(10.1), 1.0),  # a step more, between the samples
        ("marching", slides(0.25, 20), slides(0.2, 20), 1.5),  # all of them between
        ("marching", slides(1.0, start="rest"), slides(1.0), 1.2),  # steady sliding comes first
        ("steady", slides(1.0), slides(1.0, speed=1e6), 1.2),  # of elements with branches
        ("marching", FULL, LONG, 3.0),
        ("steady", FULL, LONG, 1.0),
        ("steady", {**NARROW, "steps": 2}, {**NARROW, "steps": 8}, 3.0),  # contacts are followed
    ],
)
def test_more_work_takes_more_time(part, cheap, dear, factor):
    less, more = (parts(**what) for what in (cheap, dear))
    chosen = [part] if part else PARTS
    assert sum(more[name] for name in chosen) > factor * sum(less[name] for name in chosen)


def test_a_scheme_of_first_order_moves_what_cannot_touch_too():
    light, heavy = (parts(**what, scheme="implicit-euler")["marching"] for what in (LIGHT, HEAVY))
    assert light == heavy


def test_loads_at_a_speed_and_tasks_on_lines_share_what_they_can():
    def whole(count, **shared):
        return {part: count * t for part, t in parts(**shared).items()}

    alone, together = whole(20), whole(20, loads=20, tasks=20)
    for part in ("steady", "jump", "calls"):
        assert whole(1)[part] < together[part] < 0.8 * alone[part]
    assert together["marching"] == alone["marching"]
    on_a_line = whole(20, tasks=20)  # at speeds of their own
    assert together["steady"] < on_a_line["steady"] < alone["steady"]
    assert together["calls"] < on_a_line["calls"] < alone["calls"]


def test_every_part_is_told_and_what_is_not_asked_for_takes_none():
    assert set(parts()) == set(PARTS)
    steady = parts(asked=ALL._replace(jump=False, relaxation=False), march_steps=0)
    assert steady["jump"] == steady["marching"] == 0.0 < steady["steady"]


def test_branches_and_programmes_are_work_of_another_kind():
    marched = Recording(64, requested=("trace",))
    plain, of_branches = (Problem(0.7, 100, 0.1, 1.0, 1.2, own) for own in (KELVIN, BRANCH))
    kinds = [kind_of(one, Recording(64)) for one in (plain, of_branches)]
    assert len({*kinds, kind_of(plain, marched)}) == 3
    assert kind_of(of_branches, marched) == kind_of(plain, marched)
    on_half_space = plain._replace(surface=LineShape(body="half-space"))
    assert kind_of(on_half_space, marched) == kind_of(on_half_space, Recording(64))
    assert kind_of(on_half_space, marched) not in {*kinds, kind_of(plain, marched)}


def test_steady_states_of_other_slides_are_calls():
    legs = Slide(1.0, 1.0), Slide(2.0, 1.0)
    same, other = (
        parts(spectrum=BRANCH, ratio=2.0, programme=own) for own in (legs, (*legs, legs[0]))
    )
    assert other["calls"] == pytest.approx(same["calls"] + same["steady"])


@given(PROBLEMS, st.sampled_from([1, 4, 6, 64]), st.integers(8, 10_000))
def test_all_parts_of_any_problem_take_some_time_whichever_way_it_slides(problem, m, march):
    here = parts_of(problem, m, march)
    assert here.pop(DRAWING) == 0.0  # the line exists
    assert all(np.isfinite(value) and value > 0.0 for value in here.values())
    back = parts_of(problem._replace(speed=-problem.speed), m, march)
    assert here == {name: back[name] for name in here}


def test_patches_that_are_followed_are_those_of_the_kernels():
    ratio = []
    for hurst, load, speed in ((0.0, 0.1, 3.0), (0.2, 0.03, 30.0), (0.5, 0.3, 100.0)):
        problem = Problem(hurst, 3000, load, speed, 1.2)
        phases = draw_phases(np.random.default_rng(1), 3000)
        grounds = Grounds.of([*Line.quartet(amplitudes(hurst, 3000), phases, 3000, 4)])
        pace = AtSpeed.of("exponential", 4, speed)
        found = follow_contacts(steady_friction(grounds, pace, np.array([load * 12_000]), True))
        ratio.append(found[0] / len(grounds.each) / followed_patches(problem))
    assert 0.5 < min(ratio) <= max(ratio) < 2.0


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


def test_shares_are_those_of_the_kernels():
    share = [np.log(row[3] / touchable_share(*row[:3])) for row in states()]
    assert np.median(np.abs(share)) < np.log(1.5)
    assert abs(np.mean(share)) < np.log(1.3)


def test_marches_begin_anew_near_h_of_one_at_high_speed():
    often, seldom = (gone_back(Problem(h, 1e4, 1.0, 1e6, 1.2)) for h in (1.0, 0.5))
    assert often > 2.4 > 1.01 > max(seldom, gone_back(Problem(1.0, 1e4, 1.0, 9.0, 1.2)))


def test_lines_are_drawn_at_no_less_for_more_samples():
    seconds = drawing_seconds(np.geomspace(1.0, 1e7, 50))
    assert (np.diff(seconds) > 0.0).all()


@pytest.mark.exhaustive  # computes all probes
def test_every_part_is_timed():
    found = factors(rounds=2)
    assert set(found) == set(PARTS)
    for factor, worst in found.values():
        assert factor > 0.0
        assert worst >= 1.0


def test_probes_have_work_in_every_part():
    for probe in PROBES:
        assert (typical(batch(*probe)) > 0.0).all()
