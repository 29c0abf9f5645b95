"""Packages of our names that are not ours: one line instead of a riddle."""

import os
import subprocess
import sys

import pytest

from tests.support.runs import PATIENCE, ROOT
from workflow.ours import stranger


def test_our_own_packages_are_no_strangers():
    assert stranger() == ""


@pytest.mark.parametrize("name", ["kernels", "studies"])
@pytest.mark.parametrize("call", [["-m", "workflow", "studies"], ["-c", "import workflow.study"]])
def test_another_package_of_our_names_is_named_with_what_to_do(tmp_path, name, call):
    (tmp_path / "away").mkdir()
    (tmp_path / name).mkdir()
    (tmp_path / name / "__init__.py").write_text("")
    done = subprocess.run(
        [sys.executable, *call],
        cwd=tmp_path / "away",
        env={**os.environ, "PYTHONPATH": f"{tmp_path}{os.pathsep}{ROOT}"},
        capture_output=True,
        text=True,
        timeout=PATIENCE,
        check=False,
    )
    assert done.returncode == (2 if "-m" in call else 1)
    said = done.stderr.splitlines()[-1]
    assert said.startswith(("error: ", "ImportError: "))
    assert f"the package {name} at {tmp_path / name}/__init__.py, not ours" in said
    assert "rename the other, take it out of PYTHONPATH" in said
