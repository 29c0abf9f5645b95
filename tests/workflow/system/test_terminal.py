"""Streams, signals, memory and packages of a process; streams in real processes."""

import os
import platform
import select
import signal
import subprocess
import sys
from importlib.metadata import version
from pathlib import Path

import pytest

from elastomer_friction.workflow.system import program
from elastomer_friction.workflow.system.packages import PACKAGES, processor, this_maker
from elastomer_friction.workflow.system.process import Interrupt
from tests.support.python import PATIENCE, ROOT, printed

SAY = """
import contextlib, os, sys
from elastomer_friction.workflow.system import make_streams_tolerant
make_streams_tolerant()
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


def outcome(redirection, path, **environment):
    """Return the exit status, output and errors of a process with some redirection."""
    command = f'"{sys.executable}" -c \'{SAY}\' "{path}" {redirection}'
    process = subprocess.run(
        ["bash", "-c", f"set -o pipefail; {command}"],
        cwd=ROOT,
        env={**os.environ, **environment},
        capture_output=True,
        timeout=PATIENCE,
        check=False,
    )
    return process.returncode, process.stdout, process.stderr


@pytest.mark.parametrize("redirection", ["2>&-", ">&-", "0<&- >&- 2>&-", "2>/dev/full >/dev/full"])
def test_an_unwritable_stream_does_not_end_the_process(tmp_path, redirection):
    assert outcome(redirection, tmp_path / "file")[0] == 0
    assert (tmp_path / "file").read_bytes() == b""


def test_a_pipe_without_a_reader_does_not_end_the_process(tmp_path):
    assert outcome("2>&1 | true", tmp_path / "file")[0] == 0


def test_characters_missing_in_the_terminal_are_shown_as_numbers(tmp_path):
    status, out, err = outcome("", tmp_path / "file", PYTHONIOENCODING="latin-1")
    assert status == 0
    for text in (out, err):
        assert "µ\\u2081 \\u2264 \\u03c4".encode("latin-1") in text.splitlines()


WAIT = """
import sys
from elastomer_friction.workflow.system import make_streams_tolerant
make_streams_tolerant()
print("said", file=sys.stderr)
sys.stdin.read()
"""


@pytest.mark.parametrize("unbuffered", ["", "1"])
def test_a_line_on_stderr_appears_at_once(unbuffered):
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
def test_the_program_has_the_name_of_its_command(monkeypatch, called, name):
    monkeypatch.setattr(sys, "argv", [called, "plan"])
    assert program() == name


def test_the_first_signal_requests_a_stop_and_a_later_one_aborts(clock, capsys):
    numbers = signal.SIGINT, signal.SIGTERM, signal.SIGHUP
    handlers = [signal.getsignal(number) for number in numbers]
    with Interrupt() as interrupt:
        assert not interrupt()
        signal.raise_signal(signal.SIGTERM)
        clock[0] += 0.01
        signal.raise_signal(signal.SIGINT)
        assert interrupt()
        clock[0] += 10.0
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)
    assert capsys.readouterr().err.count("\n") == 1
    assert [signal.getsignal(number) for number in numbers] == handlers


def test_a_hangup_requests_a_stop_unless_nohup_ignores_it(capsys):
    before = signal.signal(signal.SIGHUP, signal.SIG_DFL)  # the tests may run under nohup
    try:
        with Interrupt() as interrupt:
            signal.raise_signal(signal.SIGHUP)
            assert interrupt()
        signal.signal(signal.SIGHUP, signal.SIG_IGN)
        with Interrupt() as interrupt:
            signal.raise_signal(signal.SIGHUP)
            assert not interrupt()
    finally:
        signal.signal(signal.SIGHUP, before)
    assert "stopping" in capsys.readouterr().err


FAULTS = """
import resource
import numpy as np
from elastomer_friction.workflow.system.process import keep_memory
if {keep}:
    assert keep_memory()
for _ in range(50):
    before = resource.getrusage(resource.RUSAGE_SELF).ru_minflt
    a = [np.ones(1_000_000) for _ in range(5)]  # 40 MB, in arrays of 8
    del a
    print(resource.getrusage(resource.RUSAGE_SELF).ru_minflt - before)
"""


@pytest.mark.skipif(sys.platform != "linux", reason="the GNU C library alone has this setting")
def test_memory_of_large_arrays_stays_in_the_process():
    def faults(keep, **environment):
        """Return the page faults of the last of many rounds, with or without keeping memory."""
        return int(printed("-c", FAULTS.format(keep=keep), **environment).split()[-1])

    assert faults(keep=True, MALLOC_TRIM_THRESHOLD_="65536") < 10  # as dask sets it for workers
    assert faults(keep=False, MALLOC_TRIM_THRESHOLD_="65536") > 1000


def test_the_maker_lists_everything_that_numbers_depend_on():
    versions = this_maker().versions
    assert versions.startswith(f"python {platform.python_version()}, ")
    for name in ("numpy", "numba", "llvmlite"):
        assert f"{name} {version(name)}" in versions.split(", ")
    assert this_maker().processor == processor()
    assert {"numpy", "numba", "scipy", "dask", "distributed", "xarray", "netCDF4"} == set(PACKAGES)


def test_the_processor_has_a_name_without_proc_too(monkeypatch):
    assert processor()

    def refuse(*_, **__):
        raise OSError

    monkeypatch.setattr(Path, "read_text", refuse)
    assert processor() == (platform.processor() or platform.machine())
