"""Python in processes of its own: what it says, with which exit status; in the repository."""

import contextlib
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PATIENCE = 120.0  # seconds to wait for a process at most


def python(
    *words: object, cwd: Path = ROOT, **environment: str
) -> subprocess.CompletedProcess[str]:
    """Return how Python ended with these words behind its name, and what it said."""
    command = [sys.executable, *map(str, words)]
    own = os.environ | environment
    return subprocess.run(command, cwd=cwd, env=own, capture_output=True, text=True, check=False)


def printed(*words: object, cwd: Path = ROOT, **environment: str) -> str:
    """Return what Python prints, which has to end well."""
    done = python(*words, cwd=cwd, **environment)
    assert done.returncode == 0, done.stderr
    return done.stdout


@contextlib.contextmanager
def standing(script: str, *arguments: str) -> Iterator[tuple[subprocess.Popen, str]]:
    """Yield a process that runs a script, once it has said a line, and that line; then kill it."""
    words = [sys.executable, "-c", script, *arguments]
    process = subprocess.Popen(words, cwd=ROOT, stdout=subprocess.PIPE, text=True)
    try:
        yield process, process.stdout.readline().strip()
    finally:
        process.kill()
        process.communicate(timeout=PATIENCE)
