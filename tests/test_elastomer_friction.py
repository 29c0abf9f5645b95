"""The console command: what ``python -m workflow`` is, and one line where it cannot be that."""

import os
import subprocess
import sys
import tomllib
import zipfile
from pathlib import Path

import pytest

from tests.support.runs import PATIENCE, ROOT
from workflow.system import version_of

CALL = "import sys; from elastomer_friction import main; sys.exit(main())"


def called(*arguments: str, path: str = str(ROOT), folder: Path = ROOT) -> tuple[int, str, str]:
    """Return exit status, stdout and stderr of the command."""
    done = subprocess.run(
        [sys.executable, "-P", "-c", CALL, *arguments],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": path},
        capture_output=True,
        text=True,
        timeout=PATIENCE,
        check=False,
    )
    return done.returncode, done.stdout, done.stderr


def test_it_says_its_version(tmp_path):
    said = f"elastomer-friction {version_of('elastomer-friction')}\n"
    assert called("--version", folder=tmp_path) == (0, said, "")


@pytest.mark.parametrize("name", ["workflow", "kernels"])
def test_another_package_of_our_names_is_one_line(tmp_path, name):
    (tmp_path / name).mkdir()
    (tmp_path / name / "__init__.py").write_text("")
    path = f"{tmp_path}{os.pathsep}{ROOT}"
    status, out, err = called("studies", path=path)
    assert (status, out) == (2, "")
    assert err.startswith(f"error: Python finds the package {name} at {tmp_path / name}/__init__")
    assert len(err.splitlines()) == 1


def test_the_citation_is_of_this_version():
    """And what is cited is what is installed under the name of the program."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert f"\nversion: {project['version']}\n" in (ROOT / "CITATION.cff").read_text("utf-8")
    assert f"\n## {project['version']} (" in (ROOT / "CHANGELOG.md").read_text("utf-8")


@pytest.mark.exhaustive
def test_a_wheel_holds_all_that_the_command_needs(tmp_path, monkeypatch):
    """Built from the sources, installed without its dependencies, and used from elsewhere."""
    monkeypatch.delenv("GIT_DIR", raising=False)  # other tests hide the repository
    pip = [sys.executable, "-m", "pip", "-q", "--disable-pip-version-check"]
    subprocess.run([*pip, "wheel", "--no-deps", "-w", tmp_path, ROOT], check=True)
    (wheel,) = tmp_path.glob("*.whl")
    names = set(zipfile.ZipFile(wheel).namelist())
    shipped = subprocess.check_output(["git", "-C", ROOT, "ls-files", "studies"], text=True)
    assert set(shipped.splitlines()) <= names
    assert {"workflow/cli/study.toml", "workflow/report/page/report.html.j2"} <= names
    assert not [name for name in names if name.startswith("tests")]
    site, away = tmp_path / "site", tmp_path / "away"
    subprocess.run([*pip, "install", "--no-deps", "--target", site, wheel], check=True)
    away.mkdir()
    status, out, err = called("studies", path=str(site), folder=away)
    assert (status, err) == (0, "")
    assert "fig7" in out
    assert called("new", "mine", path=str(site), folder=away)[0] == 0
    assert (away / "studies" / "mine" / "study.toml").is_file()
