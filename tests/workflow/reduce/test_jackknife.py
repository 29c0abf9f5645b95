"""Jackknife errors: the classical ones for a mean; tests/hard covers fitted values."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import array_shapes, arrays

from elastomer_friction.workflow.reduce.jackknife import (
    grouped_means,
    padded,
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
    actual = replicates(blocks, 0)
    assert len(actual) == len(blocks) + 1
    np.testing.assert_allclose(actual[0], blocks.mean(axis=0), atol=1e-12)
    for j in range(len(blocks)):
        expected = np.delete(blocks, j, axis=0).mean(axis=0)
        np.testing.assert_allclose(actual[j + 1], expected, atol=1e-12)


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
    assert not significant(np.array([1.0, np.inf, 1.2, 1.1]))
    assert not significant(np.array([1.0, 1e200, -1e200, 1.1]))


def test_a_number_must_exceed_three_standard_errors():
    """Of 16 groups: the sum of squares is 60, and the error the root of 15/16 of it, exactly."""
    values = 22.5 + np.array([0.0, *[2.0] * 6, *[-2.0] * 6, 3.0, -1.0, -1.0, -1.0])
    assert standard_error(values, 0) == 7.5
    assert not significant(values)
    values[0] *= 1.0 + 1e-9
    assert significant(values)


def test_groups_share_the_blocks_that_two_points_have_in_common():
    blocks = np.arange(12.0)
    assert grouped_means(blocks, 4).tolist() == [4.0, 5.0, 6.0, 7.0]
    assert grouped_means(blocks[:4], 4).tolist() == [0.0, 1.0, 2.0, 3.0]


@given(st.integers(2, 12), st.integers(0, 40))
def test_groups_of_unequal_size_have_the_mean_and_the_error_of_all_blocks(groups, more):
    """Over many draws: the expected square of the error is 1/count for blocks of variance one."""
    count = groups + more
    blocks = np.random.default_rng(count).standard_normal((count, 4000))
    grouped = grouped_means(blocks, groups)
    assert grouped.shape == (groups, 4000)
    np.testing.assert_allclose(grouped.mean(axis=0), blocks.mean(axis=0), atol=1e-12)
    error = standard_error(replicates(grouped, 0), 0)
    expected = np.sqrt(2.0 / (groups - 1) / 4000)  # of the mean square, one standard deviation
    if more == 0 or count >= 4 * groups:  # in between up to 12 % too small, see below
        assert np.mean(error**2) * count == pytest.approx(1.0, abs=5.0 * expected + 0.03)


@given(st.integers(2, 20), st.integers(0, 20))
def test_padded_replicates_have_the_same_estimate_and_error(own, more):
    values = replicates(np.random.default_rng(own).standard_normal((3, own)), 1)
    actual = padded(values, own + more)
    assert actual.shape == (3, own + more + 1)
    np.testing.assert_array_equal(actual[:, 0], values[:, 0])
    np.testing.assert_allclose(standard_error(actual, 1), standard_error(values, 1), rtol=1e-12)


def test_the_error_of_a_sum_includes_common_blocks():
    """One mean over 4 blocks and one over 16, the first 4 of them the same."""
    rng = np.random.default_rng(3)
    actual = []
    for _ in range(2000):
        blocks = rng.standard_normal(16)
        few, many = (padded(replicates(some, 0), 16) for some in (blocks[:4], blocks))
        actual.append(standard_error(few + many, 0) ** 2)
    expected = 1 / 4 + 1 / 16 + 2 / 16  # the covariance of the means is 1/16
    assert np.mean(actual) == pytest.approx(expected, rel=0.05)


def test_a_single_block_is_not_padded():
    assert padded(np.ones((2, 1)), 32).shape == (2, 1)


@pytest.mark.parametrize("count", [32, 40, 64, 96])
def test_values_equal_in_all_blocks_are_equal_in_all_groups(count):
    actual = grouped_means(np.full((count, 2), [0.1, np.nan]), 32)
    np.testing.assert_array_equal(actual, np.full((32, 2), [0.1, np.nan]))
