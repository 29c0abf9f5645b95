"""Files of a laboratory: columns, units, and refusals that name file and line."""

import numpy as np
import pytest

from elastomer_friction.workflow.errors import UserError
from elastomer_friction.workflow.laboratory.record import read_record


def read(tmp_path, text, *arguments, **options):
    path = tmp_path / "r.txt"
    path.write_text(text, encoding="utf-8")
    return read_record(path, *arguments, **options)


def test_columns_and_units_of_the_header(tmp_path):
    text = "t (ms)\tload\tv [mm/s]\tmu\n0\t9\t100\t0.3\n10\t9\t120\t0.4\n"
    found = read(tmp_path, text, (0, 2, 3))
    np.testing.assert_allclose(found.time, [0.0, 0.01])
    np.testing.assert_allclose(found.velocity, [0.1, 0.12])
    assert found.friction.tolist() == [0.3, 0.4]
    assert (found.units, found.name) == (("ms", "mm/s"), "r.txt")


@pytest.mark.parametrize(
    ("header", "units"),
    [
        ("", ("s", "m/s")),
        ("Zeit [min]; v [µm/s]; a [m/s²]", ("min", "um/s")),
        ("t (s) v (m/s)", ("s", "m/s")),
    ],
)
def test_units_without_a_word(tmp_path, header, units):
    assert read(tmp_path, f"{header}\n0;0,1;1\n1;0,2;1\n").units == units


def test_options_go_before_the_header(tmp_path):
    found = read(tmp_path, "t (s) v (m/s)\n0 1 1\n2 1 1", time="min", velocity="um/s")
    assert (found.time[1], found.velocity[0]) == (120.0, pytest.approx(1e-6))


@pytest.mark.parametrize(
    ("text", "line", "answer"),
    [
        ("0 1 0.3\n1 1 x\n", "line 2 of '", "reads '1 1 x': must hold 3 finite numbers in columns"),
        ("# t\n0 1 0.3\n\n0 1 0.3\n", "line 4 of '", "time 0 does not come after 0; must increase"),
        ("0 1 0.3\n1 0 0.3\n", "line 2 of '", "holds the velocity 0; must be greater than zero"),
        ("mm/s um/s\n0 1 1\n", "", "names the units mm/s and um/s; choose by --velocity"),
        ("nothing\n", "", "holds no row of 3 numbers in columns [0, 1, 2]"),
    ],
    ids=["a word", "time", "velocity", "units", "no rows"],
)
def test_refusals_name_file_and_line(tmp_path, text, line, answer):
    with pytest.raises(UserError, match=r"^fit.*r\.txt") as error:
        read(tmp_path, text)
    assert line in str(error.value)
    assert answer in str(error.value)


def test_a_file_that_is_not_there(tmp_path):
    with pytest.raises(UserError, match=r"none\.txt': cannot be read: No such file"):
        read_record(tmp_path / "none.txt")
