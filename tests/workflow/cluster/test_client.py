"""Where batches run: a scheduler that is there, or single-threaded processes of our own."""

import contextlib
import logging
import os
import signal
import socket
import ssl
import struct
import urllib.error
import urllib.request
from typing import NamedTuple

import dask
import psutil
import pytest
from distributed import Client, LocalCluster

from elastomer_friction.workflow.cluster import client as module
from elastomer_friction.workflow.cluster.client import open_client
from elastomer_friction.workflow.run.grid_run import run_plan
from elastomer_friction.workflow.run.workers import RunOptions
from elastomer_friction.workflow.study.cluster import Cluster
from elastomer_friction.workflow.system import Interrupt
from tests.cluster.processes import ports_of, workers_of
from tests.support.own_workers import facts, started_again, starting
from tests.support.python import PATIENCE
from tests.support.small import small_plan


class Own(NamedTuple):
    """A worker of our own, and what was here before it was."""

    client: Client
    ports: set[int]
    handler: object  # of Ctrl-C


@pytest.fixture(scope="module")
def own():
    """Return a worker of our own, started in silence: a warning would be an error."""
    before = ports_of([os.getpid()]), signal.getsignal(signal.SIGINT)
    with socket.socket() as taken:
        with contextlib.suppress(OSError):  # taken already is just as good
            taken.bind(("", 8787))
            taken.listen()
        with (
            dask.config.set({"distributed.nanny.pre-spawn-environ": {}}),  # whatever dask's are
            open_client(Cluster(), 1) as client,
        ):
            yield Own(client, *before)


def assert_set_up(ignores_ctrl_c, environment):
    """Assert that a worker does not hear Ctrl-C, and that libraries start no threads there."""
    assert ignores_ctrl_c
    for library in ("OMP", "MKL", "OPENBLAS", "NUMBA"):
        assert environment[f"{library}_NUM_THREADS"] == "1"


def test_workers_of_our_own_are_processes_of_one_thread_that_do_not_hear_ctrl_c(own):
    assert signal.getsignal(signal.SIGINT) is own.handler
    assert list(own.client.nthreads().values()) == [1]
    ((pid, *how),) = own.client.run(facts).values()
    assert pid != os.getpid()
    assert_set_up(*how)


def status_of(port, path):
    """Return the status with which a port answers who asks for a page."""
    context = ssl.create_default_context()
    context.check_hostname, context.verify_mode = False, ssl.CERT_NONE
    address = f"https://127.0.0.1:{port}{path}"
    with pytest.raises(urllib.error.HTTPError) as refused:
        urllib.request.urlopen(address, timeout=PATIENCE, context=context)
    refused.value.close()
    return refused.value.code


def closes(port):
    """Return whether a port closes at once on who speaks no TLS, as a stranger's client of dask."""
    with socket.create_connection(("127.0.0.1", port), PATIENCE) as end:
        end.sendall(struct.pack("<QQ", 1, 8) + bytes(8))
        try:
            return end.recv(1) == b""
        except ConnectionResetError:
            return True


def test_every_port_of_our_own_processes_asks_for_a_certificate_or_has_no_page(own):
    workers = own.client.run(os.getpid)
    nannies = [nanny.address for nanny in own.client.cluster.workers.values()]
    known = [own.client.scheduler.address, *workers, *nannies]
    assert len(set(known)) == 3
    assert all(address.startswith("tls://127.0.0.1:") for address in known)
    ports = {int(address.rpartition(":")[2]) for address in known}
    pages = ports_of([os.getpid()]) - own.ports - {8787} - ports
    assert len(pages) == 2  # of the scheduler and the worker
    paths = ("/", "/status", "/info/main/workers.html", "/json/counts.json", "/health", "/metrics")
    assert {status_of(port, path) for port in pages for path in paths} == {404}
    assert all(closes(port) for port in pages | ports)


def test_workers_of_our_own_give_the_same_bytes_to_who_has_a_certificate(own, finished, tmp_path):
    files = dict.fromkeys(("tls_ca_file", "tls_cert", "tls_key"), own.client.security.tls_ca_file)
    where = Cluster(own.client.scheduler.address, **files)
    path = tmp_path / "small.nc"
    run_plan(small_plan(), path, RunOptions(where, batch_seconds=3.0))
    assert path.read_bytes() == finished.path.read_bytes()


def test_ctrl_c_while_workers_start_is_heard(monkeypatch):
    class Disturbed(LocalCluster):
        def __init__(self, *args, **how):
            os.kill(os.getpid(), signal.SIGINT)
            super().__init__(*args, **how)

    monkeypatch.setattr(module, "LocalCluster", Disturbed)
    with Interrupt() as interrupt, open_client(Cluster(), 1) as client:
        assert interrupt()
        assert len(client.nthreads()) == 1  # the worker has not heard it
    assert signal.SIGINT not in signal.pthread_sigmask(signal.SIG_BLOCK, ())


@pytest.mark.exhaustive  # seven processes, one after the other
def test_a_worker_that_is_killed_while_it_starts_again_is_replaced_and_set_up(monkeypatch):
    monkeypatch.setattr(module, "ADAPT_INTERVAL", "500ms")
    settings = {"distributed.deploy.lost-worker-timeout": 1.0}
    settings["distributed.nanny.pre-spawn-environ"] = {}  # whatever dask's are
    with dask.config.set(settings), open_client(Cluster(), 1) as client:
        ((pid, *_),) = client.run(facts).values()
        known = set(workers_of(psutil.Process()))  # other tests have workers too
        os.kill(pid, signal.SIGKILL)
        os.kill(starting(known), signal.SIGKILL)
        how = started_again(client, pid)
    assert_set_up(*how)


def test_a_scheduler_that_is_there_is_used_with_a_warning_where_anyone_may(scheduler, capsys):
    loggers = [logging.getLogger(f"distributed.{part}") for part in ("client", "scheduler")]
    for logger in loggers:
        logger.setLevel(logging.INFO)
    with open_client(Cluster(scheduler)) as client:
        assert client.scheduler.address == scheduler
        assert len(client.nthreads()) == 2
    assert not any(logger.isEnabledFor(logging.ERROR) for logger in loggers)  # of lost workers
    (line,) = capsys.readouterr().err.splitlines()
    assert line.startswith(f"warning: --scheduler {scheduler}: neither encrypted nor authentic")


def test_a_client_whose_scheduler_does_not_answer_counts_as_closed(scheduler, monkeypatch):
    """As one that is garbage-collected open may deadlock."""
    close = Client.close

    async def unanswered(self, timeout):
        await close(self, timeout)
        self.status = "closing"
        raise TimeoutError

    with open_client(Cluster(scheduler)) as client:
        monkeypatch.setattr(Client, "close", unanswered)
    assert client.status == "closed"
