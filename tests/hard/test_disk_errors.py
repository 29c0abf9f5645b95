"""Errors of the disk that pass, in a real process: it waits, loses nothing, renames nothing."""

import os
import re
import subprocess
import sys
import time

import pytest

from tests.support.faults import TRUTH, checked, fill
from tests.support.faulty_disk import faulty_disk
from tests.support.runs import PATIENCE, ROOT
from tests.support.shards import reopened
from workflow.store.store import Store

# Stores three shards and reads them again, with as much patience as it is told.
SCRIPT = """
import sys
from pathlib import Path
from tests.support.faults import TRUTH, checked, fill
from workflow.errors import UserError
from workflow.store.store import Store
from workflow.system import Patience
try:
    store = Store(Path(sys.argv[1]), Patience(float(sys.argv[2])))
    store.prepare()
    if sys.argv[3] == "write":
        fill(store)
    scalars, _ = store.read(list(TRUTH), 3)
    assert len(scalars) == len(TRUTH)
except UserError as error:
    print(f"error: {error}", file=sys.stderr)
    sys.exit(2)
"""
WRITING = ["write ENOSPC", "write EIO", "fsync EIO", "fsync ESTALE", "open EMFILE", "fsyncdir EIO"]
READING = ["read EIO", "open EMFILE", "open ESTALE"]


@pytest.fixture(scope="module")
def disk(tmp_path_factory):
    """Return a disk that refuses on demand."""
    return faulty_disk(tmp_path_factory.mktemp("disk"))


@pytest.fixture
def store(tmp_path):
    """Return the folder of a store."""
    (tmp_path / "store").mkdir()
    return tmp_path / "store"


def started(disk, folder, patience, what, *rules):
    """Return a process that works on the store in a folder."""
    return subprocess.Popen(
        [sys.executable, "-c", SCRIPT, str(folder), str(patience), what],
        cwd=ROOT,
        env={**os.environ, **disk.environment(*rules)},
        stderr=subprocess.PIPE,
        text=True,
    )


def after_a_while(disk, process):
    """Let the disk refuse until the process says so, then a moment longer; return what it said."""
    first = process.stderr.readline()
    time.sleep(0.5)
    disk.flag.unlink()
    _, rest = process.communicate(timeout=PATIENCE)
    assert process.returncode == 0, first + rest
    return first + rest


@pytest.mark.parametrize("fault", WRITING)
def test_what_waits_for_the_disk_is_stored_when_it_is_back(disk, store, fault):
    disk.flag.touch()
    said = after_a_while(disk, started(disk, store, 60, "write", f"{fault} {store}"))
    assert re.match(
        r"warning: .*cannot be (written|read): .*; tried again for 60 s at most\n", said
    )
    assert checked(Store(store)) == TRUTH.keys()
    assert not list(store.glob("*.damaged"))
    assert len(list(store.glob("*.nc"))) == 3
    assert not list(store.glob(".*"))


@pytest.mark.parametrize("fault", READING)
def test_a_shard_that_cannot_be_read_for_a_while_is_no_damaged_one(disk, store, fault):
    fill(reopened(store))
    disk.flag.touch()
    said = after_a_while(disk, started(disk, store, 60, "read", f"{fault} {store}"))
    assert "cannot be read:" in said
    assert checked(Store(store)) == TRUTH.keys()
    assert not list(store.glob("*.damaged"))


def test_a_full_disk_ends_it_with_one_error_once_patience_is_over(disk, store):
    process = started(disk, store, 1, "write", f"write ENOSPC {store}/. always")
    _, said = process.communicate(timeout=PATIENCE)
    assert process.returncode == 2
    lines = said.splitlines()
    assert len(lines) == 2
    assert lines[0].endswith("No space left on device; tried again for 1 s at most")
    assert lines[1].endswith("No space left on device; given up after 1 s")
