"""The sample that tells core-hours: it hits what it estimates, and says how far off it may be."""

from dataclasses import replace

import numpy as np
import pytest

from elastomer_friction.workflow.simulate.drawing import drawn_lines
from elastomer_friction.workflow.simulate.realizations import block_means
from tests.support.small import small_plan
from tests.tools.sample import (
    cut_down,
    number_of_draws,
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


def test_draws_follow_the_cost_and_fill_the_time_asked_for():
    least, more = (sum(number_of_draws(WHOLE, 60, seconds)) for seconds in (0.0, 1e4))
    assert 60 <= least < more
    assert all(number >= 8 for number in number_of_draws(WHOLE, 1, 0.0))


def test_the_lines_of_a_draw_are_lines_of_its_batch():
    generator = np.random.default_rng(2)
    batch = replace(WHOLE[0].batches[0], first_block=1, blocks=3, seconds=30.0)
    firsts = set()
    for _ in range(100):
        draw = cut_down("", batch, generator)
        assert draw.share == pytest.approx(1.0 / 6.0)  # a quartet of three blocks of eight
        assert draw.batch.seconds == pytest.approx(5.0)
        assert draw.first_line == 4 * draw.batch.first_block
        firsts.add(draw.batch.first_block)
    assert firsts == {2, 3, 4, 5, 6, 7}  # quartets, two to a block


def test_the_numbers_of_a_draw_are_those_of_the_study():
    batch = replace(WHOLE[1].batches[0], blocks=1, first_block=1)
    halves = [replace(batch, realizations_per_block=4, first_block=k) for k in (2, 3)]
    means = [block_means(half).scalars for half in halves]
    np.testing.assert_allclose(np.mean(means, axis=0), block_means(batch).scalars, rtol=1e-12)


def test_of_a_quartet_that_takes_long_the_first_line_alone_is_run():
    quartet = replace(
        WHOLE[0].batches[0], realizations_per_block=4, blocks=1, first_block=3, seconds=40.0
    )
    draw = cut_down("", quartet, np.random.default_rng(1))
    assert (draw.share, draw.batch.seconds, draw.first_line) == (0.25, 10.0, 12)
    run, of_quartet = (list(drawn_lines(one)[1](0)(4)) for one in (draw.batch, quartet))
    assert (len(run), len(of_quartet)) == (1, 4)
    np.testing.assert_array_equal(run[0].z, of_quartet[0].z)
