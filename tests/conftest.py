"""Configuration of pytest: order of the tests, number of processes, and shared fixtures."""

import os
from collections.abc import Iterator

import dask
import pytest
from distributed import LocalCluster
from hypothesis import HealthCheck, settings

from tests.last_bit import perturb
from tests.support import skips
from tests.support.python import PATIENCE

perturb()
# Tests must not depend on the speed of the machine.
settings.register_profile("usual", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.register_profile("exhaustive", settings.get_profile("usual"), max_examples=1000)
settings.load_profile("usual")

# One process starts with the tests that compile most kernels, which only one process can do at a
# time; the others start with tests without kernels. The longest tests follow, the short ones last.
COMPILING = "studies/test_figures.py"
WITHOUT_KERNELS = tuple(
    f"workflow/{room}" for room in ("study", "store", "plan", "reduce", "laboratory", "system")
)
CLUSTERS = tuple(f"cluster/test_{name}.py" for name in ("trouble", "disk", "stops"))
WITH_KERNELS = ("studies", "workflow/run", "hard", "workflow", "independent")
ORDER = (COMPILING, *WITHOUT_KERNELS, *WITH_KERNELS, *CLUSTERS)


def pytest_configure(config: pytest.Config) -> None:
    """Let CI fail if a skipped test is not on its list."""
    config.pluginmanager.register(skips)


def pytest_xdist_auto_num_workers() -> int:
    """Return the number of processes: one per core, at least two, at most eight of up to 1 GB."""
    cores = os.sched_getaffinity(0) if hasattr(os, "sched_getaffinity") else (os.cpu_count(),)
    return min(8, max(2, len(cores)))


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Sort the tests by ORDER."""
    folder = config.rootpath / "tests"

    def place(item: pytest.Item) -> int:
        path = item.path.relative_to(folder).as_posix()
        return next((i for i, name in enumerate(ORDER) if path.startswith(name)), len(ORDER))

    items.sort(key=place)


@pytest.fixture(scope="session", autouse=True)
def no_commit() -> Iterator[None]:
    """Hide git: results contain the commit, which may change during the tests."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("GIT_DIR", "/nowhere")
        yield


@pytest.fixture(scope="session")
def local() -> Iterator[LocalCluster]:
    """Return a cluster with two workers, which are threads and so start quickly.

    They communicate by TCP as processes do; tests that need processes start their own. Without a
    memory limit workers do not pause because of the memory of the tests.
    """
    threads = {"processes": False, "protocol": "tcp", "dashboard_address": ":0", "memory_limit": 0}
    with (
        dask.config.set({"distributed.scheduler.worker-ttl": None}),  # some tests stop the clock
        LocalCluster(n_workers=2, threads_per_worker=1, **threads) as local,
    ):
        yield local


@pytest.fixture(scope="session")
def scheduler(local: LocalCluster) -> Iterator[str]:
    """Return the address of a scheduler with two workers; connections have a longer timeout."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("elastomer_friction.workflow.cluster.client.CONNECT_SECONDS", PATIENCE)
        yield str(local.scheduler_address)
