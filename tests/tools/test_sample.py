"""The sample that tells core-hours: it hits what it estimates, and says how far off it may be."""

from dataclasses import replace

import numpy as np
import pytest

from elastomer_friction.workflow.plan.cost import TYPICAL
from elastomer_friction.workflow.plan.plan import make_plan
from elastomer_friction.workflow.plan.problems import together
from elastomer_friction.workflow.simulate.realizations import block_means
from tests.support.small import small_plan, small_study
from tests.tools.sample import (
    cut_down,
    drawn,
    earlier_discretisation,
    earlier_steps,
    number_of_draws,
    ratio,
    strata,
    total,
)

PLAN = small_plan("study.realizations=64", "study.realizations_per_block=8")
WHOLE = strata(PLAN)


def test_strata_hold_all_the_work_of_a_plan():
    seconds = sum(stratum.seconds for stratum in WHOLE)
    assert seconds == pytest.approx(PLAN.prediction().seconds)
    records = sum(len(batch.tasks) * batch.blocks for s in WHOLE for batch in s.batches)
    assert records == PLAN.records


@pytest.mark.parametrize("seed", range(5))
def test_the_estimate_is_within_its_error_of_what_all_batches_take(seed):
    generator = np.random.default_rng(seed)
    truth, ratios = 0.0, []
    for stratum in WHOLE:
        wrong = dict(zip(map(id, stratum.batches), generator.uniform(0.3, 3.0, 999), strict=False))
        truth += sum(wrong[id(batch)] * batch.seconds for batch in stratum.batches)
        shares = np.array([batch.seconds for batch in stratum.batches]) / stratum.seconds
        chosen = generator.choice(stratum.batches, 200, p=shares)
        ratios.append([wrong[id(batch)] for batch in chosen])
    found = total([stratum.seconds for stratum in WHOLE], ratios)
    assert abs(found.value - truth) < 4.5 * found.error + 1e-9 * truth
    assert found.error < 0.2 * truth


def test_predictions_off_by_one_factor_leave_no_error():
    assert total([3.0, 5.0], [[2.0, 2.0], [2.0, 2.0, 2.0]]) == (16.0, 0.0)


def test_the_ratio_is_known_to_its_error():
    generator = np.random.default_rng(1)
    now = generator.uniform(0.5, 2.0, 400)
    found = ratio(20.0 * now * generator.uniform(0.5, 1.5, 400), now)
    assert abs(found.value - 20.0) < 4.0 * found.error < 4.0
    assert ratio([2.0, 4.0], [1.0, 2.0]) == (2.0, 0.0)


def test_draws_follow_the_cost_and_fill_the_time_asked_for():
    least, more = (sum(number_of_draws(WHOLE, 60, seconds)) for seconds in (0.0, 1e4))
    assert 60 <= least < more
    assert all(number >= 8 for number in number_of_draws(WHOLE, 1, 0.0))


def test_the_lines_of_a_draw_are_lines_of_its_batch():
    generator = np.random.default_rng(2)
    batch = replace(WHOLE[0].batches[0], first_block=1, blocks=3, seconds=300.0)
    firsts = set()
    for _ in range(100):
        draw = cut_down("", batch, generator)
        assert draw.share == pytest.approx(1.0 / 6.0)  # a quartet of three blocks of eight
        assert draw.batch.seconds == pytest.approx(50.0)
        firsts.add(draw.batch.first_block)
    assert firsts == {2, 3, 4, 5, 6, 7}  # quartets, two to a block


def test_a_short_batch_is_drawn_whole():
    batch = replace(WHOLE[0].batches[0], blocks=2, seconds=0.1)
    draw = cut_down("", batch, np.random.default_rng(3))
    assert draw.share == 1.0
    assert draw.batch.blocks * draw.batch.realizations_per_block == 16


def test_the_same_seed_draws_the_same():
    one, two = (
        [draw.batch for draw in drawn(WHOLE[0], 5, np.random.default_rng(7))] for _ in range(2)
    )
    assert one == two


def test_the_numbers_of_a_draw_are_those_of_the_study():
    batch = replace(WHOLE[1].batches[0], blocks=1, first_block=1)
    halves = [replace(batch, realizations_per_block=4, first_block=k) for k in (2, 3)]
    means = [block_means(half).scalars for half in halves]
    np.testing.assert_allclose(np.mean(means, axis=0), block_means(batch).scalars, rtol=1e-12)


def test_earlier_steps_are_powers_of_two_that_resolve_the_relaxation():
    study = small_study()
    (_, many) = together([task.problem for task in PLAN.variants[0].tasks])[0]
    steps = earlier_steps(many, study.scene, study.variants[""])
    assert (steps >= 4).all()
    assert (np.log2(steps) % 1.0 == 0.0).all()
    slow = many._replace(speed=0.01 * many.speed)
    assert (earlier_steps(slow, study.scene, study.variants[""]) >= 2.0 / slow.speed).all()
    assert (
        8 * earlier_steps(slow, study.scene, study.variants[""])
        == earlier_steps(slow, study.scene, replace_scheme(study))
    ).all()


def replace_scheme(study):
    return study.variants[""]._replace(scheme="implicit-euler")


def test_earlier_work_keeps_the_steps_that_are_given_and_refines_nothing():
    now = make_plan(small_study(), TYPICAL)
    with earlier_discretisation():
        then = make_plan(small_study(), TYPICAL)
        whole = strata(then)
    given, chosen = (
        [{task.steps_per_spacing for task in plan.variants[row].tasks} for plan in (now, then)]
        for row in (1, 0)
    )
    assert given == [{1}, {1}]
    assert chosen[0] != chosen[1]
    assert not any(batch.refine for stratum in whole for batch in stratum.batches)
    assert strata(now)[0].batches[0].refine
