"""The sample of the cost: unbiased whatever is predicted, with a standard error that holds."""

import numpy as np
import pytest

from elastomer_friction.workflow.plan.batches import batch_of, cut, missing_work
from elastomer_friction.workflow.run import cost_sample
from elastomer_friction.workflow.run.cost_sample import (
    CostSample,
    Share,
    draw_weights,
    drawn_batch,
    sample_cost,
    share_of,
)
from elastomer_friction.workflow.simulate.drawing import drawn_lines
from elastomer_friction.workflow.simulate.realizations import block_means
from tests.support.documents import without
from tests.support.small import random_result, small_plan

PLAN = small_plan("study.realizations=64", "study.realizations_per_block=8")
PIECES = cut(missing_work(PLAN, ()), 1e-2)
SHORT, LONG = 1e-9, 1e9  # seconds of a draw


def fake_times(monkeypatch, seed):
    """Let batches take other times than predicted; return those of the whole plan."""
    factors = np.random.default_rng(seed).uniform(0.2, 5.0, len(PIECES))
    keys = {piece.tasks[0].key: row for row, piece in enumerate(PIECES)}
    assert len(keys) == len(PIECES)

    def timed(batch):
        row = keys[batch.tasks[0].key]
        lines = batch.blocks * batch.realizations_per_block
        seconds = factors[row] * PIECES[row].seconds / 8.0 * lines
        return random_result(batch)._replace(seconds=seconds)

    monkeypatch.setattr(cost_sample, "block_means", timed)
    monkeypatch.setattr(cost_sample, "DRAW_SECONDS", 1e-4)
    monkeypatch.setattr(cost_sample, "cut", lambda *_: PIECES)
    return sum(f * p.blocks * p.seconds for f, p in zip(factors, PIECES, strict=True))


@pytest.mark.parametrize("seed", range(6))
def test_the_estimate_is_within_its_error_of_the_truth(monkeypatch, seed):
    truth = fake_times(monkeypatch, seed)
    sample = sample_cost(PLAN, 0.1 * truth)
    assert sample.draws > 15
    assert abs(sample.seconds - truth) < 3.0 * sample.error
    assert sample.error < 0.3 * truth


def test_a_longer_sample_begins_with_the_same_draws_and_is_nearer(monkeypatch):
    truth = fake_times(monkeypatch, 1)
    short, again, long = (sample_cost(PLAN, share * truth) for share in (0.1, 0.1, 1.0))
    assert short == again
    assert long.draws > short.draws
    assert long.error < short.error


def test_too_few_draws_state_no_error(monkeypatch):
    truth = fake_times(monkeypatch, 1)
    draws = sample_cost(PLAN, 0.1 * truth).draws
    for least, stated in ((draws, True), (draws + 1, False)):
        monkeypatch.setattr(cost_sample, "MIN_DRAWS", least)
        assert (sample_cost(PLAN, 0.1 * truth).error is not None) is stated
    sample = sample_cost(PLAN, 1e-9)
    assert (sample.draws, sample.error) == (1, None)
    assert str(sample).endswith("from 1 sample, too few to state an error")


@pytest.mark.parametrize(
    ("sample", "words"),
    [
        (CostSample(45000.0, 1440.0, 43), "12.5 ± 0.4 core-hours from 43 samples"),
        (CostSample(7920.0, 360.0, 20), "2.2 ± 0.1 core-hours from 20 samples"),
        (CostSample(471600.0, 36000.0, 60), "131 ± 10 core-hours from 60 samples"),
        (CostSample(3.21, 0.012, 9), "3.21 ± 0.01 core-seconds from 9 samples"),
        (CostSample(600.0, None, 3), "about 10 core-minutes from 3 samples, too few to state an"),
    ],
)
def test_a_sample_in_words_has_the_digits_of_its_error(sample, words):
    assert str(sample).startswith(words)


def test_a_draw_is_a_few_quartets_of_a_piece_or_one_line():
    piece = PIECES[0]._replace(first_block=1, blocks=3)
    assert share_of(piece, LONG) == Share(4, 6, 6, 4)
    assert share_of(piece, piece.seconds) == Share(4, 6, 2, 4)  # of a block of eight
    short = share_of(piece, SHORT)
    assert short == Share(4, 6, 1, 1)
    assert short.share == pytest.approx(1.0 / 24.0)
    generator = np.random.default_rng(2)
    firsts = {drawn_batch(piece, short, generator).first_block for _ in range(100)}
    assert firsts == {2, 3, 4, 5, 6, 7}  # quartets, two to a block


def test_draws_compute_lines_of_the_study():
    piece = PIECES[-1]
    whole = batch_of(piece, 1, 1)
    halves = Share(4, 2 * piece.blocks, 1, 4)
    generator = np.random.default_rng(3)
    batches = {}
    while {2, 3} - batches.keys():
        batch = drawn_batch(piece, halves, generator)
        batches[batch.first_block] = batch
    means = [block_means(batches[quartet]).scalars for quartet in (2, 3)]
    np.testing.assert_allclose(np.mean(means, axis=0), block_means(whole).scalars, rtol=1e-12)
    single = drawn_batch(piece, halves._replace(lines=1), generator)
    quartet = batch_of(piece, single.first_block // 2, 1)
    first, others = drawn_lines(single)[1](0)(4), drawn_lines(quartet)[1]
    (line,) = first
    np.testing.assert_array_equal(line.z, next(iter(others(4 * (single.first_block % 2))(4))).z)


@pytest.mark.parametrize(
    ("plan", "unit"),
    [
        (small_plan("scene.body=half-space", "grid.spacing=1e-3"), 1),
        (
            small_plan(
                'surface.file="line.csv"',
                text=without(
                    "surface.length",
                    "grid.hurst",
                    "grid.spacing",
                    "grid.roughness",
                    "study.realizations",
                ),
            ),
            1,
        ),
    ],
)
def test_maps_and_measured_lines_are_drawn_too(plan, unit):
    for piece in cut(missing_work(plan, ()), 1.0):
        share = share_of(piece, SHORT)
        if piece.variant is not plan.other_body:  # lines for comparison with the maps
            assert (share.size, share.lines) == (unit, unit)
        batch = drawn_batch(piece, share, np.random.default_rng(1))
        assert np.isfinite(block_means(batch).seconds)


def test_long_draws_are_rarer_than_their_share_of_the_work():
    shares = [Share(4, 8, 1, 1)] * 2
    pieces = [PIECES[0]._replace(blocks=4, seconds=seconds) for seconds in (1.0, 100.0)]
    one, other = draw_weights(pieces, shares, 1e-9)
    assert other == pytest.approx(10.0 * one)
    one, other = draw_weights(pieces, shares, LONG)
    assert other == pytest.approx(100.0 * one)
