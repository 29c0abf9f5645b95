"""A network that fails: the cable of a worker on a host of its own (a namespace) is pulled out."""

import os
import shutil
import subprocess
import time

import pytest
from distributed import Client

from tests.cluster.processes import PATIENCE, end, free_port, start_scheduler, start_worker

pytestmark = pytest.mark.cluster

NET = os.getpid() % 250  # two suites may run at once
HERE, THERE = f"10.199.{NET}.1", f"10.199.{NET}.2"
CABLE = f"ef{os.getpid()}"  # its end here


def ip(*words, check=True):
    """Run the command ``ip``; return whether it did what it was told."""
    return subprocess.run(("ip", *words), check=check, capture_output=True).returncode == 0


class OtherHost:
    """A network namespace that is there, joined to this host by one cable."""

    name = f"elastomer-{os.getpid()}"

    def __init__(self):
        ip("link", "add", CABLE, "type", "veth", "peer", "name", "ef1", "netns", self.name)
        ip("addr", "add", f"{HERE}/24", "dev", CABLE)
        ip("-n", self.name, "addr", "add", f"{THERE}/24", "dev", "ef1")
        ip("link", "set", CABLE, "up")
        for device in ("lo", "ef1"):
            ip("-n", self.name, "link", "set", device, "up")

    def cable(self, state):
        """Pull the cable out ("down") or put it in again ("up")."""
        ip("-n", self.name, "link", "set", "ef1", state)


@pytest.fixture(scope="module")
def host():
    """Return the other host."""
    if shutil.which("ip") is None or not ip("netns", "add", OtherHost.name, check=False):
        pytest.skip("no network namespaces: only root can make them, with the command ip")
    yield OtherHost()
    ip("netns", "delete", OtherHost.name)


@pytest.fixture(scope="module")
def address(host, tmp_path_factory):
    """Return the address of a scheduler with a worker here and one on the other host."""
    logs, port = tmp_path_factory.mktemp("logs"), free_port()
    address = f"tcp://{HERE}:{port}"
    there = ("ip", "netns", "exec", host.name)
    processes = [start_scheduler(logs / "scheduler.log", port, HERE)]
    processes.append(start_worker(logs / "here.log", address))
    processes.append(start_worker(logs / "there.log", address, before=there))
    yield address
    for process in processes:
        end(process)


@pytest.mark.parametrize("seconds", [8.0, None], ids=["for a while", "for good"])
def test_a_worker_is_cut_off_during_a_run(host, address, tried, tmp_path, undisturbed, seconds):
    """For good: the scheduler gives it up by its worker-ttl; another one computes its batches."""
    with Client(address, timeout=PATIENCE, set_as_default=False) as client:
        client.wait_for_workers(2, timeout=PATIENCE)
    trial = tried(tmp_path, "--scheduler", address, stopping=True)
    trial.wait_for_its_stop()
    host.cable("down")
    trial.go_on()
    if seconds is not None:
        time.sleep(seconds)
        host.cable("up")
    assert trial.whole() == undisturbed
