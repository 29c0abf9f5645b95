"""How tests are spread over processes, and one local cluster for all that compute in one."""

import os
from collections.abc import Iterator

import dask
import pytest
from distributed import LocalCluster
from hypothesis import settings

from tests.last_bit import perturb
from tests.support import skips

perturb()
settings.register_profile("usual", deadline=None)  # no test depends on the speed of the machine
settings.register_profile("exhaustive", settings.get_profile("usual"), max_examples=1000)
settings.load_profile("usual")

# What takes longest comes first, so that no process is left alone with it in the end.
ORDER = ("studies", "workflow/run", "workflow/cluster", "hard", "workflow", "independent")


def pytest_configure(config: pytest.Config) -> None:
    """Let CI fail on a skip that is not on its list."""
    skips.register(config)


def pytest_xdist_auto_num_workers() -> int:
    """Return the number of processes: one per core, at least two, at most eight of up to 1 GB."""
    cores = os.sched_getaffinity(0) if hasattr(os, "sched_getaffinity") else (os.cpu_count(),)
    return min(8, max(2, len(cores)))


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Keep the tests of a file, or of a group, in one process: they share their fixtures."""
    folder = config.rootpath / "tests"

    def place(item: pytest.Item) -> int:
        path = item.path.relative_to(folder).as_posix()
        return next((i for i, name in enumerate(ORDER) if path.startswith(name)), len(ORDER))

    for item in items:
        if item.get_closest_marker("xdist_group") is None:
            item.add_marker(pytest.mark.xdist_group(f"{item.path.parent.name}/{item.path.stem}"))
    items.sort(key=place)


@pytest.fixture(scope="session")
def local() -> Iterator[LocalCluster]:
    """Return a scheduler with two workers, threads that need no start of their own.

    They talk as processes do; what processes alone can show, starts its own.
    """
    threads = {"processes": False, "protocol": "tcp", "dashboard_address": ":0"}
    with (
        dask.config.set({"distributed.scheduler.worker-ttl": None}),  # some tests stop the clock
        LocalCluster(n_workers=2, threads_per_worker=1, **threads) as local,
    ):
        yield local


@pytest.fixture(scope="session")
def scheduler(local: LocalCluster) -> str:
    """Return the address of a scheduler with two workers."""
    return str(local.scheduler_address)
