"""Workers that end with what they compute: out of memory, a job or a node that is over."""

import contextlib
import os
import signal
import threading
import time
from pathlib import Path

import psutil
import pytest

from elastomer_friction.workflow.run.grid_run import run_plan
from elastomer_friction.workflow.run.workers import RunOptions
from elastomer_friction.workflow.simulate.realizations import block_means
from elastomer_friction.workflow.study.cluster import Cluster
from tests.cluster.processes import PATIENCE, Standing, kill, workers_of
from tests.support.python import ROOT
from tests.support.runs import run
from tests.support.small import small_plan

pytestmark = pytest.mark.cluster

GROUPS = Path("/sys/fs/cgroup/memory")  # version 1; version 2 has all in one
LIMIT = 400 * 2**20  # bytes; a worker needs half of it
MARKER = "FIRST_BATCH"


@pytest.fixture(scope="module")
def expected(tmp_path_factory):
    """Return the bytes of an undisturbed run."""
    return run(tmp_path_factory.mktemp("peace")).path.read_bytes()


@contextlib.contextmanager
def small_group(pids):
    """Give processes, and what they start from now on, so much memory together at most."""
    version_1 = GROUPS.is_dir()
    folder = (GROUPS if version_1 else GROUPS.parent) / f"elastomer-{os.getpid()}"
    limit = "memory.limit_in_bytes" if version_1 else "memory.max"
    try:
        folder.mkdir()
        (folder / limit).write_text(str(LIMIT))
    except OSError as error:
        with contextlib.suppress(OSError):
            folder.rmdir()
        pytest.skip(f"no control group of memory can be made here: {error}")
    for pid in pids:
        (folder / "cgroup.procs").write_text(str(pid))
    try:
        yield folder / ("memory.oom_control" if version_1 else "memory.events")
    finally:
        for pid in (folder / "cgroup.procs").read_text().split():
            (folder.parent / "cgroup.procs").write_text(pid)
        folder.rmdir()


def hungry(batch):
    """Run a batch, but take more memory than there is where there is little; elsewhere, later."""
    marker = Path(os.environ[MARKER])
    if "SMALL" in os.environ:
        marker.touch()
        assert len(bytearray(os.urandom(1)) * (2 * LIMIT)) == 2 * LIMIT
    while not marker.exists():
        time.sleep(0.05)
    return block_means(batch)


def kills(file):
    """Return how many processes of a control group were killed for want of memory."""
    rows = [line.split() for line in file.read_text().splitlines()]
    return int(dict(rows)["oom_kill"])


def test_what_runs_out_of_memory_on_one_node_is_computed_on_another(
    tmp_path, monkeypatch, expected
):
    monkeypatch.setenv(MARKER, str(tmp_path / "first"))
    cluster = Standing(tmp_path / "standing", worker_1={"SMALL": "yes"})
    nanny = psutil.Process(cluster.processes["worker-1"].pid)
    try:
        while len(cluster.workers()) < 2:
            time.sleep(0.1)
        family = [nanny.pid, *(child.pid for child in nanny.children(recursive=True))]
        with small_group(family) as events:
            actual = run(tmp_path, scheduler=cluster.address, work=hungry, batch_seconds=1e-3)
            assert kills(events) >= 1
            assert actual.summary.failures == []
            assert actual.path.read_bytes() == expected
            cluster.stop()
    finally:
        cluster.stop()


def outliving(batch):
    """Run a batch; it would take forever, once it has said where it is, if a marker is left."""
    for marker in Path(os.environ[MARKER]).glob("[0-9]"):
        with contextlib.suppress(FileNotFoundError):  # another batch was faster
            marker.rename(taken := marker.with_suffix(".taken"))
            place = f"{os.environ['SLURM_JOB_ID']} {os.environ['SLURMD_NODENAME']}"
            taken.with_suffix(".place").write_text(place)
            time.sleep(1e4)
    return block_means(batch)


def ended(slurm, job, node):
    """Ask SLURM to queue the job again: it refuses, as we ask it to. Then end it."""
    try:
        with pytest.raises(RuntimeError, match="presently disabled"):
            slurm.run("scontrol", "requeue", job)
    finally:
        slurm.run("scancel", job)


def without_controller(slurm, job, node):
    """Kill the job while its replacement cannot be submitted: for 12 s SLURM's controller is away.

    Every 5 s it is looked for whether workers have to be replaced.
    """
    nannies = [n for n in slurm.nannies() if n.environ()["SLURM_JOB_ID"] == job]
    slurm.stop_controller()
    for pid in [pid for nanny in nannies for pid in (nanny.pid, *workers_of(nanny))]:
        kill(pid, signal.SIGKILL)
    time.sleep(12.0)
    slurm.start_controller()


def lost_node(slurm, job, node):
    """Take the node away."""
    slurm.set_down(node)


@pytest.mark.parametrize(
    ("walltime", "ends"),
    [("00:30:00", [ended, without_controller, lost_node]), ("00:01:00", [])],
    ids=["job, controller, node", "walltime"],
)
def test_batches_outlive_their_jobs(slurm, tmp_path, monkeypatch, expected, walltime, ends):
    """The worker of a job retires well before its walltime, a minute being SLURM's least."""
    markers = tmp_path / "markers"
    markers.mkdir()
    variables = {MARKER: str(markers), "PYTHONPATH": str(ROOT)}  # its jobs import ``outliving``
    for name, value in {**slurm.environment, **variables}.items():
        monkeypatch.setenv(name, value)
    for number in range(max(len(ends), 1)):
        (markers / str(number)).touch()

    def strike():
        until = time.monotonic() + PATIENCE
        for number, end in enumerate(ends):
            place = markers / f"{number}.place"
            while time.monotonic() < until and not (place.is_file() and place.read_text()):
                time.sleep(0.1)
            end(slurm, *place.read_text().split())

    striking = threading.Thread(target=strike)
    striking.start()
    cluster = Cluster(**slurm.table | {"walltime": walltime}, where="slurm", patience=PATIENCE)
    path = tmp_path / "small.nc"
    summary = run_plan(small_plan(), path, RunOptions(cluster, batch_seconds=1e-3, work=outliving))
    striking.join()
    slurm.heal()
    assert not list(markers.glob("[0-9]"))
    assert summary.failures == []
    assert path.read_bytes() == expected
