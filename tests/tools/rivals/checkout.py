"""An earlier commit of this program, checked out beside it for as long as it is needed."""

import contextlib
import os
import subprocess
import tempfile
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
COMMIT = "9b0af71"  # that the speed of later ones is told against


@contextlib.contextmanager
def checkout(commit: str) -> Iterator[tuple[Path, dict[str, str]]]:
    """Yield the folder of a commit, and the environment in which its code is imported.

    Raises OSError or CalledProcessError where it cannot be had.
    """
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder) / commit
        clone = ["git", "clone", "--quiet", "--shared", str(ROOT), str(place)]
        switch = ["git", "-C", str(place), "checkout", "--quiet", commit]
        for command in (clone, switch):
            subprocess.run(command, check=True, capture_output=True)
        yield place, {**os.environ, "PYTHONPATH": str(place)}
