"""Tables of positions and heights become lines in m."""

from pathlib import Path

import numpy as np
import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.study.surfaces.as_read import Asked, Raw, lines_of
from elastomer_friction.workflow.study.surfaces.positions import rounding

X = np.arange(10.0)
Z = np.random.default_rng(2).normal(size=(2, 10))
OWN = ("mm", "um")


def lines(x=X, z=Z, own=OWN, units=(), known=0.0, gaps="refuse"):
    raw = Raw(np.asarray(z), np.asarray(x), np.full(np.shape(x), known), None, own)
    return lines_of(Asked(Path("f"), "f", (), units, gaps=gaps), raw)


def test_lines_are_in_metres():
    found = lines()
    np.testing.assert_array_equal(found.heights, Z * 1e-6)
    assert found.step == 1e-3
    assert "f: 2 lines of 10 samples, 0.001 m apart in the mean, heights in um" in found.notes


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
