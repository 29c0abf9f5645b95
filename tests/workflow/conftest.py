"""One finished run of the small study, and a client of the cluster of all tests."""

import shutil
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from distributed import Client

from tests.support.powers import write_powers
from tests.support.results import FIGURE
from tests.support.runs import Run, run
from tests.support.small import write_study


@pytest.fixture
def clock(monkeypatch) -> list[float]:
    """Return the time, which passes when it is told to: clock[0] += seconds.

    In the thread of the tests alone: what the cluster of all tests puts off meanwhile would else
    wait until the machine has been on for as long.
    """
    now = [1e5]  # as long as the machine has been on: no duration may depend on it
    here, monotonic = threading.get_ident(), time.monotonic
    monkeypatch.setattr(
        time, "monotonic", lambda: now[0] if threading.get_ident() == here else monotonic()
    )
    return now


@pytest.fixture
def study(tmp_path) -> str:
    """Return the path of the small study."""
    return write_study(tmp_path)


@pytest.fixture
def powers(tmp_path, monkeypatch) -> Path:
    """Return the folder of a measured study, under studies/ of the working folder."""
    monkeypatch.chdir(tmp_path)
    return write_powers(tmp_path)


@pytest.fixture(scope="session")
def client(local) -> Iterator[Client]:
    """Return a client of the scheduler, in its thread: a new one must start within ten seconds."""
    with Client(local) as client:
        yield client


@pytest.fixture(scope="session")
def finished(tmp_path_factory) -> Run:
    """Return the small study run in this process. Leave its folder as it is."""
    return run(tmp_path_factory.mktemp("finished"))


@pytest.fixture
def shown(finished, tmp_path) -> Path:
    """Return a folder with the small study, its figure script and its finished result."""
    write_study(tmp_path)
    (tmp_path / "figure.py").write_text(FIGURE)
    shutil.copy(finished.path, tmp_path / "small.nc")
    return tmp_path
