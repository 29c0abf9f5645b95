"""One local cluster for all tests that compute."""

from collections.abc import Iterator

import pytest
from distributed import LocalCluster

from tests.last_bit import perturb

perturb()


@pytest.fixture(scope="session")
def scheduler() -> Iterator[str]:
    """Return the address of a scheduler with two worker processes."""
    with LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, dashboard_address=":0"
    ) as local:
        yield local.scheduler_address
