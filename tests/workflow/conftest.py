"""One local cluster for all tests, and one finished run of the small study."""

from collections.abc import Iterator

import dask
import pytest
from distributed import Client, LocalCluster

from tests.workflow.runs import Run, run
from workflow import cluster


@pytest.fixture(scope="session")
def scheduler() -> Iterator[str]:
    """Return the address of a scheduler with two worker processes."""
    with LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=":0"
    ) as local:
        yield local.scheduler_address


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
