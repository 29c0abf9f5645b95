"""Where batches run: a scheduler that is there, or single-threaded processes of our own."""

import json
import os
import signal
import socket
import subprocess
import sys

import pytest

from tests.workflow.runs import PATIENCE, ROOT
from workflow.cluster.client import open_client
from workflow.study.cluster import Cluster

SCRIPT = """
import json, os, signal, sys
from workflow.cluster.client import open_client
from workflow.study.cluster import Cluster

def facts():
    return os.getpid(), signal.getsignal(signal.SIGINT) == signal.SIG_IGN, dict(os.environ)

if __name__ == "__main__":
    before = signal.getsignal(signal.SIGINT)
    with open_client(Cluster(), 2) as client:
        workers = list(client.run(facts).values())
        threads = list(client.nthreads().values())
    mine = signal.getsignal(signal.SIGINT) == before
    json.dump({"workers": workers, "threads": threads, "mine": mine}, sys.stdout)
"""


@pytest.fixture(scope="module")
def embedded(tmp_path_factory):
    """Return what a process with a cluster of its own says, while port 8787 is taken."""
    script = tmp_path_factory.mktemp("cluster") / "script.py"
    script.write_text(SCRIPT)
    # The cluster of the tests leaves its own settings in the environment of this process.
    environment = {k: v for k, v in os.environ.items() if not k.startswith("MALLOC_")}
    with socket.socket() as taken:
        taken.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            taken.bind(("", 8787))
            taken.listen()
        except OSError:  # taken already, just as good
            pass
        return subprocess.run(
            [sys.executable, str(script)],
            env={**environment, "PYTHONPATH": str(ROOT)},
            capture_output=True,
            text=True,
            timeout=PATIENCE,
            check=True,
        )


def test_workers_are_processes_of_one_thread(embedded):
    found = json.loads(embedded.stdout)
    assert found["threads"] == [1, 1]
    assert len({pid for pid, _, _ in found["workers"]}) == 2


def test_workers_leave_ctrl_c_to_the_driver(embedded):
    found = json.loads(embedded.stdout)
    assert [ignored for _, ignored, _ in found["workers"]] == [True, True]
    assert found["mine"]


def test_workers_keep_large_arrays_in_the_process(embedded):
    for _, _, environment in json.loads(embedded.stdout)["workers"]:
        assert int(environment["MALLOC_TRIM_THRESHOLD_"]) >= 2**28


def test_a_second_run_on_a_machine_starts_in_silence(embedded):
    assert "8787" not in embedded.stderr


def test_a_scheduler_that_is_there_is_used(scheduler):
    with open_client(Cluster(scheduler)) as client:
        assert client.scheduler.address == scheduler
        assert len(client.nthreads()) == 2


ADDRESSES = ["tcp://127.0.0.1:1", "nonsense", "foo://host:1", "tcp://127.0.0.1"]
PROBE = f"""
from workflow.cluster import client as clusters
from workflow.study.cluster import Cluster
from workflow.errors import UserError
clusters.CONNECT_SECONDS = 0.2
for address in {ADDRESSES!r}:
    try:
        clusters.open_client(Cluster(address)).__enter__()
    except UserError as error:
        print(error)
"""


def test_no_scheduler_at_the_address():
    # In a process of its own: a client of dask that cannot connect leaves itself behind.
    command = [sys.executable, "-c", PROBE]
    process = subprocess.run(
        command, cwd=ROOT, capture_output=True, text=True, timeout=PATIENCE, check=True
    )
    expected = [f"--scheduler {address}: no scheduler answers there" for address in ADDRESSES]
    assert process.stdout.splitlines() == expected


def test_own_handler_of_ctrl_c_is_put_back(scheduler):
    before = signal.getsignal(signal.SIGINT)
    with open_client(Cluster(scheduler)):
        assert signal.getsignal(signal.SIGINT) is before
