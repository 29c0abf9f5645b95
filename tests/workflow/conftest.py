"""One finished run of the small study, and a client of the cluster of all tests."""

from collections.abc import Iterator

import dask
import pytest
from distributed import Client

from tests.workflow.runs import Run, run
from workflow.cli import main as cli
from workflow.plan.cost import TYPICAL
from workflow.plan.machine import Calibration
from workflow.run import clusters as cluster


@pytest.fixture(scope="session", autouse=True)
def no_commit() -> Iterator[None]:
    """Hide git: files are compared byte for byte, and someone may commit during the tests."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("GIT_DIR", "/nowhere")
        yield


@pytest.fixture(scope="session", autouse=True)
def typical_machine() -> Iterator[None]:
    """Predict with the rates of a typical machine: nothing is measured."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(cli, "calibrated", lambda: Calibration(TYPICAL, "a typical machine"))
        yield


@pytest.fixture
def impatient(monkeypatch) -> Iterator[None]:
    """Give up soon where no scheduler answers."""
    monkeypatch.setattr(cluster, "CONNECT_SECONDS", 0.2)
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
