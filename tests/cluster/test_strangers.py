"""Another user of the machine gets nowhere on any port that a run opens."""

import contextlib
import os
import time

import pytest

from tests.cluster.processes import (
    STUDY,
    end,
    free_port,
    ports_of,
    shards,
    start,
    start_scheduler,
    wait_while,
)
from tests.support.python import printed

pytestmark = [
    pytest.mark.cluster,
    pytest.mark.skipif(os.getuid() != 0, reason="only root can become another user"),
]

NOBODY = 65534
STRANGER = """
import asyncio, os, sys
from distributed import Client, Nanny, Scheduler, Worker
from distributed.comm import connect
from distributed.security import Security

async def probe(address, **arguments):
    '''Ask who is there, as a client of dask would before it sends any code.'''
    comm = await connect(address, timeout=60, **arguments)
    await comm.write({"op": "identity", "reply": True})
    return await asyncio.wait_for(comm.read(), 60)

forged = Security.temporary().get_connection_args("client")
os.setgroups([])
os.setgid(int(sys.argv[1]))
os.setuid(int(sys.argv[1]))
for port in sys.argv[2:]:
    for how, arguments in (("tcp", {}), ("tls", forged)):
        try:
            answer = asyncio.run(probe(f"{how}://127.0.0.1:{port}", **arguments))
            print("reached", answer.get("type"), "by", how)
        except Exception as error:
            print("refused", type(error).__name__)
"""


def strange(ports):
    """Return what another user comes to at ports of this machine, with a forged certificate too."""
    return printed("-c", STRANGER, NOBODY, *sorted(ports)).splitlines()


@contextlib.contextmanager
def underway(folder, *options, **environment):
    """Yield a long run that has stored something."""
    long = ("--set", "study.realizations=40000", "--batch-seconds", "0.2")
    words = (*STUDY, "--out", str(folder), *long, *options)
    driver = start(folder / "log", *words, **environment)
    try:
        wait_while(lambda: not shards(folder), driver, folder / "log")
        yield driver
    finally:
        end(driver)


def assert_refused(ports, count):
    """Assert that a stranger reaches nothing at so many ports."""
    assert len(ports) == count
    answers = strange(ports)
    assert len(answers) == 2 * count
    assert [line for line in answers if not line.startswith("refused")] == []


def test_a_stranger_would_reach_a_scheduler_without_certificates(tmp_path):
    """Or the tests below would show nothing."""
    port = free_port()
    scheduler = start_scheduler(tmp_path / "log", port)
    try:
        while port not in ports_of([scheduler.pid]):
            time.sleep(0.1)
        assert "reached Scheduler by tcp" in strange([port])
    finally:
        end(scheduler)


def test_a_stranger_reaches_no_process_of_a_run_on_this_machine(tmp_path):
    with underway(tmp_path, "--workers", "2") as driver:
        # A scheduler, two workers and their nannies; of these, nannies have no port for pages.
        assert_refused(ports_of([driver.pid]), 5 + 3)


def ports_with_jobs(driver, slurm):
    """Return the ports at which a run and its jobs listen."""
    return ports_of([driver.pid, *(nanny.pid for nanny in slurm.nannies())])


def test_a_stranger_reaches_no_process_of_jobs(slurm, tmp_path):
    with underway(tmp_path, *slurm.options(), **slurm.environment) as driver:
        # Of both jobs, of which one may have stored something before the other began.
        count = 1 + 2 * 2 + 1 + 2
        wait_while(lambda: len(ports_with_jobs(driver, slurm)) < count, driver, tmp_path / "log")
        assert_refused(ports_with_jobs(driver, slurm), count)
        keys = [path for path in (slurm.folder / "jobs").glob(".tls-*/*") if path.is_file()]
        assert len(keys) == 1
        assert {path.stat().st_mode & 0o777 for path in (*keys, keys[0].parent)} == {0o600, 0o700}
