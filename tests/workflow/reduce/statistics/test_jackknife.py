"""The jackknife: classical for a mean, from two blocks on; for what is fitted see tests/hard."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import array_shapes, arrays

from workflow.reduce.statistics.jackknife import (
    grouped_means,
    replicates,
    significant,
    standard_error,
)

BLOCKS = arrays(float, array_shapes(min_dims=2, max_dims=3, min_side=2), elements=st.floats(-9, 9))


@given(BLOCKS, st.sampled_from([0, 1]))
def test_error_of_a_mean_is_the_classical_one(blocks, axis):
    count = blocks.shape[axis]
    classical = np.std(blocks, axis=axis, ddof=1) / np.sqrt(count)
    error = standard_error(replicates(blocks, axis), axis)
    assert error.shape == classical.shape
    np.testing.assert_allclose(error, classical, rtol=1e-9, atol=1e-12)


@given(BLOCKS)
def test_replicates_are_the_mean_and_the_means_with_one_block_left_out(blocks):
    found = replicates(blocks, 0)
    assert len(found) == len(blocks) + 1
    np.testing.assert_allclose(found[0], blocks.mean(axis=0), atol=1e-12)
    for j in range(len(blocks)):
        expected = np.delete(blocks, j, axis=0).mean(axis=0)
        np.testing.assert_allclose(found[j + 1], expected, atol=1e-12)


def test_the_estimate_itself_does_not_enter_its_error():
    values = replicates(np.array([1.0, 2.0, 4.0]), 0)
    shifted = np.concatenate([values[:1] + 7.0, values[1:]])
    assert standard_error(shifted, 0) == standard_error(values, 0)


def test_no_number_stays_no_number():
    assert np.isnan(standard_error(replicates(np.array([1.0, np.nan, 2.0]), 0), 0))


@pytest.mark.parametrize("value", [1.0, -3e-20, 4.46e18])
@pytest.mark.parametrize("spread", [0.0, 1e-17])
def test_replicates_that_agree_to_rounding_are_not_significant(value, spread):
    noise = np.random.default_rng(4).standard_normal(21)
    assert not significant(value * (1.0 + spread * noise))
    assert significant(value * (1.0 + 1e-9 * noise))


def test_zero_and_no_number_are_not_significant():
    assert not significant(np.zeros(21))
    assert not significant(np.array([1.0, 1.0, np.nan, 1.1]))
    assert not significant(np.array([np.inf, 1.0, 1.2, 1.1]))


def test_groups_share_the_blocks_that_two_points_have_in_common():
    blocks = np.arange(12.0)
    assert grouped_means(blocks, 4).tolist() == [4.0, 5.0, 6.0, 7.0]
    assert grouped_means(blocks[:4], 4).tolist() == [0.0, 1.0, 2.0, 3.0]
