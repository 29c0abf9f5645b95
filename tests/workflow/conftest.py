"""One finished run of the small study, and a client of the cluster of all tests."""

import json
from collections.abc import Iterator

import dask
import pytest
from distributed import Client

from tests.workflow.runs import Run, run
from workflow.cluster import client as opening
from workflow.plan import machine
from workflow.plan.cost import TYPICAL


@pytest.fixture(scope="session", autouse=True)
def no_commit() -> Iterator[None]:
    """Hide git: files are compared byte for byte, and someone may commit during the tests."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("GIT_DIR", "/nowhere")
        yield


@pytest.fixture(scope="session", autouse=True)
def typical_machine(tmp_path_factory) -> Iterator[None]:
    """Predict with the timings of a typical machine: nothing is measured."""
    file = tmp_path_factory.mktemp("machine") / "timings.json"
    known = {"machine": "a typical machine", "date": "2020-01-01", "timings": TYPICAL._asdict()}
    file.write_text(json.dumps(known), encoding="utf-8")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(machine, "timings_file", lambda: file)
        yield


@pytest.fixture
def impatient(monkeypatch) -> Iterator[None]:
    """Give up soon where no scheduler answers."""
    monkeypatch.setattr(opening, "CONNECT_SECONDS", 0.2)
    # A client of dask that cannot connect leaves itself behind as the one to compute with.
    with dask.config.set(scheduler=None):
        yield


@pytest.fixture(scope="session")
def client(scheduler) -> Iterator[Client]:
    """Return a client of the scheduler."""
    with Client(scheduler) as client:
        yield client


@pytest.fixture(scope="session")
def finished(scheduler, tmp_path_factory) -> Run:
    """Return the small study run on two workers. Leave its folder as it is."""
    return run(scheduler, tmp_path_factory.mktemp("finished"))
