"""Measured lines in m: levelling, periods, uniform steps, units and gaps."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.study.surfaces.positions import precision, rounding, uniform_step
from elastomer_friction.workflow.study.surfaces.profile import (
    DETRENDS,
    PERIODICS,
    check_not_flat,
    level,
    make_periodic,
    spikes,
)
from elastomer_friction.workflow.study.surfaces.raw_lines import LineFile, RawLines, lines_of

RNG = np.random.default_rng(8)
LINES = RNG.normal(size=(3, 40)).cumsum(axis=1)
SEEDS = st.integers(0, 2**32 - 1)


def step_of(x, known=0.0):
    x = np.asarray(x, dtype=float)
    return uniform_step("surface.file = 'f'", x, known)


@pytest.mark.parametrize("detrend", ["mean", "line", "parabola"])
def test_levelling_removes_its_polynomial_and_nothing_else(detrend):
    t = np.arange(40.0)
    trend = np.polynomial.polynomial.polyval(t, [7.0, -0.3, 0.02][: DETRENDS[detrend] + 1])
    levelled = level(LINES + trend, detrend)
    np.testing.assert_allclose(levelled, level(LINES, detrend), atol=1e-12)
    np.testing.assert_allclose(level(levelled, detrend), levelled, atol=1e-12)
    fitted = np.polynomial.polynomial.polyfit(t, LINES.T, DETRENDS[detrend])
    expected = LINES - np.polynomial.polynomial.polyval(t, fitted)
    np.testing.assert_allclose(level(LINES, detrend), expected, atol=1e-11)


def test_heights_may_be_taken_as_they_are():
    assert level(LINES, "none") is LINES
    assert make_periodic(LINES, "none") is LINES


@given(SEEDS, st.integers(8, 50))
def test_a_mirrored_line_is_even_and_has_the_heights_twice(seed, samples):
    line = np.random.default_rng(seed).normal(size=(2, samples))
    mirrored = make_periodic(line, "mirror")
    np.testing.assert_array_equal(mirrored, mirrored[:, ::-1])
    np.testing.assert_array_equal(mirrored[:, :samples], line)
    # Steps across the ends of the period are none, wherever the line ends.
    ring = np.diff(mirrored, axis=1, append=mirrored[:, :1])
    assert not ring[:, [samples - 1, -1]].any()
    assert mirrored.shape[1] == PERIODICS["mirror"] * samples


def test_a_tapered_line_meets_its_own_start_and_keeps_its_middle():
    lines = LINES + 5.0
    tapered = make_periodic(lines, "taper")
    np.testing.assert_allclose(tapered[:, 4:-4], lines[:, 4:-4], rtol=1e-13)
    ends = tapered[:, [0, -1]] - lines.mean(axis=1, keepdims=True)
    assert np.abs(ends).max() < 0.05 * np.abs(LINES).max()
    np.testing.assert_allclose(make_periodic(LINES + 9.0, "taper"), tapered + 4.0)


@given(st.floats(0.01, 10.0), st.integers(8, 300), st.floats(-5.0, 5.0))
def test_rounded_positions_have_the_step_they_were_made_of(step, samples, start):
    """Positions to 0.1, whatever part of a step that is, if they show that they are rounded."""
    exact = start + step * np.arange(samples)
    rounded = np.round(exact, 1)
    other = np.abs(np.diff(rounded) - np.median(np.diff(rounded))) > 0.05
    if step * samples > 2.0 and np.count_nonzero(other) >= max(2.0, 0.01 * samples):
        assert step_of(rounded, 0.1) == pytest.approx(step, abs=0.3 / samples)
    assert step_of(exact, 0.0) == pytest.approx(step, rel=1e-12)


def test_descending_positions_have_a_negative_step():
    assert step_of(np.arange(20.0)[::-1]) == -1.0


def gap(samples=200, at=77):
    return np.delete(np.arange(samples + 1.0), at)


@pytest.mark.parametrize(
    ("x", "known", "words"),
    [
        (gap(), 0.0, "sample 78 is 2 after the one before"),
        (gap(), 1.0, "sample 78 is 2 after the one before"),  # a gap, not rounding to 1
        (np.arange(20.0) ** 2, 0.5, "sample 2 is 1 after the one before"),
        (np.zeros(9), 1.0, "sample 2 is 0 after the one before, in the mean steps are 0"),
        (np.r_[np.arange(50.0), np.arange(50.0)], 0.0, "sample 51 is -49 after the one before"),
        (np.arange(60.0) + 0.4 * (np.arange(60) % 2), 0.1, "in the mean steps are 1"),
    ],
)
def test_positions_that_are_not_uniform_are_refused(x, known, words):
    with pytest.raises(UserError, match="bring the samples to equal steps first") as error:
        step_of(x, known)
    assert words in str(error.value)


def test_spikes_are_counted():
    """White noise has none at this threshold; each of three lifted samples is one."""
    noise = np.random.default_rng(4).normal(size=(2, 500))
    assert spikes(noise) == 0
    noise[0, [100, 300]] += 40.0
    noise[1, 250] -= 40.0
    lifted = spikes(noise)
    assert 3 <= lifted <= 9  # neighbours of a spike stand out as well
    assert spikes(np.repeat(noise, 4, axis=1)) == 0  # plateaus: nothing can be said


@pytest.mark.parametrize("detrend", ["mean", "line", "parabola"])
def test_flat_lines_are_refused(detrend):
    raw = np.vstack([LINES[0], 3.0 + 0.0 * LINES[0]])
    with pytest.raises(UserError, match=r"surface.file = 'f': line 2 of 2 is flat"):
        check_not_flat("surface.file = 'f'", level(raw, detrend), raw)
    check_not_flat("surface.file = 'f'", level(raw[:1], detrend), raw[:1])
    slope = 1e-3 * np.arange(1000.0)[None, :]  # of which levelling leaves rounding
    with pytest.raises(UserError, match="line 1 of 1 is flat"):
        check_not_flat("surface.file = 'f'", level(slope, "line"), slope)


@given(st.lists(st.floats(-1e6, 1e6), min_size=2, max_size=30), st.sampled_from([".2f", ".4g"]))
def test_numbers_are_within_half_their_precision(numbers, form):
    written = [format(number, form) for number in numbers]
    off = np.abs(np.array(numbers) - np.array(written, dtype=float))
    assert np.all(off <= 0.5 * precision(written) * (1.0 + 1e-9) + 1e-300)


def test_precision_counts_zeros_that_were_left_out():
    np.testing.assert_allclose(precision(["0", "0.2", "3", "1499.8"]), 0.1)
    np.testing.assert_allclose(precision(["1.25e-3", "1.25", "12500"]), [1e-5, 1e-4, 1.0])


X = np.arange(10.0)
Z = np.random.default_rng(2).normal(size=(2, 10))
OWN = ("mm", "um")


def lines(x=X, z=Z, own=OWN, units=(), known=0.0, **how):
    raw = RawLines(np.asarray(z), own, "", np.asarray(x), known)
    return lines_of(LineFile(Path("f"), "f", (), units, **how), raw)


def test_lines_are_in_metres():
    found = lines()
    np.testing.assert_array_equal(found.heights, Z * 1e-6)
    assert found.step == 1e-3
    assert found.size == "2 lines of 10 samples, 0.001 m apart in the mean"
    assert found.notes.startswith("heights in um")


def test_every_line_has_its_unit():
    np.testing.assert_array_equal(lines(own=("mm", "um", "nm")).heights[1], Z[1] * 1e-9)


def test_descending_positions_turn_the_line_round():
    found = lines(x=X[::-1])
    np.testing.assert_array_equal(found.heights, lines().heights[:, ::-1])
    assert found.step == 1e-3


def gappy(at=((1, 4), (1, 5))):
    z = Z.copy()
    for place in at:
        z[place] = np.nan
    return z


def test_gaps_are_filled_in_by_straight_lines():
    found = lines(z=gappy(((0, 0), (1, 4), (1, 5))), gaps="fill")
    expected = Z * 1e-6
    expected[0, 0] = expected[0, 1]
    expected[1, 4:6] = expected[1, 3] + np.array([1, 2]) / 3 * (expected[1, 6] - expected[1, 3])
    np.testing.assert_allclose(found.heights, expected)
    assert "3 of 20 samples were missing in 2 of 2 lines and were filled in" in found.notes
    with pytest.raises(UserError, match="line 1 of 2 holds 4 of 10 samples, too few to fill in"):
        lines(z=gappy([(0, i) for i in range(6)]), gaps="fill")


def test_spikes_are_replaced_with_their_neighbours_in_the_units_of_a_file():
    """ISO 13473-1: both samples of a pair with a slope of 3 or more; the step is 1000 um."""
    z = gappy(((1, 4),))
    z[0, 6], z[1, 5] = 4000.0, -4000.0  # um; the second beside a gap
    kept = lines(z=z[:1])
    assert kept.heights.max() == 4e-3
    line = lines(z=z, gaps="fill", spikes="fill").heights
    expected = 1e-6 * gappy([(0, 5), (0, 6), (0, 7), (1, 4), (1, 5), (1, 6)])
    for row in expected:
        missing = np.isnan(row)
        row[missing] = np.interp(X[missing], X[~missing], row[~missing])
    np.testing.assert_allclose(line, expected)
    with pytest.raises(UserError, match="gaps would be filled in from 1 of them, as sample 6 of"):
        lines(z=z, gaps="fill")
    assert lines(z=z, gaps="fill", spikes="keep").heights.min() == -4e-3


def test_lines_with_gaps_are_dropped():
    found = lines(z=gappy(), gaps="drop", own=("mm", "um", "um"))
    np.testing.assert_allclose(found.heights, Z[:1] * 1e-6)
    assert "in 1 of 2 lines, which were left out" in found.notes
    with pytest.raises(UserError, match='"drop" leaves no line; "fill" fills'):
        lines(z=gappy(((0, 1), (1, 4))), gaps="drop")


@pytest.mark.parametrize("code", [-9999.0, -32768.0])
def test_codes_for_missing_samples_are_gaps(code):
    z = Z.copy()
    z[0, [2, 7]] = code
    with pytest.raises(UserError, match=rf"2 of 20 samples \(2 of {code:g}, .* times the spread"):
        lines(z=z)
    np.testing.assert_allclose(
        lines(z=z, gaps="fill").heights, lines(z=gappy(((0, 2), (0, 7))), gaps="fill").heights
    )


@pytest.mark.parametrize("kind", [np.float32, np.float64, np.int16])
def test_positions_in_any_type_of_number_are_uniform(kind):
    x = (1000 + X if kind == np.int16 else (1.0 + X / 3e3)).astype(kind)
    assert lines(x=x.astype(float), known=rounding(x)).step > 0.0
