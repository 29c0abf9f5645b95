"""Moduli over frequency as instruments write them come in right, or are refused with the way on."""

import re

import numpy as np
import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.study.moduli import read_moduli

ROWS = "1e-1 1.0 0.1\n1e1 3.0 0.5\n1e0 2.0 0.3\n1e2 4.0 0.2\n"
VALUES = np.array([1 + 0.1j, 2 + 0.3j, 3 + 0.5j, 4 + 0.2j])


def read(tmp_path, text, *units, **settings):
    path = tmp_path / "moduli.txt"
    path.write_text(text, encoding="utf-8")
    return read_moduli(path, *units, **settings)


def test_without_a_header_they_are_rad_per_second_and_pascal(tmp_path):
    found = read(tmp_path, ROWS)
    np.testing.assert_array_equal(found.omega, [0.1, 1.0, 10.0, 100.0])
    np.testing.assert_array_equal(found.values, VALUES)
    assert "in rad/s (assumed)" in found.description[0]
    assert found.description[0].count("in Pa (assumed)") == 2


@pytest.mark.parametrize(
    ("header", "frequency", "storage", "loss"),
    [
        ("# f (Hz)  G' (MPa)  G'' (MPa)", 2.0 * np.pi, 1e6, 1e6),
        ("omega [rad/s], G' [kPa], G'' [kPa]", 1.0, 1e3, 1e3),
        ("T=25;Mw=100\n\nf[Hz] G' G''", 2.0 * np.pi, 1.0, 1.0),
        ("Kreisfrequenz [1/s];Speichermodul [kPa];Verlustmodul [MPa]", 1.0, 1e3, 1e6),
        ("Hz MPa kPa", 2.0 * np.pi, 1e6, 1e3),
        ("f [Hz]  G' [MPa]  G''", 2.0 * np.pi, 1e6, 1e6),
        ("w  storage (psi)  loss (psi)", 1.0, 6894.757, 6894.757),
        ("freq_kHz G_storage_GPa G_loss_GPa", 2e3 * np.pi, 1e9, 1e9),
        ("preload 3 MPa, 5 Hz\nf (rad/s)  G′ (kPa)  G″ (kPa)", 1.0, 1e3, 1e3),
    ],
)
def test_units_of_the_header_column_by_column(tmp_path, header, frequency, storage, loss):
    found = read(tmp_path, f"{header}\n{ROWS}")
    assert found.omega[0] == pytest.approx(0.1 * frequency)
    expected = storage * VALUES.real + 1j * loss * VALUES.imag
    np.testing.assert_allclose(found.values, expected, rtol=1e-6)


def test_what_is_asked_for_goes_before_the_header(tmp_path):
    found = read(tmp_path, f"f (Hz)  G' (MPa)  G'' (kPa)\n{ROWS}", "rad/s", "GPa")
    np.testing.assert_allclose(found.values, 1e9 * VALUES)
    assert found.omega[0] == 0.1


def columns(*numbers):
    """Return columns in another order, and one of words before them."""
    rows = [row.split() for row in ROWS.splitlines()]
    return "\n".join(" ".join(["point", *(row[n] for n in numbers)]) for row in rows)


@pytest.mark.parametrize("header", ["no loss(Pa) freq(rad/s) storage(Pa)", "a A B C"])
def test_columns_by_their_names_or_as_they_are_given(tmp_path, header):
    given = None if "loss" in header else (2, 3, 1)
    found = read(tmp_path, f"{header}\n{columns(2, 0, 1)}\n", columns=given)
    np.testing.assert_array_equal(found.values, VALUES)


@pytest.mark.parametrize(
    "name", ["tan delta", "tan(delta)", "loss factor", "Verlustfaktor", "tanD", "damping"]
)
def test_a_loss_factor_is_the_ratio_of_the_moduli(tmp_path, name):
    rows = "".join(
        f"{w};{v.real};{v.imag / v.real}\n" for w, v in zip((0.1, 1, 10, 100), VALUES, strict=True)
    )
    found = read(tmp_path, f"f (Hz);storage modulus (MPa);{name}\n{rows}")
    np.testing.assert_allclose(found.values, 1e6 * VALUES)
    assert "G'' = G' tan delta" in found.description


@pytest.mark.parametrize("names", ["E' (MPa);E'' (MPa)", "Young storage (MPa);Young loss (MPa)"])
def test_young_s_moduli_are_divided_and_that_is_said(tmp_path, names):
    text = f"f (Hz);{names}\n{ROWS.replace(' ', ';')}"
    np.testing.assert_allclose(read(tmp_path, text).values, 1e6 * VALUES / 3.0)
    found = read(tmp_path, text, poisson=0.25)
    np.testing.assert_allclose(found.values, 1e6 * VALUES / 2.5)
    assert "divided by 2 (1 + nu) = 2.5" in found.description[1]


@pytest.mark.parametrize("first", ["Set 1,,Set 2,", "600,,1200,"])
def test_pairs_of_columns_of_several_tests_are_named(tmp_path, first):
    rows = "".join(f"{n},{9 - n},{n + 0.1},{9 - n}\n" for n in range(1, 6))
    with pytest.raises(UserError, match=r"holds 2 pairs of columns 'X', 'Y', .* --columns 0,1"):
        read(tmp_path, f"{first}\nX,Y,X,Y\n{rows}")
    assert read(tmp_path, f"{first}\nX,Y,X,Y\n{rows}", columns=(2, 3)).over_time


def test_rows_in_which_a_value_is_missing_are_passed_over_and_counted(tmp_path):
    found = read(tmp_path, ROWS + "1e3 5.0 nan\n")
    np.testing.assert_array_equal(found.values, VALUES)
    assert "1 value missing" in found.description[0]


STRAINED = "Strain (%);f (Hz);G' (Pa);G'' (Pa)\n0.1;1;9;3\n1;1;8;3\n10;1;5;2\n99;1;2;1\n"
SIDES = "".join(f"{row} {' '.join(row.split()[1:])}\n" for row in ROWS.splitlines())


@pytest.mark.parametrize(
    ("text", "answer"),
    [
        ("1 1 1\n2 1 1\n", "holds 2 rows; a fit needs 4"),
        (ROWS + "0 1 1\n", "line 5 holds 0 as a frequency; must be greater than zero"),
        (ROWS + "9 -1 1\n", "line 5 holds -1 as a storage modulus G'; must be greater than zero"),
        (ROWS + "9 1 -1\n", "line 5 holds -1 as a loss modulus G''; must not be negative"),
        ("1 2\n2 1\n3 1\n", "holds 3 rows; a fit needs 4"),
        ("f (Hz) G (Pa)\n1 2\n2 1\n3 1\n4 1\n", "is in 'Hz', not a unit of a time"),
        ("t (s) E (MPa)\n1 2\n2 0\n3 1\n4 1\n5 1\n", "line 3 holds 0 as a relaxation modulus"),
        (f"w G* (Pa) G'' (Pa)\n{ROWS}", "'G*' is not a storage modulus G': give G' ="),
        (f"f (Hz) G* (MPa) delta\n{ROWS}", "not clear which holds a frequency and"),
        (f"t (s) G' (MPa) G'' (MPa)\n{ROWS}", "is in 's', not a unit of a frequency"),
        (f"f (furlong) G' (MPa) G'' (MPa)\n{ROWS}", "'furlong' of a frequency is not known"),
        (ROWS + "1 2.5 0.3\n", "1 rad/s has several moduli, |G*| from 2.02 to 2.52 Pa"),
        (STRAINED, "column 0 'Strain' changes from 1 to 10 %: keep the rows of one strain"),
        (f"w G' G'' G' G''\n{SIDES}", "2 sweeps side by side: give --temperatures"),
        (f"w [Hz] G' [Pa] G'' [Pa] G' [kPa] G'' [kPa]\n{SIDES}", "give the columns of one"),
    ],
)
def test_what_is_no_material_or_unclear_is_refused(tmp_path, text, answer):
    with pytest.raises(UserError, match=r"^prony .*moduli\.txt") as error:
        read(tmp_path, text)
    assert answer in str(error.value)


RELAXING = "0.01 4\n0.1 3\n1 2\n10 1\n"


@pytest.mark.parametrize(
    ("text", "columns", "unit"),
    [
        (RELAXING, None, 1.0),
        (f"t (s), G(t) (kPa)\n{RELAXING.replace(' ', ', ')}", None, 1e3),
        (f"time [s]; E [MPa]\n{RELAXING.replace(' ', '; ')}", None, 1e6 / 3.0),
        (f"-1 9\n0 9\n{RELAXING}", None, 1.0),
        ("x t G\n" + "".join(f"7 {row}\n" for row in RELAXING.splitlines()), (1, 2), 1.0),
    ],
)
def test_a_relaxation_test_is_taken_over_the_inverse_time(tmp_path, text, columns, unit):
    found = read(tmp_path, text, columns=columns)
    assert found.over_time
    np.testing.assert_allclose(found.omega, [0.1, 1.0, 10.0, 100.0])
    np.testing.assert_allclose(found.values, unit * np.array([1.0, 2.0, 3.0, 4.0]))
    assert text[0] != "-" or "left out: 2 samples up to t = 0" in found.description


RINGING = "t (s);G (Pa)\n0.001;-3\n0.002;9\n0.003;-1\n0.01;4\n0.1;3\n1;2\n10;1\n"


def test_a_relaxation_test_begins_where_it_is_asked_to(tmp_path):
    found = read(tmp_path, RINGING, start=0.01)
    np.testing.assert_allclose(found.omega, [0.1, 1.0, 10.0, 100.0])
    assert "left out: 3 samples before 0.01 s" in found.description
    with pytest.raises(UserError, match=r"line 2 holds -3 .* give --from 0\.01, the first time"):
        read(tmp_path, RINGING)
    with pytest.raises(UserError, match=r"line 8 holds 0 .* leave out such samples if they are n"):
        read(tmp_path, RINGING.replace("10;1", "10;0"), start=0.01)
    with pytest.raises(UserError, match=r"--from 0\.01: is a time of a relaxation test"):
        read(tmp_path, ROWS, start=0.01)


def test_late_samples_are_close_in_time_and_scatter(tmp_path):
    found = read(tmp_path, "0.1 4\n1 2\n10 1\n100 0.4\n100.1 0.5\n")
    assert found.values.tolist() == [0.5, 0.4, 1.0, 2.0, 4.0]


def test_samples_at_equal_steps_of_time_are_averaged_by_parts_of_a_decade(tmp_path):
    time = np.arange(1, 5001) * 0.01
    rows = "".join(f"{t:.6g} {1e6 * t**-0.1:.9g}\n" for t in time)
    found = read(tmp_path, rows)
    assert 50 < found.omega.size < 100
    np.testing.assert_allclose(found.values, 1e6 * found.omega**0.1, rtol=1e-3)


def test_a_sweep_that_was_repeated_is_one_material(tmp_path):
    assert read(tmp_path, ROWS + ROWS.replace("2.0", "2.05")).omega.size == 8


@pytest.mark.parametrize(
    ("above", "factor", "words"),
    [
        ("Geometry: tension film", 3.0, "Young's moduli E divided by 2 .1 . nu. = 3"),
        ("mode\tdual cantilever bending", 3.0, "Young's"),
        ("Geometry: parallel plates; compression 5 %", 1.0, "taken as shear moduli G, as nothing"),
        ("sample 5", 1.0, "taken as shear moduli G"),
    ],
)
def test_the_way_of_loading_tells_moduli_without_a_letter(tmp_path, above, factor, words):
    header = "Frequency (rad/s),Storage modulus (Pa),Loss modulus (Pa)"
    found = read(tmp_path, f"{above}\n{header}\n1,3,6\n2,3,6\n4,3,6\n8,3,6\n")
    np.testing.assert_allclose(found.values, (3.0 + 6.0j) / factor)
    assert re.search(words, "\n".join(found.description))


HEADER = "f (Hz), G' (MPa), G'' (MPa)"
COLD = "0.1, 2, 0.5\n1, 3, 0.6\n10, 4, 0.7\n"
WARM = "0.1, 1, 0.1\n1, 1.5, 0.2\n10, 2, 0.3\n"


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
    columns = (1, 2, 3) if text.startswith("°C") else None
    found = read(tmp_path, text, temperatures=given, columns=columns)
    assert found.temperatures is not None
    np.testing.assert_allclose(found.temperatures, [5, 40, 5, 40, 5, 40])
    np.testing.assert_allclose(found.values.real / 1e6, [2, 1, 3, 1.5, 4, 2])
    assert any("temperatures" in line for line in found.description)


@pytest.mark.parametrize(
    ("head", "given"),
    [
        ("w,Gp,Gpp,Gp,Gpp", (5.0, 40.0)),
        (",5,,40,\nw,Gp,Gpp,Gp,Gpp", (5.0, 40.0)),
        (",5 °C,,40 °C,\nw,G',G'',G',G''\nrad/s,Pa,Pa,Pa,Pa", ()),
        ("T [°C],5,,40,\nw [rad/s],G' [Pa],G'' [Pa],G' [Pa],G'' [Pa]", ()),
        (",278.15 K,,313.15 K,\nw,G',tan delta,G',tan delta\nrad/s,Pa,,Pa,", ()),
    ],
)
def test_sweeps_side_by_side_are_those_below_one_another(tmp_path, head, given):
    ratio = "tan" in head
    rows = [
        ",".join(map(str, [w, *(n for v in (cold, 2.0 * cold) for n in parts(v, ratio))]))
        for w, cold in zip((0.1, 1.0, 10.0, 100.0), VALUES, strict=True)
    ]
    found = read(tmp_path, "\n".join([head, *rows, ",,,,", ""]), temperatures=given)
    np.testing.assert_allclose(found.temperatures, [5, 40] * 4)
    np.testing.assert_allclose(found.omega, np.repeat([0.1, 1.0, 10.0, 100.0], 2))
    np.testing.assert_allclose(found.values, np.stack([VALUES, 2.0 * VALUES], axis=1).ravel())


def parts(value, ratio):
    """Return G' and G'', or their ratio."""
    return value.real, value.imag / value.real if ratio else value.imag


def test_relaxation_tests_side_by_side_share_their_times(tmp_path):
    rows = "".join(f"{row},{2 * int(row[-1])}\n" for row in RELAXING.replace(" ", ",").split())
    found = read(tmp_path, f",5 °C,40 °C\nt [s],G [Pa],G [Pa]\n{rows}")
    assert found.over_time
    np.testing.assert_allclose(found.temperatures, [5, 40] * 4)
    np.testing.assert_allclose(found.values, [1, 2, 2, 4, 3, 6, 4, 8])


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
        (f"{HEADER}\n{COLD}{WARM}", (), "several moduli, |G*| from 1e+06 to 2.06e+06 Pa: keep"),
        (f"{HEADER}\n{COLD}{WARM}", (5, 20, 40), "3 are given, but"),
        (
            f"T (°C), {HEADER}\n{with_column(5, 6, 7, 8, 9, 10)}",
            (),
            "not separate sweeps but a ramp; give",
        ),
        (
            f"Temp. set (°C), Temp. (°C), {HEADER}\n" + "1, 2, 3, 4, 5\n" * 4,
            (),
            "not clear which holds a temperature",
        ),
    ],
)
def test_what_tells_them_not_apart_is_refused(tmp_path, text, given, answer):
    with pytest.raises(UserError) as error:
        read(tmp_path, text, temperatures=given)
    assert answer in str(error.value)
    assert "--temperatures" in str(error.value)
