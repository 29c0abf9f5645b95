"""Test the program with the oldest and newest packages: a smoke study and numerical tests.

    python -m tests.tools.environments oldest     the lower bounds of pyproject.toml
    python -m tests.tools.environments newest     the newest Python on this machine
    python -m tests.tools.environments newest install     install it without tests

Each has its own virtual environment beside .venv, renewed when pyproject.toml changes. It also
holds the machine code, since kernels compiled by one numba do not suit another.
Without such a Python, or without packages for it, nothing is tested: one line says so, and the exit
status is 1 unless the list of allowed skips (tests/skips.txt, named by SKIPS) has the environment.
Warnings are not errors here, as old packages may warn about new ones.
"""

import os
import shutil
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TESTERS = ["pytest", "pytest-xdist", "hypothesis"]
TESTS = [
    "tests/kernels/quick/steady",
    "tests/workflow/reduce",
    "tests/workflow/result",
    "--ignore=tests/workflow/result/test_conventions.py",  # its checker is not a dependency
]
OLDEST = 11  # minor version of the oldest Python, as in pyproject.toml


def requirements(oldest: bool) -> list[str]:
    """Return the requirements of the program. oldest : whether to pin them at the lower bounds."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    needed = project["dependencies"] + project["optional-dependencies"]["slurm"]
    return [need.replace(">=", "==") for need in needed] if oldest else needed


def candidates(which: str) -> list[str]:
    """Return the paths of suitable Pythons on this machine, the newest first."""
    pyenv = Path(os.environ.get("PYENV_ROOT", Path.home() / ".pyenv"))
    folders = [*pyenv.glob("versions/3.*/bin"), *map(Path, os.get_exec_path())]
    paths = [path for folder in folders for path in sorted(folder.glob("python3.*"))]
    minor = {str(path): int(path.suffix[1:]) for path in paths if path.suffix[1:].isdecimal()}
    usual = sys.version_info.minor
    fit = [p for p, n in minor.items() if (n == OLDEST if which == "oldest" else n > usual)]
    return sorted(fit, key=lambda path: -minor[path])


def made(python: str, folder: Path, needed: list[str]) -> Path | None:
    """Return the Python of an environment with the requirements; None if they do not install."""
    note, wanted = folder / "made-of", "\n".join([python, *needed])
    inside = folder / "bin" / "python"
    if note.is_file() and note.read_text(encoding="utf-8") == wanted:
        return inside
    shutil.rmtree(folder, ignore_errors=True)
    if subprocess.run([python, "-m", "venv", folder], check=False).returncode:
        return None  # a shim may point to a missing Python
    pip = [inside, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-compile"]
    if subprocess.run([*pip, "--only-binary", ":all:", *needed], check=False).returncode:
        return None
    note.write_text(wanted, encoding="utf-8")
    return inside


def installed(which: str) -> Path | None:
    """Return the Python of an environment, and print its packages or why there is none."""
    needed = requirements(which == "oldest") + TESTERS
    tried = candidates(which)
    for python in tried:
        inside = made(python, ROOT / f".venv-{which}", needed)
        if inside:
            print(f"{which}: {python} with", *needed, flush=True)
            return inside
        print(f"{which}: the packages cannot be had for {python}", flush=True)
    print(f"{which}: not tried, no other Python of this machine will do ({tried or 'none'})")
    return None


def try_it(inside: Path) -> None:
    """Run a study at smoke scale, draw its figure, and run the tests in one environment."""
    env = {**os.environ, "NUMBA_CACHE_DIR": str(inside.parents[1] / "machine-code")}
    env["PYTHONPATH"] = str(ROOT / "src")  # the program is not installed there
    env.pop("PYTHONDONTWRITEBYTECODE", None)  # pip wrote no bytecode: write it at the first start
    with tempfile.TemporaryDirectory() as out:
        study = ["fig2", "--scale", "smoke", "--out", out]
        for command in (
            ["workflow", "run", *study],
            ["workflow", "figure", *study],
            # In one process, as two would both compile the same kernels.
            ["pytest", "-q", "-n", "0", "-W", "default", "-m", "not exhaustive", *TESTS],
        ):
            subprocess.run([inside, "-m", *command], cwd=ROOT, env=env, check=True)


def may_be_left_out(which: str) -> bool:
    """Return whether the list of allowed skips has this environment without a Python."""
    skips = os.environ.get("SKIPS", os.devnull)
    lines = (ROOT / skips).read_text(encoding="utf-8").splitlines()
    return not candidates(which) and f"tests/tools/environments.py: no Python, {which}" in lines


def main() -> None:
    """Install one environment, and test it unless ``install`` is given."""
    which, *rest = sys.argv[1:]
    inside = installed(which)
    if rest == ["install"]:
        return
    if inside:
        try_it(inside)
    elif not may_be_left_out(which):
        sys.exit(f"{which}: nothing was tested, which is a failure unless tests/skips.txt lists it")


if __name__ == "__main__":
    main()
