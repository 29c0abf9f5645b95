"""The package as installed and imported: its public names and its command."""

import os
import re
import subprocess
import sys
import tomllib
import zipfile
from pathlib import Path

import pytest
import xarray as xr

import elastomer_friction as ef
from elastomer_friction.workflow.kinetic_law import KineticLaw
from elastomer_friction.workflow.system import version_of
from tests.support.python import ROOT, printed, python
from tests.support.runs import run
from tests.support.small import small_study, write_study

SOURCES = ROOT / "src"
CALL = "import sys; from elastomer_friction.__main__ import main; sys.exit(main())"


def called(*arguments: str, path: Path = SOURCES, folder: Path = ROOT) -> tuple[int, str, str]:
    """Run the command; return its exit status, stdout and stderr. path : of the package."""
    done = python("-P", "-c", CALL, *arguments, cwd=folder, PYTHONPATH=str(path))
    return done.returncode, done.stdout, done.stderr


def test_it_says_its_version(tmp_path):
    expected = f"elastomer-friction {version_of('elastomer-friction')}\n"
    assert called("--version", folder=tmp_path) == (0, expected, "")


def test_what_is_asked_from_python_is_listed_and_nothing_else():
    commands = {"figure", "plan", "prony", "run"}
    names = {"KineticLaw", "UserError", "__version__", "block_means", "law", "open", "scene"}
    assert dir(ef) == sorted(names | commands)
    assert ef.__version__ == version_of("elastomer-friction")
    assert (dir(ef.law), dir(ef.scene)) == (["Law", "export", "fit", "read"], ["animate", "run"])
    with pytest.raises(ef.UserError, match="nowhere: not found"):
        ef.open("nowhere")
    for odd in (3, None, "a\0b"):
        with pytest.raises(ef.UserError, match="not found"):
            ef.open(odd)
    assert ef.KineticLaw is KineticLaw


def test_a_result_opens_as_a_tree_with_its_comparisons(tmp_path):
    path = run(tmp_path).path
    with ef.open(path) as tree:
        assert set(tree.mu_1.dims) == set(small_study().axes)
    broken, other = tmp_path / "broken.nc", tmp_path / "other.nc"
    broken.write_bytes(b"CDF")
    with pytest.raises(ef.UserError, match="cannot be read as netCDF"):
        ef.open(broken)
    xr.Dataset({"a": 1}).to_netcdf(other)
    with pytest.raises(ef.UserError, match="is not a result of this program"):
        ef.open(other)


NOTE = """
import os, sys
class Note:
    def find_spec(name, *_):
        if name == "distributed" or name.partition(".")[0] in ("kernels", "workflow", "studies"):
            with open(os.path.join(os.environ["NOTES"], str(os.getpid())), "a") as note:
                print(name, file=note)
sys.meta_path.insert(0, Note)
"""


def test_no_module_is_loaded_by_a_second_name(tmp_path):
    """Otherwise a class would exist twice, in the driver, in workers and in the tests.

    Imports are recorded as they happen, since a worker that is slow to end is killed.
    """
    (tmp_path / "sitecustomize.py").write_text(NOTE)
    (tmp_path / "notes").mkdir()
    path = f"{tmp_path}{os.pathsep}{ROOT}"
    words = ["run", write_study(tmp_path), "--workers", "1", "--out", tmp_path]
    printed("-m", "workflow", *words, PYTHONPATH=path, NOTES=str(tmp_path / "notes"))
    imported = [note.read_text().split() for note in (tmp_path / "notes").iterdir()]
    driver = ["distributed", "workflow", "workflow.__main__"]  # workflow is only a docstring
    assert sorted(sorted(set(names)) for names in imported) == [["distributed"], driver]
    assert not {name.partition(".")[0] for name in sys.modules} & {"kernels", "workflow", "studies"}


def test_the_citation_is_of_this_version():
    """The citation and the changelog name the version of the package."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert f"\nversion: {project['version']}\n" in (ROOT / "CITATION.cff").read_text("utf-8")
    assert f"\n## {project['version']} (" in (ROOT / "CHANGELOG.md").read_text("utf-8")


def test_type_checkers_find_the_package(tmp_path):
    """An editable install must be a folder on the path, not a hook that only Python runs."""
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    (tmp_path / "example.py").write_text(re.search(r"```python\n(.*?)```", readme, re.DOTALL)[1])
    words = ("-m", "mypy", "--strict", "--follow-imports", "skip", "example.py")
    assert printed(*words, cwd=tmp_path).startswith("Success")


@pytest.mark.exhaustive
def test_a_wheel_holds_all_that_the_command_needs(tmp_path, monkeypatch):
    """It is built from the sources, installed without dependencies, and used elsewhere."""
    monkeypatch.delenv("GIT_DIR", raising=False)  # other tests hide the repository
    pip = [sys.executable, "-m", "pip", "-q", "--disable-pip-version-check"]
    subprocess.run([*pip, "wheel", "--no-deps", "-w", tmp_path, ROOT], check=True)
    (wheel,) = tmp_path.glob("*.whl")
    names = set(zipfile.ZipFile(wheel).namelist())
    shipped = subprocess.check_output(["git", "-C", ROOT, "ls-files", "studies"], text=True)
    needed = {"workflow/cli/study.toml", "workflow/report/report.html.j2", "py.typed"}
    needed |= set(shipped.splitlines())
    assert {f"elastomer_friction/{name}" for name in needed} <= names
    assert {name.partition("/")[0].partition("-")[0] for name in names} == {"elastomer_friction"}
    site, away = tmp_path / "site", tmp_path / "away"
    subprocess.run([*pip, "install", "--no-deps", "--target", site, wheel], check=True)
    away.mkdir()
    status, out, err = called("studies", path=site, folder=away)
    assert (status, err) == (0, "")
    assert "fig7" in out
    assert called("new", "mine", path=site, folder=away)[0] == 0
    assert (away / "studies" / "mine" / "study.toml").is_file()
