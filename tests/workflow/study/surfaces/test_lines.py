"""Tables of positions and heights become lines in m."""

from pathlib import Path

import numpy as np
import pytest

from elastomer_friction.workflow.errors import UserError
from elastomer_friction.workflow.study.surfaces.files import Asked, lines_of, rounding

X = np.arange(10.0)
Z = np.random.default_rng(2).normal(size=(2, 10))
OWN = ("mm", "um")


def lines(x=X, z=Z, own=OWN, units=(), known=0.0):
    table = np.vstack([x, z])
    return lines_of(Asked(Path("f"), "f", (), units), table, np.full(table.shape[1], known), own)


def test_lines_are_in_metres():
    found = lines()
    np.testing.assert_array_equal(found.heights, Z * 1e-6)
    assert found.step == 1e-3
    assert "f: 2 lines of 10 samples, 1 mm apart in the mean, heights in um" in found.notes


def test_units_given_go_before_those_of_the_file():
    found = lines(units=("um", "nm"))
    np.testing.assert_array_equal(found.heights, Z * 1e-9)
    assert found.step == 1e-6
    assert "units as given" in found.notes


def test_every_line_has_its_unit():
    np.testing.assert_array_equal(lines(own=("mm", "um", "nm")).heights[1], Z[1] * 1e-9)


def test_descending_positions_turn_the_line_round():
    found = lines(x=X[::-1])
    np.testing.assert_array_equal(found.heights, lines().heights[:, ::-1])
    assert found.step == 1e-3


@pytest.mark.parametrize(
    ("own", "words"),
    [((), "'f' names none"), (("", ""), "'f' names none"), (("mm", "V"), "names ['mm', 'V']")],
)
def test_units_that_nobody_names_are_refused(own, words):
    with pytest.raises(UserError) as error:
        lines(own=own)
    assert str(error.value).startswith("surface.units: missing: ")
    assert words in str(error.value)


def test_gaps_are_refused():
    z = Z.copy()
    z[1, 4] = np.nan
    with pytest.raises(UserError, match=r"surface.file = 'f': line 2 of 2: sample 5 is nan"):
        lines(z=z)
    x = X.copy()
    x[0] = np.inf
    with pytest.raises(UserError, match=r"surface.file = 'f': positions: sample 1 is inf"):
        lines(x=x)


@pytest.mark.parametrize("kind", [np.float32, np.float64, np.int16])
def test_positions_in_any_type_of_number_are_uniform(kind):
    x = (1000 + X if kind == np.int16 else (1.0 + X / 3e3)).astype(kind)
    assert lines(x=x.astype(float), known=rounding(x)).step > 0.0
