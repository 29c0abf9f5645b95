"""Text tables of instruments and people: rows, titles, units, and which column is what."""

import math
import tracemalloc

import numpy as np
import pytest

from elastomer_friction.workflow.ground import UserError, decoded
from elastomer_friction.workflow.study import (
    ColumnSpec,
    describe_columns,
    find_column,
    select_columns,
)
from elastomer_friction.workflow.study.surfaces.remarks import remarks_of
from elastomer_friction.workflow.text_tables import TextTable, read_text_table

RNG = np.random.default_rng(7)


def table(text):
    return TextTable("key", "f.txt", decoded(text.encode()))


def columns(text):
    found = table(text)
    return [found.values(n).tolist() for n in found.numeric]


@pytest.mark.parametrize(
    "text",
    [
        "0.5,1.5\n2,-3e-1\n",
        "0.5 1.5\n\n2 -3e-1",
        "0.5\t1.5\r\n2\t-0.3\r\n",
        "0,5;1,5\n2;-0,3\n",
        "0,5\t1,5\n2\t-0,3\n",
        "0,5 1,5\n2 -0,3\n",
        "0.5 1.5\n2 \u22120.3\n",
        '"0,5","1,5"\n"2","-0,3"\n',
        "# a comment\n0.5, 1.5,,\n% another\n  // and one\n2.0,-0.3,,\n! the last\n",
        "Scan\r\r\nID,0\r\r\n\r\r\nx,z\r\r\n0.5,1.5,,\r\n2,-0.3,,\r\n",
        "\ufeff0.5,1.5\n2,-0.3\n",
        "# all in SI\ntime, velocity\n0.5, 1.5  # here\n2, -0.3\n",
        "point\tone\ntwo words\t0.5\t1.5\nand two\t2\t-0.3\n",
        "0.5 1.5\n2 -0.3\nend of file\n",
    ],
)
def test_rows_however_they_are_written(text):
    assert columns(text) == [[0.5, 2.0], [1.5, -0.3]]


def test_one_column_with_decimal_commas():
    assert columns("0,05\n1,5\n") == [[0.05, 1.5]]
    assert columns("0,5\n1,5\n") == [[0.0, 1.0], [5.0, 5.0]]  # nothing shows that it is one


@pytest.mark.parametrize("cell", ["", "nan", "N/A", "--", "#N/A", "inf"])
def test_missing_values_are_nan(cell):
    first, second = columns(f"x,z\n0,1\n1,{cell}\n2,3\n")
    assert first == [0.0, 1.0, 2.0]
    assert math.isnan(second[1])


@pytest.mark.parametrize("text", ["0 1\n2 3\n4", "0 1\n2 3\n4 5 6"])
def test_a_row_of_another_length_is_named(text):
    with pytest.raises(UserError, match=r"^key = 'f\.txt': line 3 reads '4.*must hold 2 cells"):
        table(text)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ('1,2\n"{}",3\n', "line 2 reads .* must hold a number in column 0"),
        ('"x{}",z\n1,2\n2,3\n3,4\n', "holds 200.* characters in a line without numbers"),
    ],
)
def test_a_cell_in_quotes_of_200_000_characters_is_refused(text, words):
    with pytest.raises(UserError, match=rf"^key = 'f\.txt': {words}"):
        columns(text.format("5" * 200_000))


def test_more_titles_than_cells_name_the_first_ones():
    """Instruments append titles of quantities that they did not measure."""
    rows = "".join(f"  {n}.5   {n + 3}   7\n" for n in range(1, 5))
    found = table(f"T=3;chem=PI;\nFreq\tG'\tG\"\th*\nrad/s\tkPa\tPa\tPa-s\n{rows}")
    chosen = select_columns(found, (OMEGA, STORAGE))
    assert [one.values[0] for one in chosen] == [1.5, 4e3]
    assert "the first 3 of 4 titles" in describe_columns(found, chosen)


def test_a_word_is_refused_in_a_column_that_is_read():
    found = table("0 1 5\n2 x 6\n3 1 7")
    assert found.values(2).tolist() == [5.0, 6.0, 7.0]
    with pytest.raises(UserError, match=r"'f\.txt': line 2 reads '2 x 6': .* in column 1"):
        found.values(1)


@pytest.mark.parametrize(
    ("text", "units"),
    [
        ("Lateral um,Raw Micrometer,\n0,1\n1,2\n", ["um", "Micrometer"]),
        ("# x [um] z [nm]\n0 1\n1 2\n", ["um", "nm"]),
        ("x,z\num,nm\n0,1\n1,2\n", ["um", "nm"]),
        ("units: um, nm\n0 1\n1 2\n", ["um", "nm"]),
        ("x (mm),height\n0,1\n1,2\n", ["mm", ""]),
        ("x / mm; z / µm\n0;1\n1;2\n", ["mm", "µm"]),
        ("x in mm, z in µm\n0,1\n1,2\n", ["mm", "µm"]),
        ("x_mm,z_um\n0,1\n1,2\n", ["mm", "um"]),
        ("time_s velocity_mm_s\n0 1\n1 2\n", ["s", "mm/s"]),
        ("t / s\tv / mm·s⁻¹\n0\t1\n1\t2\n", ["s", "mm·s⁻¹"]),
        ("Lateral position [um] Raw height [nm]\n0 1\n1 2\n", ["um", "nm"]),
        ("position/mm;height_um\n0;1\n1;2\n", ["mm", "um"]),
        ("Slide velocity mm/s,x. 10^-6 m\n0,1\n1,2\n", ["mm/s", "10^-6 m"]),
        ("v - mm per s\ttime-ms\n0\t1\n1\t2\n", ["mm per s", "ms"]),
        ("mm;um\nx;z\n0;1\n1;2\n", ["mm", "um"]),
        ("# mu\tt\n#%\tms\n0\t1\n1\t2\n", ["%", "ms"]),
        ("mu\tt\n%\tms\n1\t2\n3\t4\n", ["%", "ms"]),  # which is no comment
        ("velocity time friction\nmV s 1\n0 1 2\n1 2 3\n", ["mV", "s", "1"]),
        ("Torque mN m,t s\n0,1\n1,2\n", ["mN m", "s"]),
        ("% % | ms\n% mu | t\n0 | 1\n1 | 2\n", ["%", "ms"]),
        ("# units: counts, um\n0 1\n1 2\n", ["counts", "um"]),
        ('# x, z\n"um", "nm"\n0, 1\n1, 2\n', ["um", "nm"]),
        ("G(t) counts Elapsed time us\n1 2\n2 3\n", []),
        ("% log aT,T\n% ,[K]\n0,1\n1,2\n", ["", "K"]),
        ("f(x) {Hz} storage {Pa} n loss {Pa}\n1 9 2 3\n2 9 3 4\n", ["Hz", "Pa", "", "Pa"]),
        ("E(t) [Pa],t [s]\n0,1\n1,2\n", ["Pa", "s"]),
    ],
)
def test_units_of_columns(text, units):
    assert [title.unit for title in table(text).titles] == units


@pytest.mark.parametrize(
    "header",
    [
        "Cutoff 0.8 mm, stylus 2 µm",
        "Start 02:10 PM, end 02:12 PM",
        "far, um, nm\n\n1\n2\n3\n4",
        "T = 25 K; L = 3 mm",
        "",
    ],
)
def test_units_of_other_things_are_not_those_of_columns(header):
    assert not any(title.unit for title in table(f"{header}\n0 1\n1 2\n2 3\n").titles)


def test_remarks_blocks_and_what_is_passed_over():
    rows = "1 2\n2 3\n3 4\n"
    found = table(f"pitch = 0.5 um\n# Width: 96 µm\n\n{rows}\nT = 40 °C\n{rows}")
    assert remarks_of(found) == {"pitch": "0.5 um", "width": "96 µm"}
    assert [(block.start, block.stop) for block in found.blocks] == [(0, 3), (3, 6)]
    assert found.gaps[3] == ("", "T = 40 °C")
    assert found.passed_over == ("T = 40 °C",)
    assert len(table("1 2\n\n2 3\n\n3 4\n\n4 5\n").blocks) == 1  # every other line is empty


@pytest.mark.parametrize(
    ("text", "remarks"),
    [
        ("dx=0.5um, unit=nm\n1\n2\n3\n", {"dx": "0.5um", "unit": "nm"}),
        ("XY calibration;277;nm/pixel\n1;2;3;4;5\n2;3;4;5;6\n", {"xy calibration": "277 nm/pixel"}),
        ("Width (µm),20\nUnit,nm\n1,2,3,4,5\n2,3,4,5,6\n", {"width (µm)": "20", "unit": "nm"}),
        ("Missing value;99\n1 2 3 4 5\n2 3 4 5 6\n", {"missing value": "99"}),
    ],
)
def test_remarks_in_one_line_or_in_two_cells(text, remarks):
    found = table(text)
    assert remarks_of(found) == remarks
    assert not any(title.name for title in found.titles)


OMEGA = ColumnSpec("a frequency", "frequency", r"freq|omega|^f$", "rad/s", "--frequency")
STORAGE = ColumnSpec("a storage modulus", "pressure", r"stor|^[GE]'$", "Pa", "--modulus")
LOSS = ColumnSpec("a loss modulus", "pressure", r"loss|^[GE]''$", "Pa", "--modulus")
MODULI = (OMEGA, STORAGE, LOSS)


@pytest.mark.parametrize(
    ("text", "numbers", "factor"),
    [
        ("1 2 3\n2 3 4\n", [0, 1, 2], 1.0),
        ("freq_hz,G_storage_MPa,G_loss_MPa\n1,2,3\n2,3,4\n", [0, 1, 2], 1e6),
        ("G' (kPa),G'' (kPa),f (Hz)\n1,2,3\n2,3,4\n", [2, 0, 1], 1e3),
        ("#;T;f;G'';G'\n-;°C;Hz;Pa;kPa\n1;2;3;4;5\n2;3;4;5;6\n", [2, 4, 3], 1e3),
        ("G' (MPa),B (MPa),C (kHz)\n1,2,3\n2,3,4\n", [2, 0, 1], 1e6),
        ("G'';f (osc);G'\n[kPa];Hz;[kPa]\n3;1;2\n4;2;3\n", [1, 2, 0], 1e3),
        ("##\tG''\tf\tG'\n#-\tkPa\tHz\tkPa\n1\t3\t1\t2\n2\t4\t2\t3\n", [2, 3, 1], 1e3),
        ("f.Hz|G'-MPa|G''; MPa\n1|2|3\n2|3|4\n", [0, 1, 2], 1e6),
        (
            "Interval and data points:\t1\t2\nInterval data:\tPoint\tf\tG'\tG''\n\t\t\t\t\n"
            "\t\t[Hz]\t[kPa]\t[kPa]\n\t1\t1\t2\t3\n\t2\t2\t3\t4\n",
            [2, 3, 4],
            1e3,
        ),
        ('"f" "G\'" "G\'\'"\n"Hz" "kPa" "kPa"\n"1" "2" "3"\n"2" "3" "4"\n', [0, 1, 2], 1e3),
    ],
)
def test_columns_by_names_by_units_and_by_their_order(text, numbers, factor):
    found = select_columns(table(text), MODULI)
    assert [one.number for one in found] == numbers
    np.testing.assert_allclose(found[1].values, table(text).values(numbers[1]) * factor)


def test_columns_and_units_that_are_given():
    text = "A (Hz),B (Pa),C (Pa),D (Pa)\n1,2,3,4\n2,3,4,5\n"
    wanted = (OMEGA, STORAGE._replace(unit="kPa"), LOSS)
    found = select_columns(table(text), wanted, (0, 3, 1))
    assert [one.unit_source for one in found] == ["of the file", "given", "of the file"]
    np.testing.assert_allclose(found[0].values, [2.0 * math.pi, 4.0 * math.pi])
    np.testing.assert_allclose(found[1].values, [4e3, 5e3])


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("1 2 3 4\n2 3 4 5\n", "not clear which holds a frequency and a storage .*give --columns"),
        (
            "f [Hz],G' [V],G'' [V]\n1,2,3\n2,3,4\n",
            "'V' of a storage modulus is not known; give --m",
        ),
        ("t [s],G' [Pa],G'' [Pa]\n1,2,3\n2,3,4\n", "in 's', not a unit of a frequency"),
        ("1 2 3 4\n2 3 4 5\n", "not clear which .*give --columns 0,1,2"),
        ("f [Hz],t [s],G' [s],G'' [Pa]\n1,2,3,4\n2,3,4,5\n", "not clear which"),
        ("f; Hz storage; MPa loss; MPa\n1 2 3\n2 3 4\n", "not clear"),
        ("f; Hz;storage; MPa;loss; MPa\n1;2;3\n2;3;4\n", "not clear"),
        ("f storage loss\nHz 10^6 Pa 10^6 Pa\n1 2 3\n2 3 4\n", "not clear"),
        ("f [1/s],G' [Pa],G'' [Pa]\n1,2,3\n2,3,4\n", "'1/s' may be Hz or rad/s; give --frequency"),
        ("freq,omega,G',G''\n1,2,3,4\n2,3,4,5\n", "not clear"),
        ("a b c\n1 2 3\n2 3 4\n", "columns 0 a, 1 b, 2 c, from 0: it is not clear"),
        ("omega,Verlust (MPa),Speicher (MPa)\n1,2,3\n2,3,4\n", "not clear"),
        ("Frequenz Hz Modul 1 MPa Modul 2 MPa\n1 2 3\n2 3 4\n", "not clear"),
        ("Kreisfrequenz elastischer Anteil Verlust\n1 2 3\n2 3 4\n", "not clear"),
        ("f\tG'\tG''\n[Hz]\t[Torr]\t[Torr]\n1\t2\t3\n2\t3\t4\n", "'Torr' .* is not known"),
        ("f [Hz],storage / Torr,loss / Torr\n1,2,3\n2,3,4\n", "not clear what 'Torr' says"),
        ("f storage loss\nHz mm s-1\n1 2 3\n2 3 4\n", "not clear"),
        ("f storage modulus loss\n# N mm-2\n1 2 3\n2 3 4\n", "not clear which"),
        ("# f in lsb storage in Pa loss in Pa\n1 2 3\n2 3 4\n", "not clear"),
        ("% storage f loss\n% s V \n1 2 3\n2 3 4\n", "not clear what '. s V' says"),
        ("f,storage foo,loss\n1,2,3\n2,3,4\n", "not clear what 'foo' says"),
        ("f,storage. counts,loss\n1,2,3\n2,3,4\n", "not clear what 'counts' says"),
        ("f,storage.digits,loss\n1,2,3\n2,3,4\n", "not clear what 'digits' says"),
        ("f,storage_V,loss\n1,2,3\n2,3,4\n", "not clear what 'V' says"),
        ("f,storage s,loss s\n1,2,3\n2,3,4\n", "not clear what 's' says"),
        ("# storage loss and a frequency\n1 2 3\n2 3 4\n", "not clear which"),
        ("f [Hz],storage mod,loss mod\n1,2,3\n2,3,4\n", "not clear what 'mod' says"),
        ("f [Hz],kPa storage,kPa loss\n1,2,3\n2,3,4\n", "not clear what 'kPa' says"),
        ("moduli in MPa\nf G' G''\n1 2 3\n2 3 4\n", "what 'moduli in MPa' says of its unit"),
        ("f [Hz],log storage,log loss\n1,2,3\n2,3,4\n", "logarithms, not a storage modulus"),
        ("velocities in um/s" + 9 * "\n#" + "\nf G' G''\n1 2 3\n2 3 4\n", "what 'velocities in"),
        ("f,G',G'' in K\n1,2,3,4,5\n2,3,4,5,6\n", "5 columns without names, from 0: it is not"),
        ("nu [1/s],G' [Pa],G'' [Pa]\n1,2,3\n2,3,4\n", "'1/s' may be Hz or rad/s"),
        ("f, Hz storage, MPa loss\n1 2 3\n2 3 4\n", "not clear which"),
    ],
)
def test_what_the_file_does_not_say_is_refused(text, words):
    with pytest.raises(UserError, match=rf"^key.*{words}"):
        select_columns(table(text), MODULI)


def test_columns_that_are_not_there():
    with pytest.raises(UserError, match=r"--columns asks for column 7 of 'f\.txt': it holds 3 col"):
        select_columns(table("1 2 3\n2 3 4\n"), MODULI, (0, 1, 7))


def test_a_column_that_may_be_missing():
    phase = ColumnSpec("tan delta", "number", "tan", "1")
    assert find_column(table("f,G'\n1,2\n2,3\n"), phase) is None
    found = find_column(table("f,G',tan delta (-)\n1,2,0.5\n2,3,0.6\n"), phase)
    assert found is not None
    assert found.values.tolist() == [0.5, 0.6]


def test_what_was_read_is_one_line():
    found = table("f (Hz),G' (MPa),G''\n1,2,3\n2,nan,4\n")
    assert describe_columns(found, select_columns(found, MODULI)) == (
        "f.txt: 2 rows; column 0 f as a frequency in Hz, column 1 G' as a storage modulus in MPa, "
        "column 2 G'' as a loss modulus in Pa (assumed); 1 value missing"
    )


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"PK\x03\x04 no more", "is a zip archive: unpack it and name one file"),
        (b"\x89HDF\r\n\x1a\n no more", "it is not text"),
        (b"words alone", "holds no row of numbers"),
        (b"\xff\xfe\x00", "holds no row of numbers"),
        (None, "cannot be read: No such file"),
    ],
)
def test_files_that_are_no_table(tmp_path, data, words):
    path = tmp_path / "f.txt"
    if data is not None:
        path.write_bytes(data)
    with pytest.raises(UserError, match=rf"^key = '.*f\.txt': .*{words}"):
        read_text_table("key", path)


@pytest.mark.parametrize(
    "encoding", ["utf-8", "utf-8-sig", "latin-1", "utf-16", "utf-16-le", "utf-16-be"]
)
def test_the_micro_sign_in_any_encoding(tmp_path, encoding):
    path = tmp_path / "f.txt"
    path.write_bytes("x (µm),z (µm)\n0,1\n1,2\n".encode(encoding))
    assert [title.unit for title in read_text_table("key", path).titles] == ["µm", "µm"]


@pytest.mark.parametrize("title", ["f [Hz],G' [kPa],G'' [MPa]", "f [Hz],G'' [MPa],G' [MPa]"])
def test_titles_between_rows_that_say_otherwise_are_refused(title):
    first = "f [Hz],G' [MPa],G'' [MPa]"
    rows = "1,2,3\n2,3,4\n3,4,5\n"
    assert len(table(f"{first}\n{rows}{first}\n{rows}").blocks) == 2
    with pytest.raises(UserError, match="above line 6 name other units or another order of colum"):
        table(f"{first}\n{rows}{title}\n{rows}")


@pytest.mark.parametrize("code", [-9999.0, 999.0, 1e30])
@pytest.mark.parametrize("usual", [[1.0, 1.0, 1.0, 1.0], [2.0, 3.0, 4.0, 5.0]])
def test_codes_for_missing_values_are_no_values(code, usual):
    rows = "".join(f"{n} {value} 1\n" for n, value in enumerate([*usual, code], 1))
    found = select_columns(table(f"f G' G''\n{rows}"), MODULI)
    assert np.isnan(found[1].values).tolist() == [False] * 4 + [True]
    assert f"1 value missing ({code:g})" in describe_columns(table(f"f G' G''\n{rows}"), found)


def test_a_number_that_is_far_from_all_others_but_no_code_counts():
    rows = "".join(f"{n} {value} 1\n" for n, value in enumerate([1, 1, 1, 1, 700, 700], 1))
    assert select_columns(table(f"f G' G''\n{rows}"), MODULI)[1].values[-1] == 700.0


@pytest.mark.parametrize(
    "stamp", ["2024-05-01 12:00:0{}", "1/5/2024 1:00:0{} PM", "01.05.24 9:0{}"]
)
def test_a_date_and_a_time_of_day_are_one_cell_of_words(stamp):
    rows = "".join(f"{stamp.format(n)},{n}.5,{n * n}\n" for n in range(9))
    found = table(f"Stamp,x (mm),z (um)\n{rows}")
    assert found.numeric == (1, 2)
    assert found.values(1).tolist() == [n + 0.5 for n in range(9)]


@pytest.mark.parametrize("name", ["Shear stress", "Spannung"])
def test_a_stress_is_no_modulus(name):
    rows = "0.1;3\n0.2;2\n0.4;1\n"
    wanted = (ColumnSpec("a time", "time", "^t$", "s"), MODULI[1])
    with pytest.raises(UserError, match=f"'{name}': holds a stress, not a .*: divide it by the st"):
        select_columns(table(f"t [s];{name} [MPa]\n{rows}"), wanted)
    assert (
        select_columns(table(f"t [s];{name} relaxation modulus [MPa]\n{rows}"), wanted)[1].number
        == 1
    )


def test_a_row_of_many_whole_numbers_with_a_missing_one_is_read_at_once():
    """Backtracking took a time that grew as 5 to the power of the number of columns."""
    row = ["54321"] * 64
    found = columns("\n".join(" ".join(cells) for cells in (row, [*row[:63], "NaN"], row)))
    assert math.isnan(found[63][1])
    assert [column[1] for column in found[:63]] == [54321.0] * 63


@pytest.mark.parametrize("end", ["\n", " # a remark\n"])
def test_a_long_table_takes_memory_in_proportion_to_its_text(end):
    """A line of text takes 49 bytes beside its characters."""
    text = "x [um];z [um]\n" + "".join(f"{n / 2} ; 0.25{end}" for n in range(30_000))
    tracemalloc.start()
    values = TextTable("key", "f.txt", text).values(0)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 9 * len(text)
    assert np.array_equal(values, np.arange(30_000) / 2)


def test_lines_end_as_in_python():
    ends = ("\n", "\r\n", "\r", "\v", "\f", "\x1c", "\x1d", "\x1e", "\x85", "\u2028", "\u2029")
    text = "".join(f"{n} 0.5{end}" for n, end in enumerate(ends * 3))
    assert list(table(text).lines) == list(range(1, 34))
    assert columns(text)[0] == list(range(33))
