"""`prony FILE` prints a table [material] that a study reads, and writes its branches."""

import tomllib

import numpy as np
import pytest

from elastomer_friction.workflow.cli.commands import main
from elastomer_friction.workflow.study.effects.material import MATERIAL, read_material
from elastomer_friction.workflow.study.settings import checked
from tests.support.commands import output
from tests.support.small import small_study

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
def test_refusals(capsys, tmp_path, arguments, answer):
    assert main(["prony", measured(tmp_path), *arguments]) == 2
    assert answer in capsys.readouterr().err


def test_a_liquid_is_no_foundation(capsys, tmp_path):
    assert main(["prony", measured(tmp_path, relaxed=0.0)]) == 2
    assert "the best fit has no relaxed modulus; is it a rubber?" in capsys.readouterr().err
