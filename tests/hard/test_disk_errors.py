"""Temporary disk errors in a real process: it retries, loses no record and renames no file."""

import os
import re
import subprocess
import sys
import time

import pytest

from elastomer_friction.workflow.store.store import Store
from tests.support.faults import TRUTH, checked, fill
from tests.support.faulty_disk import faulty_disk
from tests.support.python import PATIENCE, ROOT
from tests.support.shards import reopened

# For each input line "FOLDER PATIENCE write|read": store three shards in the folder, or only read
# them, with retries for PATIENCE seconds.
SCRIPT = """
import sys
from pathlib import Path
from tests.support.faults import TRUTH, checked, fill
from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.store.store import Store
from elastomer_friction.workflow.system import DiskRetry
for line in sys.stdin:
    folder, patience, what = line.split()
    try:
        store = Store(Path(folder), DiskRetry(float(patience)))
        store.prepare()
        if what == "write":
            fill(store)
        scalars, _ = store.read(list(TRUTH), 3)
        assert len(scalars) == len(TRUTH)
    except UserError as error:
        print(f"error: {error}", file=sys.stderr)
        sys.exit(2)
    print("over", file=sys.stderr)
"""
WRITING = ["write ENOSPC", "write EIO", "fsync EIO", "fsync ESTALE", "open EMFILE", "fsyncdir EIO"]
READING = ["read EIO", "open EMFILE", "open ESTALE"]


@pytest.fixture(scope="module")
def disk(tmp_path_factory):
    """Return a disk whose errors can be switched on."""
    return faulty_disk(tmp_path_factory.mktemp("disk"))


@pytest.fixture(scope="module")
def stores(tmp_path_factory):
    """Return the folders of the stores, by (write or read, fault)."""
    cases = [("write", fault) for fault in WRITING] + [("read", fault) for fault in READING]
    base = tmp_path_factory.mktemp("stores")
    folders = {case: base / f"{k}." for k, case in enumerate(cases)}  # no path is a prefix
    for folder in folders.values():
        folder.mkdir()
    return folders


def started(disk, *rules):
    """Return a process that runs SCRIPT with faults of the disk."""
    return subprocess.Popen(
        [sys.executable, "-c", SCRIPT],
        cwd=ROOT,
        env={**os.environ, **disk.environment(*rules)},
        stdin=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def tell(process, *words):
    """Send a line to a process."""
    print(*words, file=process.stdin, flush=True)


@pytest.fixture(scope="module")
def process(disk, stores):
    """Return a process with the fault of each store in its folder."""
    process = started(disk, *(f"{fault} {folder}" for (_, fault), folder in stores.items()))
    yield process
    process.kill()
    process.communicate(timeout=PATIENCE)


def after_a_while(disk, process, folder, mode):
    """Make the disk fail until the process has warned and 0.5 s longer; return its messages."""
    disk.flag.touch()
    tell(process, folder, 60, mode)
    message = process.stderr.readline()
    time.sleep(0.5)
    disk.flag.unlink()
    for line in iter(process.stderr.readline, "over\n"):
        assert line, message
        message += line
    return message


@pytest.mark.parametrize("fault", WRITING)
def test_what_waits_for_the_disk_is_stored_when_it_is_back(disk, process, stores, fault):
    store = stores["write", fault]
    message = after_a_while(disk, process, store, "write")
    assert re.match(
        r"warning: .*cannot be (written|read): .*; tried again for 60 s at most\n", message
    )
    assert checked(Store(store)) == TRUTH.keys()
    assert not list(store.glob("*.damaged"))
    assert len(list(store.glob("*.npz"))) == 3
    assert not list(store.glob(".*"))


@pytest.mark.parametrize("fault", READING)
def test_a_shard_that_cannot_be_read_for_a_while_is_no_damaged_one(disk, process, stores, fault):
    store = stores["read", fault]
    fill(reopened(store))
    message = after_a_while(disk, process, store, "read")
    assert "cannot be read:" in message
    assert checked(Store(store)) == TRUTH.keys()
    assert not list(store.glob("*.damaged"))


def test_a_full_disk_ends_it_with_one_error_once_patience_is_over(disk, tmp_path):
    process = started(disk, f"write ENOSPC {tmp_path}/. always")
    tell(process, tmp_path, 1, "write")
    _, message = process.communicate(timeout=PATIENCE)
    assert process.returncode == 2
    lines = message.splitlines()
    assert len(lines) == 2
    assert lines[0].endswith("No space left on device; tried again for 1 s at most")
    assert re.search(r"No space left on device; given up after \d+ s$", lines[1])
