"""An address at which something else answers, or nobody: one line, and no waiting."""

import contextlib
import gc
import socket
import threading

import pytest
from distributed import Client, default_client

from elastomer_friction.workflow.cluster import client as module
from elastomer_friction.workflow.cluster.client import open_client
from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.study.cluster import Cluster
from tests.support.python import PATIENCE


@pytest.fixture
def terminal():
    """Return the port of something that greets whoever comes, as a secure shell does."""
    server = socket.create_server(("127.0.0.1", 0))

    def greet():
        with contextlib.suppress(OSError):  # until it is closed
            while True:
                end, _ = server.accept()
                with end:
                    end.sendall(b"SSH-2.0-OpenSSH_9.2p1 Debian-2+deb12u3\r\n")

    threading.Thread(target=greet, daemon=True).start()
    yield server.getsockname()[1]
    server.shutdown(socket.SHUT_RDWR)
    server.close()


def default():
    """Return the client that dask uses by itself, if there is one."""
    with contextlib.suppress(ValueError):
        return default_client()


def loops():
    """Return the threads of dask's loops."""
    return {thread for thread in threading.enumerate() if thread.name == "IO loop"}


def refused(address):
    """Assert that one line says that no scheduler is at an address, and that nothing is left."""
    usual, before = default(), loops()
    expected = f"^--scheduler {address}: no scheduler answers there$"
    with pytest.raises(UserError, match=expected) as error:
        open_client(Cluster(address)).__enter__()
    assert error.tb is not None  # it keeps what has been opened from being collected
    clients = [one for one in gc.get_objects() if type(one) is Client]
    assert {client.status for client in clients} <= {"closed", "running"}
    assert default() == usual
    for thread in loops() - before:
        thread.join(PATIENCE)  # of a slow machine it may just be ending
    assert loops() <= before


def test_no_scheduler_at_the_address(monkeypatch):
    monkeypatch.setattr(module, "CONNECT_SECONDS", 0.2)
    refused("tcp://127.0.0.1:1")


@pytest.mark.parametrize("address", ["nonsense", "foo://host:1", "tcp://127.0.0.1"])
def test_what_is_no_address_is_not_looked_for_in_the_network(monkeypatch, address):
    refused(address)


def test_another_service_is_refused(monkeypatch, terminal):
    monkeypatch.setattr(module, "CONNECT_SECONDS", 1.0)
    refused(f"tcp://127.0.0.1:{terminal}")


def test_who_takes_connections_and_says_nothing_is_not_waited_for(monkeypatch):
    monkeypatch.setattr(module, "MUTE_SECONDS", 0.5)
    with socket.create_server(("127.0.0.1", 0)) as server:
        refused(f"tcp://127.0.0.1:{server.getsockname()[1]}")
