"""Python subprocesses, by default in the root of the repository."""

import contextlib
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PATIENCE = 120.0  # s, timeout for a process


def python(
    *words: object, cwd: Path = ROOT, **environment: str
) -> subprocess.CompletedProcess[str]:
    """Run Python with arguments and extra environment variables; return the completed process."""
    command = [sys.executable, *map(str, words)]
    env = os.environ | environment
    return subprocess.run(command, cwd=cwd, env=env, capture_output=True, text=True, check=False)


def printed(*words: object, cwd: Path = ROOT, **environment: str) -> str:
    """Return the stdout of Python, which must succeed."""
    done = python(*words, cwd=cwd, **environment)
    assert done.returncode == 0, done.stderr
    return done.stdout


@contextlib.contextmanager
def standing(script: str, *arguments: str) -> Iterator[tuple[subprocess.Popen, str]]:
    """Run a script; yield the process and the first line that it prints, then kill it."""
    words = [sys.executable, "-c", script, *arguments]
    process = subprocess.Popen(words, cwd=ROOT, stdout=subprocess.PIPE, text=True)
    try:
        yield process, process.stdout.readline().strip()
    finally:
        process.kill()
        process.communicate(timeout=PATIENCE)
