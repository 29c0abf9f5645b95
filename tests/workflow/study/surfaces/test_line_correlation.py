"""Rows of a map are no independent lines: how many make one, and blocks of them."""

import numpy as np
import pytest

from elastomer_friction.kernels import amplitudes, draw_phases, sample_line
from elastomer_friction.workflow.study.surfaces.line_correlation import (
    LineCorrelation,
    line_correlation,
)
from elastomer_friction.workflow.study.surfaces.profile import level

REACH = 5.0  # rows


def rows_of_a_map(seed, rows=160, samples=96):
    """Return rows whose heights correlate as exp(-(k/REACH)^2), k rows apart."""
    rng = np.random.default_rng(seed)
    apart = np.arange(-40, 41)
    weights = np.exp(-2.0 * (apart / REACH) ** 2)
    white = rng.normal(size=(rows + 80, samples))
    mixed = np.apply_along_axis(np.convolve, 0, white, weights, "valid")
    q = np.fft.rfftfreq(samples)
    shaped = np.fft.rfft(mixed, axis=1) * np.maximum(q, 0.03) ** -1.2
    return level(np.fft.irfft(shaped, samples, axis=1), "mean")


def test_the_rows_that_are_worth_one_line_are_the_integral_of_their_correlation():
    found = [line_correlation(rows_of_a_map(seed)) for seed in range(20)]
    assert all(each is not None for each in found)
    assert np.mean([each.correlation for each in found]) == pytest.approx(
        np.exp(-((1.0 / REACH) ** 2)), abs=0.01
    )
    assert np.mean([each.lines for each in found]) == pytest.approx(
        np.sqrt(np.pi) * REACH, rel=0.15
    )


def test_errors_from_blocks_are_right_within_a_factor_of_1_5():
    """The scatter over maps of a mean over rows, beside what the blocks of each map say."""
    means, errors, naive = [], [], []
    for seed in range(100):
        rows = rows_of_a_map(seed)
        each = np.mean(np.diff(rows, axis=1) ** 2, axis=1) ** 0.5
        taken, block = line_correlation(rows).whole_blocks(len(rows), every=False)
        blocks = each[:taken].reshape(-1, block).mean(axis=1)
        means.append(each.mean())
        errors.append(blocks.std(ddof=1) / np.sqrt(len(blocks)))
        naive.append(each.std(ddof=1) / np.sqrt(len(each)))
    assert np.sqrt(np.mean(np.square(errors))) == pytest.approx(np.std(means), rel=0.5)
    assert np.std(means) > 2.0 * np.sqrt(np.mean(np.square(naive)))


@pytest.mark.parametrize("hurst", [0.2, 0.8, 1.0])
@pytest.mark.parametrize("lines", [2, 5, 40])
def test_independent_lines_are_not_alike(hurst, lines):
    modes = amplitudes(hurst, 128, "modal")
    for seed in range(20):
        rng = np.random.default_rng(seed)
        drawn = [sample_line(modes, draw_phases(rng, 128), 128, 1)[0] for _ in range(lines)]
        assert line_correlation(level(np.array(drawn)[:, :64], "line")) is None


@pytest.mark.parametrize(
    ("lines", "every", "taken", "block"),
    [
        (128, False, 128, 16),
        (101, False, 100, 20),
        (126, True, 126, 18),
        (20, False, 20, 5),  # four blocks, shorter than they should be
        (6, False, 6, 3),
        (7, True, 7, 1),  # nothing else divides it
    ],
)
def test_blocks_hold_what_is_alike(lines, every, taken, block):
    assert LineCorrelation(0.95, 11.0).whole_blocks(lines, every) == (taken, block)


def test_one_line_alone_is_never_alike():
    assert line_correlation(rows_of_a_map(1)[:1]) is None
