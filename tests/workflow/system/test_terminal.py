"""Streams that are closed, broken or cannot show a letter trouble nobody; in real processes."""

import os
import select
import subprocess
import sys

import pytest

from elastomer_friction.workflow.system import program
from tests.support.runs import PATIENCE, ROOT

SAY = """
import contextlib, os, sys
from elastomer_friction.workflow.system import forgive_streams
forgive_streams()
for _ in range(20000):
    print("said", file=sys.stderr)
    print("printed")
print("µ₁ ≤ τ", flush=True)
print("µ₁ ≤ τ", file=sys.stderr)
file = os.open(sys.argv[1], os.O_CREAT | os.O_WRONLY)
assert file > 2, file
with contextlib.suppress(OSError):
    os.write(2, b"not into a file")
"""


def said(redirection, path, **environment):
    """Return the exit status of a process with some redirection, and what came through."""
    command = f'"{sys.executable}" -c \'{SAY}\' "{path}" {redirection}'
    done = subprocess.run(
        ["bash", "-c", f"set -o pipefail; {command}"],
        cwd=ROOT,
        env={**os.environ, **environment},
        capture_output=True,
        timeout=PATIENCE,
        check=False,
    )
    return done.returncode, done.stdout, done.stderr


@pytest.mark.parametrize("redirection", ["2>&-", ">&-", "0<&- >&- 2>&-", "2>/dev/full >/dev/full"])
def test_a_stream_that_cannot_be_written_ends_nothing(tmp_path, redirection):
    assert said(redirection, tmp_path / "file")[0] == 0
    assert (tmp_path / "file").read_bytes() == b""


def test_a_pipe_that_nobody_reads_ends_nothing(tmp_path):
    assert said("2>&1 | true", tmp_path / "file")[0] == 0


def test_letters_that_the_terminal_lacks_are_shown_as_numbers(tmp_path):
    status, out, err = said("", tmp_path / "file", PYTHONIOENCODING="latin-1")
    assert status == 0
    for text in (out, err):
        assert "µ\\u2081 \\u2264 \\u03c4".encode("latin-1") in text.splitlines()


WAIT = """
import sys
from elastomer_friction.workflow.system import forgive_streams
forgive_streams()
print("said", file=sys.stderr)
sys.stdin.read()
"""


@pytest.mark.parametrize("unbuffered", ["", "1"])
def test_a_line_of_the_standard_error_is_there_at_once(unbuffered):
    environment = {**os.environ, "PYTHONUNBUFFERED": unbuffered}
    pipes = dict.fromkeys(("stdin", "stderr"), subprocess.PIPE)
    with subprocess.Popen([sys.executable, "-c", WAIT], env=environment, cwd=ROOT, **pipes) as one:
        assert select.select([one.stderr], [], [], PATIENCE)[0]
        assert one.poll() is None
        one.communicate()


@pytest.mark.parametrize(
    ("called", "name"),
    [
        ("/usr/bin/elastomer-friction", "elastomer-friction"),
        ("/usr/lib/workflow/__main__.py", "python -m workflow"),
    ],
)
def test_the_program_is_named_as_it_was_called(monkeypatch, called, name):
    monkeypatch.setattr(sys, "argv", [called, "plan"])
    assert program() == name
