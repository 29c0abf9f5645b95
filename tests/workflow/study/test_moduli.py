"""Measured moduli: units from the header or an option, frequencies in order, refusals."""

import math

import numpy as np
import pytest

from elastomer_friction.workflow.errors import UserError
from elastomer_friction.workflow.study.moduli import read_moduli

ROWS = "1e-1 1.0 0.1\n1e1 3.0 0.5\n1e0 2.0 0.3\n1e2 4.0 0.2\n"


def read(tmp_path, text, *units):
    path = tmp_path / "moduli.txt"
    path.write_text(text, encoding="utf-8")
    return read_moduli(path, *units)


def test_without_a_header_they_are_rad_per_second_and_pascal(tmp_path):
    found = read(tmp_path, ROWS)
    np.testing.assert_array_equal(found.omega, [0.1, 1.0, 10.0, 100.0])
    np.testing.assert_array_equal(found.values, [1 + 0.1j, 2 + 0.3j, 3 + 0.5j, 4 + 0.2j])
    assert found.units == ("rad/s", "Pa")


@pytest.mark.parametrize(
    ("header", "units"),
    [
        ("# f (Hz)  G' (MPa)  G'' (MPa)", ("Hz", "MPa")),
        ("omega [rad/s], G' [kPa], G'' [kPa]", ("rad/s", "kPa")),
        ("T=25;Mw=100\n\nf[Hz] G' G''", ("Hz", "Pa")),
        ("w G' G''", ("rad/s", "Pa")),
    ],
)
def test_units_of_the_header(tmp_path, header, units):
    found = read(tmp_path, f"{header}\n{ROWS}")
    assert found.units == units
    factor = 2.0 * math.pi if units[0] == "Hz" else 1.0
    assert found.omega[0] == pytest.approx(0.1 * factor)
    assert found.values[0] == (1 + 0.1j) * {"Pa": 1.0, "kPa": 1e3, "MPa": 1e6}[units[1]]


def test_what_is_asked_for_goes_before_the_header(tmp_path):
    found = read(tmp_path, f"f (Hz)  G' (MPa)  G'' (kPa)\n{ROWS}", "rad/s", "GPa")
    assert found.units == ("rad/s", "GPa")


@pytest.mark.parametrize(
    ("text", "answer"),
    [
        (f"Hz MPa kPa\n{ROWS}", "names the units MPa and kPa; choose by --modulus"),
        (f"Hz rad/s\n{ROWS}", "names the units Hz and rad/s; choose by --frequency"),
        ("1 1 1\n2 1 1\n", "holds 2 rows; a fit needs 4"),
        (ROWS + "0 1 1\n", "row 5 holds 0 as a frequency; must be greater than zero"),
        (ROWS + "9 -1 1\n", "row 5 holds -1 as a storage modulus G'; must be greater than zero"),
        (ROWS + "9 1 -1\n", "row 5 holds -1 as a loss modulus G''; must not be negative"),
    ],
)
def test_what_no_material_has_is_refused(tmp_path, text, answer):
    with pytest.raises(UserError, match=r"^prony .*moduli\.txt: ") as error:
        read(tmp_path, text)
    assert str(error.value).endswith(answer)
