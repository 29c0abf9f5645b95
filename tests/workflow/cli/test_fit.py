"""`fit FILE…` and `prony FILE` print what measurements determine, in the form of a study."""

import tomllib

import numpy as np
import pytest

import elastomer_friction as ef
from elastomer_friction.kernels import Wlf
from elastomer_friction.workflow import laboratory
from elastomer_friction.workflow.cli import command_line
from elastomer_friction.workflow.study.effects.material import MATERIAL, read_material
from elastomer_friction.workflow.study.settings import checked
from tests.support.commands import output, refusal
from tests.support.small import small_study
from tests.workflow.laboratory.given import record, records, write


def test_a_file_of_one_step(capsys, tmp_path):
    path = write(tmp_path / "one.txt", record())
    text = output(capsys, "fit", str(path), "--out", str(tmp_path / "new" / "fit.png"))
    assert "one.txt: 800 rows; column 0 time as a time in s, column 1 velocity as a" in text
    assert "\none.txt: from 0.1 to 0.12 m/s\n" in text
    assert "not determined          tau, H and q_max: one speed" in text
    assert text.endswith(f"{tmp_path}/new/fit.png\n{tmp_path}/new/fit.pdf\n")
    assert (tmp_path / "new" / "fit.pdf").stat().st_size > 1000


def test_several_files_and_what_is_known(capsys, tmp_path):
    paths = [str(write(tmp_path / f"{i}.txt", one)) for i, one in enumerate(records([0.05, 0.3]))]
    out = ["--out", str(tmp_path / "f.png"), "--relaxation-time", "0.1"]
    text = output(capsys, "fit", *paths, *out)
    assert "  tau                     0.1 s, given\n" in text
    assert "  q_max " in text


@pytest.mark.parametrize(
    ("arguments", "answer"),
    [
        (["--columns", "0,1"], "--columns 0,1: must be three numbers from 0, as 0,1,2"),
        (["--window", "-1"], "--window -1: must be greater than zero"),
        (["--q-max", "nan"], "--q-max nan: must be greater than zero"),
        (["--hurst", "1.5"], "--hurst 1.5: must lie between 0 and 1"),
        (["--columns", "0,1,7"], "--columns asks for column 7 of"),
    ],
)
def test_refusals(capsys, tmp_path, arguments, answer):
    path = write(tmp_path / "one.txt", record())
    assert answer in refusal(capsys, "fit", str(path), *arguments)


@pytest.mark.parametrize("given", ["0", "0,1,2,3"])
def test_prony_takes_two_or_three_columns(capsys, tmp_path, given):
    path = str(measured(tmp_path))
    answer = f"--columns {given}: must be two or three numbers from 0, as 0,1,2"
    assert answer in refusal(capsys, "prony", path, "--columns", given)


OMEGA = np.geomspace(1e-2, 1e4, 40)


def measured(tmp_path, omega=OMEGA, relaxed=1e6):
    """Write moduli of two branches and return the path."""
    values = relaxed + sum(g * 1j * omega * t / (1 + 1j * omega * t) for g, t in BRANCHES)
    path = tmp_path / "moduli.txt"
    np.savetxt(
        path, np.c_[omega, values.real, values.imag], header="omega [rad/s] G' [Pa] G'' [Pa]"
    )
    return str(path)


BRANCHES = ((1e7, 1e-3), (5e6, 0.1))


def test_the_printed_table_is_a_material(capsys, tmp_path):
    text = output(capsys, "prony", measured(tmp_path))
    table = checked("material", tomllib.loads(text)["material"], MATERIAL)
    material = read_material("material", table, tmp_path)
    assert material.shear_modulus == pytest.approx(1e6)
    np.testing.assert_allclose(material.branches, BRANCHES, rtol=1e-5)
    assert "# 40 frequencies, 0.01 ... 1e+04 rad/s\n" in text
    assert "column 1 G' as a storage modulus G' in Pa," in text
    assert "relaxation slower than 1e+03 s counts as complete" in text
    assert "2 branches; residual of G*" in text
    assert "do not determine" not in text
    fitted = ef.prony(measured(tmp_path))
    assert f"{fitted}\n" == text
    assert dict(fitted) == tomllib.loads(text)["material"]
    assert fitted.residual <= fitted.worst < 1e-5
    per_decade = text.split("residual per decade from 0.01 rad/s: ")[1].split(" %")[0]
    assert len(per_decade.split(", ")) == 7  # six decades, and the last frequency of all


def test_the_written_branches_are_read_by_a_study(capsys, tmp_path):
    out = tmp_path / "branches.csv"
    text = output(capsys, "prony", measured(tmp_path), "--out", str(out), "--frequency", "rad/s")
    assert f'branches_file = "{out}"' in text
    study = small_study(f'material.branches_file="{out}"')
    np.testing.assert_allclose(study.material.branches, BRANCHES, rtol=1e-5)
    (tmp_path / "study.toml").touch()
    later = tmp_path / "studies" / "mine" / "branches.csv"  # before the file of the study
    later.parent.mkdir(parents=True)
    for path in (out, later):
        assert 'branches_file = "branches.csv"' in output(
            capsys, "prony", str(tmp_path / "moduli.txt"), "--out", str(path)
        )


def test_the_measurement_is_never_overwritten(capsys, tmp_path):
    path = measured(tmp_path)
    before = (tmp_path / "moduli.txt").read_bytes()
    (tmp_path / "link.txt").symlink_to(path)
    for out in (path, str(tmp_path / "link.txt")):
        assert "is the measurement itself" in refusal(capsys, "prony", path, "--out", out)
    assert (tmp_path / "moduli.txt").read_bytes() == before


def test_moduli_without_a_prony_series_are_refused(capsys, tmp_path):
    path = tmp_path / "modes.txt"
    path.write_text("1 2e5 2e-8\n2 1e4 3e2\n3 6e2 1.5e5\n4 30 1e6\n5 2 9e6\n6 0.3 9e6\n")
    text = refusal(capsys, "prony", str(path))
    assert "no Prony series fits: the rms residual" in text
    assert "above 15 %" in text
    assert "column 0 as a frequency in rad/s (assumed)" in text


def sweeps(tmp_path, wlf, temperatures):
    """Write E' and E'' of two branches at several temperatures and return the path."""
    rows, f = ["T (°C);f (Hz);E' (MPa);E'' (MPa)"], np.geomspace(0.1, 100.0, 8)
    for t in temperatures:
        omega = 2.0 * np.pi * f * 10.0 ** wlf.decades(t)
        values = 3.0 + 3.0 * sum(
            g / 1e6 * 1j * omega * b / (1 + 1j * omega * b) for g, b in BRANCHES
        )
        columns = np.transpose([f, values.real, values.imag])
        rows += [f"{t};{one:.9g};{a:.9g};{b:.9g}" for one, a, b in columns]
    path = tmp_path / "sweeps.csv"
    path.write_text("\n".join(rows), encoding="utf-8")
    return str(path)


WLF = Wlf(8.86, 101.6, 20.0)


def test_sweeps_at_several_temperatures_are_a_material_that_shifts(capsys, tmp_path):
    path = sweeps(tmp_path, WLF, (0.0, 10.0, 20.0, 30.0, 40.0))
    text = output(capsys, "prony", path, "--reference", "15", "--out", str(tmp_path / "b.csv"))
    assert "# 5 sweeps at 0 ... 40 °C, shifted to 15 °C" in text
    assert ef.prony(path, reference=15.0)["wlf"] == tomllib.loads(text)["material"]["wlf"]
    assert "#   10 °C: log10 a_T = 0.50" in text
    table = checked("material", tomllib.loads(text)["material"], MATERIAL)
    found = read_material("material", table | {"temperature": 20.0}, tmp_path)
    assert found.wlf is not None
    assert found.wlf.reference == 15.0
    assert found.wlf.c2 == pytest.approx(96.6, rel=1e-3)
    assert found.shear_modulus == pytest.approx(1e6, rel=1e-3)
    times = [found.shift_factor * time for _, time in found.branches]
    np.testing.assert_allclose(times, [time for _, time in BRANCHES], rtol=2e-3)


def test_the_figure_of_a_material(capsys, tmp_path):
    for name, path in (("one", measured(tmp_path)), ("two", sweeps(tmp_path, WLF, (0.0, 20.0)))):
        figure = tmp_path / "new" / f"{name}.png"
        assert f"# figure: {figure}\n" in output(capsys, "prony", path, "--figure", str(figure))
        assert figure.read_bytes().startswith(b"\x89PNG")
        assert figure.with_suffix(".pdf").is_file()


def test_sweeps_that_no_law_describes_are_a_material_with_a_table(capsys, tmp_path):
    path = sweeps(tmp_path, WLF, (0.0, 20.0, 40.0))
    text = output(capsys, "prony", path, "--law", "shifts")
    shifts = tomllib.loads(text)["material"]["shifts"]
    np.testing.assert_allclose(shifts, [[t, WLF.decades(t)] for t in (0, 20, 40)], atol=2e-3)


def test_a_relaxation_test_is_a_material(capsys, tmp_path):
    time = np.geomspace(1e-4, 1e2, 40)
    values = 3.0 * (1e6 + sum(g * np.exp(-time / b) for g, b in BRANCHES))
    np.savetxt(tmp_path / "r.txt", np.c_[time, values], header="t [s] E(t) [Pa]")
    text = output(capsys, "prony", str(tmp_path / "r.txt"))
    material = tomllib.loads(text)["material"]
    assert material["shear_modulus"] == pytest.approx(1e6, rel=1e-4)
    np.testing.assert_allclose(material["branches"], BRANCHES, rtol=1e-3)
    assert "# 40 times, 0.0001 ... 100 s" in text
    assert "residual per decade from 100 s down: " in text


def test_a_short_relaxation_test_states_the_undetermined_modulus(capsys, tmp_path):
    time = np.geomspace(1e-4, 0.1, 30)
    values = 1e6 + sum(g * np.exp(-time / b) for g, b in BRANCHES)
    noise = 1.0 + 0.01 * np.random.default_rng(0).standard_normal(time.size)
    np.savetxt(tmp_path / "r.txt", np.c_[time, noise * values])
    text = output(capsys, "prony", str(tmp_path / "r.txt"))
    low, high = (float(part.split()[0]) for part in text.split("modulus: ")[1].split("...")[:2])
    assert low <= 1e6 <= high
    assert "fit equally well; measure beyond 0.1 s" in text


def test_the_help_names_every_form_of_a_series():
    """The help repeats the names, so that it does not import ``laboratory``."""
    assert tuple(laboratory.FORMS) == command_line.PRONY_FORMATS


@pytest.mark.parametrize("form", ["abaqus", "ansys"])
def test_shares_of_the_instantaneous_modulus(capsys, tmp_path, form):
    text = output(capsys, "prony", measured(tmp_path), "--write", form)
    assert "G_0 = 1.6e+07 Pa" in text
    wanted = {"abaqus": "\n0.3125, 0, 0.1\n", "ansys": "\nTB,PRONY,1,1,2,SHEAR\n"}
    assert wanted[form] in text
    assert "[material]" not in text


def test_undetermined_moduli_are_stated(capsys, tmp_path):
    text = output(capsys, "prony", measured(tmp_path, OMEGA[OMEGA > 100.0]))
    assert "# the data do not determine the relaxed modulus: " in text
    assert "fit equally well; measure at frequencies below 1" in text


@pytest.mark.parametrize(
    ("arguments", "answer"),
    [
        (["--branches", "0"], "error: --branches 0: must be at least 1\n"),
        (["--branches", "1"], "1 branches are too few"),
        (["--temperatures", "20,warm"], "--temperatures 20,warm: must be numbers in °C"),
        (["--reference", "20"], "shift sweeps at several temperatures; it holds one"),
        (["--law", "wlf", "--temperatures", "20"], "it holds one"),
        (["--poisson", "0.6"], "error: --poisson 0.6: must lie between -1 and 0.5\n"),
        (["--out", "/dev/null/x.csv"], "cannot be written"),
    ],
)
def test_refusals_of_prony(capsys, tmp_path, arguments, answer):
    assert answer in refusal(capsys, "prony", measured(tmp_path), *arguments)


@pytest.mark.parametrize(
    ("arguments", "answer"),
    [
        (["--reference", "90"], "--reference 90: must lie within the sweeps, 0 to 20 °C"),
        (["--law", "wlf"], "2 temperatures do not determine a law wlf: it needs 4"),
    ],
)
def test_refusals_of_sweeps(capsys, tmp_path, arguments, answer):
    assert answer in refusal(capsys, "prony", sweeps(tmp_path, WLF, (0.0, 20.0)), *arguments)


def test_a_decade_that_the_series_misses_is_named(capsys, tmp_path):
    path = measured(tmp_path)
    rows = np.loadtxt(path)
    rows[-2:, 1:] *= 2.0  # as a resonance of the instrument
    np.savetxt(path, rows)
    text = output(capsys, "prony", path)
    assert "# warning: the residual exceeds 15 % in decade " in text
    assert "warning" not in output(capsys, "prony", measured(tmp_path))


def test_sweeps_that_are_no_one_curve_are_no_material(capsys, tmp_path):
    omega = np.geomspace(0.1, 100.0, 8)
    rows = [f"{w} {1e6 * w**0.1} {1e5}" for w in omega] + [f"{w} {3e6 / w**0.3} 1e6" for w in omega]
    (tmp_path / "s.txt").write_text("\n".join(rows))
    text = refusal(capsys, "prony", str(tmp_path / "s.txt"), "--temperatures", "0,20")
    assert "no shifts bring the sweeps onto one curve" in text
    assert "try --vertical" in text


def test_moduli_of_a_liquid_are_refused(capsys, tmp_path):
    said = refusal(capsys, "prony", measured(tmp_path, relaxed=0.0))
    assert "the best fit has no relaxed modulus; a study needs the moduli of a rubber" in said
