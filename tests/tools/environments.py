"""Try the program in other environments than that of the day: a smoke study, numerical tests.

    python -m tests.tools.environments oldest     the lower bounds of pyproject.toml
    python -m tests.tools.environments newest     the newest Python that is on this machine
    python -m tests.tools.environments newest install     install it, and try nothing

Each has a virtual environment of its own beside .venv, made anew when pyproject.toml changes. The
machine code lies in it too: kernels of one numba are none for another, and nobody waits for them.
Where this machine has no such Python, or the packages cannot be had for it, one line says so.
Warnings are no errors here: those of old packages about new ones are not ours to mend.
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
    "--ignore=tests/workflow/result/test_conventions.py",  # its checker is no package of ours
]
OLDEST = 11  # Python 3.11, as in pyproject.toml


def requirements(oldest: bool) -> list[str]:
    """Return what the program needs; ``oldest`` : at its lower bounds."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    needed = project["dependencies"] + project["optional-dependencies"]["slurm"]
    return [need.replace(">=", "==") for need in needed] if oldest else needed


def candidates(which: str) -> list[str]:
    """Return the paths of the Pythons of this machine to try, the newest first."""
    pyenv = Path(os.environ.get("PYENV_ROOT", Path.home() / ".pyenv"))
    folders = [*pyenv.glob("versions/3.*/bin"), *map(Path, os.get_exec_path())]
    there = [path for folder in folders for path in sorted(folder.glob("python3.*"))]
    minor = {str(path): int(path.suffix[1:]) for path in there if path.suffix[1:].isdecimal()}
    usual = sys.version_info.minor
    fit = [p for p, n in minor.items() if (n == OLDEST if which == "oldest" else n > usual)]
    return sorted(fit, key=lambda path: -minor[path])


def made(python: str, folder: Path, needed: list[str]) -> Path | None:
    """Return the Python of an environment with what is needed; None where that cannot be had."""
    note, wanted = folder / "made-of", "\n".join([python, *needed])
    inside = folder / "bin" / "python"
    if note.is_file() and note.read_text(encoding="utf-8") == wanted:
        return inside
    shutil.rmtree(folder, ignore_errors=True)
    if subprocess.run([python, "-m", "venv", folder], check=False).returncode:
        return None  # a shim may lead nowhere
    pip = [inside, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-compile"]
    if subprocess.run([*pip, "--only-binary", ":all:", *needed], check=False).returncode:
        return None
    note.write_text(wanted, encoding="utf-8")
    return inside


def installed(which: str) -> Path | None:
    """Return the Python of one of the environments, and say what is in it, or why there is none."""
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
    """Run a study at smoke scale, draw its figure, and run the tests, in one environment."""
    own = {**os.environ, "NUMBA_CACHE_DIR": str(inside.parents[1] / "machine-code")}
    own.pop("PYTHONDONTWRITEBYTECODE", None)  # pip has made none: every start would do it anew
    with tempfile.TemporaryDirectory() as out:
        study = ["fig2", "--scale", "smoke", "--out", out]
        for command in (
            ["workflow", "run", *study],
            ["workflow", "figure", *study],
            # In one process: two would each compile for themselves much of what both need.
            ["pytest", "-q", "-n", "0", "-W", "default", "-m", "not exhaustive", *TESTS],
        ):
            subprocess.run([inside, "-m", *command], cwd=ROOT, env=own, check=True)


def main() -> None:
    """Install one environment, and try it unless ``install`` is asked for."""
    which, *rest = sys.argv[1:]
    inside = installed(which)
    if inside and rest != ["install"]:
        try_it(inside)


if __name__ == "__main__":
    main()
