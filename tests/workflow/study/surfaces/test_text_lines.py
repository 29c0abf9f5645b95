"""Lines in text files of every kind that people have: what is read, and what is refused."""

from pathlib import Path

import numpy as np
import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.study.surfaces.files import read_lines
from elastomer_friction.workflow.study.surfaces.profile import is_map, map_of_lines
from elastomer_friction.workflow.study.surfaces.raw_lines import LineFile

RESOURCES = Path(__file__).resolve().parents[3] / "resources"
X = 0.5 * np.arange(24)
Z = np.round(np.random.default_rng(9).normal(size=(12, 24)).cumsum(axis=1), 4)


def read(tmp_path, text, name="f.dat", **how):
    path = tmp_path / name
    path.write_text(text, encoding="utf-8")
    return read_lines(LineFile(path, name, **how))


def rows(*columns, separator=","):
    return "\n".join(separator.join(map(str, row)) for row in zip(*columns, strict=True)) + "\n"


def test_exponents_of_fortran(tmp_path):
    text = "x [um]\tz [nm]\n" + rows(X, Z[0], separator="D0\t").replace("\n", "D0\n")
    np.testing.assert_allclose(read(tmp_path, text).heights, Z[:1] * 1e-9)


@pytest.mark.parametrize("suffix", [".txt", ".CSV", ".dat", ".prn", ".asc", ".tsv", ".xyz", ""])
def test_suffixes_mean_nothing(tmp_path, suffix):
    lines = read(tmp_path, "x [um]\tz [nm]\n" + rows(X, Z[0], separator="\t"), f"f{suffix}")
    np.testing.assert_allclose(lines.heights, Z[:1] * 1e-9)
    assert lines.step == pytest.approx(0.5e-6)


@pytest.mark.parametrize(
    ("header", "columns"),
    [
        ("index,x in µm,z in µm", (range(24), X, Z[0])),
        ("No.,position (um),height (um)", (range(24), X, Z[0])),
        ("t (s),x (um),z (um)", (0.001 * np.arange(24), X, Z[0])),
        ("z (um),x (um)", (Z[0], X)),
        ("height (um),t (s),x (um)", (Z[0], X, X)),
        ("n;x;z\n;um;um", (range(24), X, Z[0])),
        ("x (um),z (um),friction (V)", (X, Z[0], Z[1])),
        ("x (in),z (in)", (X / 25400, Z[0] / 25400)),
        ("x (mil),z (mil)", (X / 25.4, Z[0] / 25.4)),
    ],
)
def test_columns_are_those_that_the_header_names(tmp_path, header, columns):
    separator = ";" if ";" in header else ","
    lines = read(tmp_path, f"{header}\n{rows(*columns, separator=separator)}")
    np.testing.assert_allclose(lines.heights, Z[:1] * 1e-6, rtol=1e-12)
    assert lines.step == pytest.approx(0.5e-6)


@pytest.mark.parametrize(
    "last", ["Pixel size [mm]: 0,5", "Step (mm)\t0,5", "# Width:12 mm", "Width,12 mm"]
)
@pytest.mark.parametrize("comment", ["", "// "])
def test_the_unit_of_a_remark_is_not_that_of_heights(tmp_path, last, comment):
    heights = "\n".join(map(str, Z[0])).replace(".", ",")
    found = read(tmp_path, f"{comment}Z unit: um\n{comment}{last}\n{heights}\n")
    np.testing.assert_allclose(found.heights, Z[:1] * 1e-6)
    assert found.step == pytest.approx(5e-4)


@pytest.mark.parametrize(
    "remark", ["NODATA_value = 0", "% NoData,0", "nodata;0", "Missing value: 0"]
)
def test_a_stated_code_is_no_height(tmp_path, remark):
    heights = np.where(np.arange(24) == 5, 0.0, Z + 9.0)
    text = f"{remark}\nstep = 1 um\nunit = um\n" + rows(*heights.T, separator="\t")
    with pytest.raises(UserError, match="12 of 288 samples are missing"):
        read(tmp_path, text)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("x [m]\tz [um]\n" + rows(X, Z[0], separator="\t"), "samples are 0.5 m apart: must be at"),
        ("0.5\t0.75\n", "1 samples per line: needs at least 8"),
        ("x;z\n" + rows(["nan", *X[1:]], Z[0], separator=";"), "position of sample 1 is missing"),
    ],
)
def test_implausible_lines_are_refused(tmp_path, text, words):
    with pytest.raises(UserError, match=words):
        read(tmp_path, text, units=("m", "um"))


def test_the_stylus_line_is_read_as_it_is():
    lines = read_lines(LineFile(RESOURCES / "stylus-line.csv", "stylus-line.csv"))
    assert lines.heights.shape == (1, 9600)
    assert lines.step == pytest.approx(0.15625e-6, rel=1e-4)  # of positions to 0.1 um
    np.testing.assert_allclose(lines.heights[0, [0, 1, -1]], [-9.33e-9, -7.6e-9, 1.658112e-5])


def map_of_points(order="rows"):
    x, y = np.meshgrid(X, np.arange(12.0))
    if order == "columns":
        x, y, z = x.T, y.T, Z.T
    else:
        z = Z
    return rows(x.ravel(), y.ravel(), z.ravel())


@pytest.mark.parametrize("header", ["x [um],y [um],z [um]\n", ""])
@pytest.mark.parametrize("order", ["rows", "columns"])
def test_points_of_a_map_become_lines_along_what_runs_first(tmp_path, order, header):
    units = () if header else ("um", "um")
    lines = read(tmp_path, header + map_of_points(order), units=units)
    expected = Z if order == "rows" else Z.T
    np.testing.assert_allclose(lines.heights, expected * 1e-6)
    assert lines.step == pytest.approx(0.5e-6 if order == "rows" else 1e-6)
    assert lines.row_spacing == pytest.approx(1e-6 if order == "rows" else 0.5e-6)
    assert "map of points" in lines.notes


def prepared_map(file, detrend="line", periodic="mirror"):
    return map_of_lines(file, read_lines(file), detrend, periodic)


def test_a_map_on_a_half_space_has_square_cells(tmp_path):
    path = tmp_path / "map.xyz"
    path.write_text("x [um],y [um],z [um]\n" + map_of_points(), encoding="utf-8")
    with pytest.raises(UserError, match="its rows are 1e-06 m apart and samples 5e-07 m: a half-s"):
        prepared_map(LineFile(path, path.name))
    np.save(tmp_path / "map.npy", Z.T)
    asked = LineFile(tmp_path / "map.npy", "map.npy", tuple(range(12)), ("um", "um"), 1e-6)
    found = prepared_map(asked)
    assert found.heights.shape == (1, 24, 24)
    assert "row distance assumed equal" in found.notes


@pytest.mark.parametrize("row", [0, 5, 11])
@pytest.mark.parametrize("detrend", ["none", "mean"])
def test_a_flat_row_is_part_of_a_map_and_a_flat_map_is_refused(tmp_path, row, detrend):
    heights = Z[:, :12].copy()
    heights[row] = heights.max()  # a plateau
    asked = LineFile(tmp_path / "map.npy", "map.npy", tuple(range(12)), ("um", "um"), 1e-6)
    np.save(asked.path, heights.T)
    found = prepared_map(asked, detrend, "none").heights[0]
    np.testing.assert_allclose(found - found.mean(), (heights - heights.mean()) * 1e-6, atol=1e-18)
    np.save(asked.path, np.full((12, 12), 3.0))
    with pytest.raises(UserError, match=r"surface.file = 'map.npy': is flat: needs heights that"):
        prepared_map(asked, detrend, "none")


def test_lines_of_a_map_run_along_the_column_that_is_asked_for(tmp_path):
    text = "x [um],y [um],z [um]\n" + map_of_points("columns")
    np.testing.assert_allclose(read(tmp_path, text, columns=(0, 2)).heights, Z * 1e-6)
    np.testing.assert_allclose(read(tmp_path, text, columns=(1, 2)).heights, Z.T * 1e-6)


def test_points_that_a_map_lacks_are_gaps(tmp_path):
    text = "x [um],y [um],z [um]\n" + "".join(map_of_points().splitlines(True)[:-2])
    with pytest.raises(UserError, match="2 of 288 samples are missing in 1 of 12 lines"):
        read(tmp_path, text)


def matrix(separator="\t"):
    return "\n".join(separator.join(map(str, row)) for row in Z) + "\n"


@pytest.mark.parametrize(
    "header",
    [
        "# Channel: Height\n# Width: 12 µm\n# Height: 6 µm\n# Value units: nm\n",
        "x-range [um]: 12\nz-unit: nm\n",
        "dx = 0.5 um\nunit = nm\n",
    ],
)
def test_a_matrix_of_heights(tmp_path, header):
    lines = read(tmp_path, header + matrix())
    np.testing.assert_allclose(lines.heights, Z * 1e-9)
    assert lines.step == pytest.approx(0.5e-6)
    assert lines.row_spacing == (pytest.approx(0.5e-6) if "Height:" in header else None)


@pytest.mark.parametrize(("rows", "answer"), [(12, True), (11, False)])
def test_a_strip_is_no_map(tmp_path, rows, answer):
    """Under a force: a square would omit more than half of the samples."""
    text = f"Width: 12 um\nHeight: {rows / 2} um\nunit = nm\n"
    lines = read(tmp_path, text + "".join(matrix().splitlines(True)[:rows]))
    assert lines.row_spacing == pytest.approx(lines.step)
    assert is_map(lines, loaded_by_force=True) == answer
    assert is_map(lines)


def test_a_matrix_without_a_step_says_how_to_give_it(tmp_path):
    with pytest.raises(UserError, match=r"a matrix of heights, .*: give surface\.step"):
        read(tmp_path, matrix())
    with pytest.raises(UserError, match=r"give surface\.step"):  # a width in samples is no length
        read(tmp_path, f"Width: 24\n{matrix()}", units=("um", "um"))
    lines = read(tmp_path, matrix(" "), step=1e-6, units=("um", "nm"))
    np.testing.assert_allclose(lines.heights, Z * 1e-9)


@pytest.mark.parametrize(
    ("shape", "header", "hint"),
    [((40, 48), "", True), ((40, 48), "# Height: 40 um\n", False), ((40, 96), "", False)],
)
def test_a_nearly_square_matrix_is_said_to_be_a_possible_map(tmp_path, shape, header, hint):
    heights = np.random.default_rng(3).normal(size=shape).round(3)
    text = header + "\n".join(" ".join(map(str, row)) for row in heights)
    lines = read(tmp_path, text, step=1e-6, units=("um", "nm"))
    assert ('scene.body = "half-space" reads them as a map' in lines.notes) == hint


@pytest.mark.parametrize(
    ("remark", "answer"),
    [
        ("dx\t0.5 um", 0.5e-6),
        ("# cellsize 0.0005", 0.5e-6),
        ("pixel size: 500 nm", 0.5e-6),
        ("sample_spacing_um: 0.5", 0.5e-6),
        ("XY-Justierung\t500\tnm/Pixel", 0.5e-6),
        ("Width: 12 µm", 0.5e-6),
        ("step = 0.5 um\nNODATA_value 0.1234", "1 of 288 samples are missing"),
        ("Mult 8", "states mult: 8, which is not read"),
        ("CZ MM 1.5e-06", "states cz"),
        ("Wavelength = 632.8", "states wavelength"),
        ("zscale = 2", "states zscale"),
        ("% zscale, 2", "states zscale"),
        ("Z-Faktor;2,5", "states z-faktor"),
        ("Height LSB (nm): 1.5", "states height lsb"),
        ("height conversion factor (-> m)=2.9e-8", "states height conversion factor"),
    ],
)
def test_a_remark_acts_or_is_refused(tmp_path, remark, answer):
    text = f"{remark}\n{matrix()}".replace(str(Z[3, 3]), "0.1234")
    if isinstance(answer, float):
        lines = read(tmp_path, text, units=("mm", "nm"))
        assert lines.step == pytest.approx(answer)
        assert lines.heights.max() == pytest.approx(max(Z.max(), 0.1234) * 1e-9)
    else:
        with pytest.raises(UserError, match=answer):
            read(tmp_path, text, units=("mm", "nm"))


def test_heights_alone(tmp_path):
    heights = rows(Z[0])
    lines = read(tmp_path, f"# pitch = 0,5 um\n# unit = nm\n{heights}")
    np.testing.assert_allclose(lines.heights, Z[:1] * 1e-9)
    assert lines.step == pytest.approx(0.5e-6)
    with pytest.raises(UserError, match=r"heights alone, .*: give surface\.step"):
        read(tmp_path, f"z [um]\n{heights}")
    for pitch, step in (("0.5 um", 0.5e-6), ("0.5", 0.5e-3)):  # its own unit goes first
        lines = read(tmp_path, f"pitch: {pitch}\n{heights}", units=("mm", "nm"))
        assert lines.step == pytest.approx(step)
    assert read(tmp_path, f"z [um]\n{heights}", step=2e-6).step == 2e-6


def test_a_step_goes_before_positions(tmp_path):
    text = f"t [s],z [um]\n{rows(X, Z[0])}"
    assert read(tmp_path, text, step=2e-6, columns=(1,)).step == 2e-6


@pytest.mark.parametrize(
    ("text", "how", "words"),
    [
        ("Cutoff 0.8 mm, stylus 2 µm\n{0}", {}, "surface.units: missing: 'f.dat' names none"),
        ("Start 02:10 PM, end 02:12 PM\n{0}", {}, "surface.units: missing: 'f.dat' names none"),
        ("x (mm),height\n{0}", {}, r"names \['mm', ''\]"),
        (
            "t (s),z (um)\n{0}",
            {"columns": (0, 1)},
            "the unit 's' of column 0 t is not a unit of length: give surface.c",
        ),
        ("x (um),z (um)\n{0}7\n", {}, "'f.dat': line 26 reads '7': must hold 2 cells"),
    ],
)
def test_what_a_file_does_not_say_is_asked_for(tmp_path, text, how, words):
    with pytest.raises(UserError, match=words):
        read(tmp_path, text.format(rows(X, Z[0])), **how)


def test_units_that_are_given_go_before_what_the_file_says(tmp_path):
    lines = read(tmp_path, f"x (furlong),z (V)\n{rows(X, Z[0])}", units=("mm", "nm"))
    np.testing.assert_allclose(lines.heights, Z[:1] * 1e-9)
    assert lines.step == pytest.approx(0.5e-3)


def test_a_power_spectrum_is_not_read_as_heights(tmp_path):
    with pytest.raises(UserError, match=r'give surface\.spectrum = .file = "f\.dat"'):
        read(tmp_path, "q (1/m),C(q) (m^4)\n1,3\n2,2\n4,1\n8,1\n16,1\n")
