"""Sweeps at several temperatures are told apart by what the file or the user says of them."""

import numpy as np
import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.study.moduli import read_moduli

HEADER = "f (Hz), G' (MPa), G'' (MPa)"
COLD = "0.1, 2, 0.5\n1, 3, 0.6\n10, 4, 0.7\n"
WARM = "0.1, 1, 0.1\n1, 1.5, 0.2\n10, 2, 0.3\n"


def read(tmp_path, text, *given):
    path = tmp_path / "sweeps.csv"
    path.write_text(text, encoding="utf-8")
    columns = (1, 2, 3) if text.startswith("°C") else None
    return read_moduli(path, columns=columns, temperatures=given)


def with_column(*temperatures):
    """Return the rows of both sweeps with a temperature in front of each."""
    rows = zip(temperatures, (COLD + WARM).splitlines(), strict=True)
    return "".join(f"{t}, {row}\n" for t, row in rows)


@pytest.mark.parametrize(
    ("text", "given"),
    [
        (f"{HEADER}\n{COLD}{WARM}", (5.0, 40.0)),
        (f"{HEADER}\n{COLD}\n{WARM}", (5.0, 40.0)),
        (f"T (°C), {HEADER}\n{with_column(5, 5, 5, 40, 40, 40)}", ()),
        (f"T (°C), {HEADER}\n{with_column(4.9, 5.1, 5, 40.2, 39.8, 40)}", ()),
        (f"Temperature [K], {HEADER}\n{with_column(*[278.15] * 3, *[313.15] * 3)}", ()),
        (f"°C, Hz, MPa, MPa\n{with_column(5, 5, 5, 40, 40, 40)}", ()),
        (f"Temp. = 5 °C\n{HEADER}\n{COLD}\nTemp. = 40 °C\n{HEADER}\n{WARM}", ()),
        (f"sweep at 278.15 K\n{HEADER}\n{COLD}sweep at 313.15 K\n{HEADER}\n{WARM}", ()),
    ],
)
def test_each_row_has_the_temperature_of_its_sweep(tmp_path, text, given):
    found = read(tmp_path, text, *given)
    assert found.temperatures is not None
    np.testing.assert_allclose(found.temperatures, [5, 40, 5, 40, 5, 40])
    np.testing.assert_allclose(found.values.real / 1e6, [2, 1, 3, 1.5, 4, 2])
    assert any("temperatures" in line for line in found.told)


def test_a_row_without_a_temperature_is_left_out(tmp_path):
    found = read(tmp_path, f"T (°C), {HEADER}\n{with_column(5, 5, '-', 40, 40, 40)}")
    assert found.omega.size == 5


def test_a_column_of_one_temperature_is_one_sweep(tmp_path):
    rows = [f"{t}, {w}, 1, 1\n" for w, t in enumerate((20, 20.5, 21, 20), 1)]
    text = f"T (°C), {HEADER}\n" + "".join(rows)
    assert read(tmp_path, text).temperatures is None


@pytest.mark.parametrize(
    ("text", "given", "answer"),
    [
        (f"{HEADER}\n{COLD}{WARM}", (), "several moduli, |G*| from 1e+06 to 2.06e+06 Pa, as at"),
        (f"{HEADER}\n{COLD}{WARM}", (5, 20, 40), "3 are given, but"),
        (f"T (°C), {HEADER}\n{with_column(5, 6, 7, 8, 9, 10)}", (), "a ramp is no sweep; give"),
        (
            f"Temp. set (°C), Temp. (°C), {HEADER}\n" + "1, 2, 3, 4, 5\n" * 4,
            (),
            "not clear which holds a temperature",
        ),
    ],
)
def test_what_tells_them_not_apart_is_refused(tmp_path, text, given, answer):
    with pytest.raises(UserError) as error:
        read(tmp_path, text, *given)
    assert answer in str(error.value)
    assert "--temperatures" in str(error.value)
