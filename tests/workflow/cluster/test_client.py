"""Where batches run: a scheduler that is there, or single-threaded processes of our own."""

import asyncio
import contextlib
import os
import signal
import socket
import urllib.error
import urllib.request
from pathlib import Path
from typing import NamedTuple

import dask
import pytest
from distributed import Client, SpecCluster

from elastomer_friction.workflow.cluster import client as module
from elastomer_friction.workflow.cluster.client import open_client
from elastomer_friction.workflow.cluster.watch import BEAT_SECONDS, QUIET_SECONDS
from elastomer_friction.workflow.run.grid_run import run_plan
from elastomer_friction.workflow.run.workers import RunOptions
from elastomer_friction.workflow.study.cluster import Cluster
from elastomer_friction.workflow.system import Interrupt
from tests.support.own_workers import facts, processes, started_again, starting
from tests.support.small import small_plan


def written(security, folder):
    """Write certificate and key of a cluster into files; return the keys of [cluster] for them."""
    certificate, key = folder / "certificate.pem", folder / "key.pem"
    certificate.write_text(security.tls_client_cert)
    key.write_text(security.tls_client_key)
    files = (certificate, certificate, key)
    return dict(zip(("tls_ca_file", "tls_cert", "tls_key"), map(str, files), strict=True))


def listening(pids):
    """Return the TCP ports at which processes listen."""
    inodes = set()
    for pid in pids:
        for entry in Path(f"/proc/{pid}/fd").iterdir():
            with contextlib.suppress(OSError):
                inodes.add(str(entry.readlink()).removeprefix("socket:[").removesuffix("]"))
    rows = [line.split() for line in Path("/proc/net/tcp").read_text().splitlines()[1:]]
    rows += [line.split() for line in Path("/proc/net/tcp6").read_text().splitlines()[1:]]
    return {
        int(row[1].rpartition(":")[2], 16) for row in rows if row[3] == "0A" and row[9] in inodes
    }


class Own(NamedTuple):
    """A worker of our own, and what was here before it was."""

    client: Client
    ports: set[int]
    handler: object  # of Ctrl-C


@pytest.fixture(scope="module")
def own():
    """Return a worker of our own, started in silence: a warning would be an error."""
    before = listening([os.getpid()]), signal.getsignal(signal.SIGINT)
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
    with pytest.raises(urllib.error.HTTPError) as refused:
        urllib.request.urlopen(f"http://127.0.0.1:{port}{path}", timeout=10.0)
    refused.value.close()
    return refused.value.code


def test_every_port_of_our_own_processes_asks_for_a_certificate_or_has_no_page(own):
    workers = own.client.run(os.getpid)
    family = [os.getpid(), *workers.values()]
    nannies = [nanny.address for nanny in own.client.cluster.workers.values()]
    known = [own.client.scheduler.address, *workers, *nannies]
    assert len(set(known)) == 3
    assert all(address.startswith("tls://127.0.0.1:") for address in known)
    ports = {int(address.rpartition(":")[2]) for address in known}
    pages = listening(family) - own.ports - {8787} - ports
    assert len(pages) == 2  # of the scheduler and the worker
    paths = ("/", "/status", "/info/main/workers.html", "/json/counts.json", "/health", "/metrics")
    assert {status_of(port, path) for port in pages for path in paths} == {404}


def test_workers_of_our_own_give_the_same_bytes_to_who_has_a_certificate(own, finished, tmp_path):
    where = Cluster(own.client.scheduler.address, **written(own.client.security, tmp_path))
    path = tmp_path / "small.nc"
    run_plan(small_plan(), path, RunOptions(where, batch_seconds=3.0))
    assert path.read_bytes() == finished.path.read_bytes()


def test_ctrl_c_while_workers_start_is_heard(monkeypatch):
    class Disturbed(SpecCluster):
        def __init__(self, **how):
            os.kill(os.getpid(), signal.SIGINT)
            super().__init__(**how)

    monkeypatch.setattr(module, "SpecCluster", Disturbed)
    with Interrupt() as interrupt, open_client(Cluster(), 1) as client:
        assert interrupt()
        assert len(client.nthreads()) == 1  # the worker has not heard it
    assert signal.SIGINT not in signal.pthread_sigmask(signal.SIG_BLOCK, ())


@pytest.mark.exhaustive  # four processes, one after the other
def test_a_worker_that_is_started_again_is_set_up_as_the_first_one():
    """Whatever dask's own settings are."""
    with (
        dask.config.set({"distributed.nanny.pre-spawn-environ": {}}),
        open_client(Cluster(), 1) as client,
    ):
        ((pid, *_),) = client.run(facts).values()
        os.kill(pid, signal.SIGKILL)
        how = started_again(client, pid)
    assert_set_up(*how)


@pytest.mark.exhaustive  # seven processes, one after the other
def test_a_worker_that_is_killed_while_it_starts_again_is_replaced(monkeypatch):
    monkeypatch.setattr(module, "LOST_SECONDS", 1.0)
    monkeypatch.setattr(module, "AGAIN_SECONDS", 0.5)
    with open_client(Cluster(), 1) as client:
        ((pid, *_),) = client.run(facts).values()
        known = processes()  # other tests have workers too
        os.kill(pid, signal.SIGKILL)
        os.kill(starting(known), signal.SIGKILL)
        ignores_ctrl_c, _ = started_again(client, pid)
    assert ignores_ctrl_c


def test_a_scheduler_that_is_there_is_used_with_a_warning_where_anyone_may(scheduler, capsys):
    with open_client(Cluster(scheduler)) as client:
        assert client.scheduler.address == scheduler
        assert len(client.nthreads()) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert line.startswith(f"warning: --scheduler {scheduler}: neither encrypted nor authentic")


def test_after_ctrl_c_ten_seconds_are_never_waited():
    """One look to learn of it, some for who is quiet, then they are left behind."""
    quiet = BEAT_SECONDS + QUIET_SECONDS + BEAT_SECONDS
    assert quiet + module.CLOSE_SECONDS <= 8.0  # two are left for work


class Deaf:
    """Stands in for a process that does not end by itself."""

    async def kill(self, timeout, reason):
        self.timeout, self.reason = timeout, reason


def test_a_worker_process_of_our_own_is_not_waited_for_long():
    nanny = object.__new__(module.PromptNanny)
    nanny.process = Deaf()
    asyncio.run(nanny.kill(timeout=30.0, reason="test"))
    assert (nanny.process.timeout, nanny.process.reason) == (module.CLOSE_SECONDS, "test")


def test_a_thread_of_dask_may_begin_late():
    late = iter([AssertionError, AssertionError])

    def begin():
        for error in late:
            raise error
        return "begun"

    assert module.begun(begin) == "begun"
    late = iter([AssertionError] * module.TRIES)
    with pytest.raises(AssertionError):
        module.begun(begin)
