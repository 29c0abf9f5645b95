"""Where batches run: a scheduler that is there, or single-threaded processes of our own."""

import contextlib
import os
import signal
import socket

import dask
import pytest

from tests.support.runs import run
from workflow.cluster import client as module
from workflow.cluster.client import open_client
from workflow.errors import UserError
from workflow.study.cluster import Cluster


def facts():
    """Return what a worker says of itself."""
    return os.getpid(), signal.getsignal(signal.SIGINT) == signal.SIG_IGN, dict(os.environ)


def test_workers_of_our_own_are_processes_that_give_the_same_bytes(finished, tmp_path):
    before = signal.getsignal(signal.SIGINT)
    with socket.socket() as taken:
        with contextlib.suppress(OSError):  # taken already is just as good
            taken.bind(("", 8787))
            taken.listen()
        with open_client(Cluster(), 1) as client:  # in silence: a warning would be an error
            assert signal.getsignal(signal.SIGINT) is before
            ((pid, ignores_ctrl_c, environment),) = client.run(facts).values()
            assert list(client.nthreads().values()) == [1]
            assert pid != os.getpid()
            assert ignores_ctrl_c
            assert int(environment["MALLOC_TRIM_THRESHOLD_"]) >= 2**28  # large arrays are kept
            found = run(client.scheduler.address, tmp_path)
    assert found.path.read_bytes() == finished.path.read_bytes()


def test_a_scheduler_that_is_there_is_used(scheduler):
    with open_client(Cluster(scheduler)) as client:
        assert client.scheduler.address == scheduler
        assert len(client.nthreads()) == 2


@pytest.mark.parametrize(
    "address", ["tcp://127.0.0.1:1", "nonsense", "foo://host:1", "tcp://127.0.0.1"]
)
def test_no_scheduler_at_the_address(monkeypatch, address):
    monkeypatch.setattr(module, "CONNECT_SECONDS", 0.2)
    expected = f"^--scheduler {address}: no scheduler answers there$"
    # A client of dask that cannot connect leaves itself behind as the one to compute with.
    with dask.config.set(scheduler=None), pytest.raises(UserError, match=expected):
        open_client(Cluster(address)).__enter__()
