"""`fit FILE…` and `prony FILE` say what measurements determine, as a study reads it."""

import tomllib

import numpy as np
import pytest

from elastomer_friction.workflow.cli.commands import main
from elastomer_friction.workflow.study.effects.material import MATERIAL, read_material
from elastomer_friction.workflow.study.settings import checked
from tests.support.commands import output, refusal
from tests.support.small import small_study
from tests.workflow.laboratory.given import record, records, write


def test_a_file_of_one_step(capsys, tmp_path):
    path = write(tmp_path / "one.txt", record())
    text = output(capsys, "fit", str(path), "--out", str(tmp_path / "new" / "fit.png"))
    assert text.startswith("one.txt: from 0.1 to 0.12 m/s\n")
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
        (["--columns", "0,1,7"], "one.txt': holds no row of 3 numbers in columns [0, 1, 7]"),
    ],
)
def test_refusals(capsys, tmp_path, arguments, answer):
    path = write(tmp_path / "one.txt", record())
    assert answer in refusal(capsys, "fit", str(path), *arguments)


OMEGA = np.geomspace(1e-2, 1e4, 40)


def measured(tmp_path, omega=OMEGA, relaxed=1e6):
    """Write moduli of two branches and return the path."""
    values = relaxed + sum(g * 1j * omega * t / (1 + 1j * omega * t) for g, t in BRANCHES)
    path = tmp_path / "moduli.txt"
    np.savetxt(path, np.c_[omega, values.real, values.imag], header="omega [rad/s] G' [Pa]")
    return str(path)


BRANCHES = ((1e7, 1e-3), (5e6, 0.1))


def test_the_printed_table_is_a_material(capsys, tmp_path):
    text = output(capsys, "prony", measured(tmp_path))
    table = checked("material", tomllib.loads(text)["material"], MATERIAL)
    material = read_material("material", table, tmp_path)
    assert material.shear_modulus == pytest.approx(1e6)
    np.testing.assert_allclose(material.branches, BRANCHES, rtol=1e-5)
    assert "40 frequencies, 0.01 ... 1e+04 rad/s, read as rad/s and Pa" in text
    assert "2 branches; residual of G*" in text
    assert "do not determine" not in text


def test_the_written_branches_are_read_by_a_study(capsys, tmp_path):
    out = tmp_path / "branches.csv"
    text = output(capsys, "prony", measured(tmp_path), "--out", str(out), "--frequency", "rad/s")
    assert f'branches_file = "{out}"' in text
    study = small_study(f'material.branches_file="{out}"')
    np.testing.assert_allclose(study.material.branches, BRANCHES, rtol=1e-5)


def test_it_says_what_the_data_leave_open(capsys, tmp_path):
    text = output(capsys, "prony", measured(tmp_path, OMEGA[OMEGA > 100.0]))
    assert "# the data do not determine the relaxed modulus: " in text
    assert "it wants frequencies below 1" in text


@pytest.mark.parametrize(
    ("arguments", "answer"),
    [
        (["--branches", "0"], "error: --branches 0: must be at least 1\n"),
        (["--out", "/dev/null/x.csv"], "cannot be written"),
    ],
)
def test_refusals_of_prony(capsys, tmp_path, arguments, answer):
    assert main(["prony", measured(tmp_path), *arguments]) == 2
    assert answer in capsys.readouterr().err


def test_a_liquid_is_no_foundation(capsys, tmp_path):
    assert main(["prony", measured(tmp_path, relaxed=0.0)]) == 2
    assert "the best fit has no relaxed modulus; is it a rubber?" in capsys.readouterr().err
