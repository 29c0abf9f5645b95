"""Results on a full or a read-only disk: one line, and what was there stays."""

import shutil

import pytest

from tests.support.disks import fill, make_read_only, mounted
from tests.support.results import FILES, OLD, WRITTEN, assert_refused, call


@pytest.fixture
def disk(shown, tmp_path):
    """Return a disk with the small study and its finished result."""
    with mounted(tmp_path / "disk", "2m") as disk:
        for name in FILES:
            shutil.copy(shown / name, disk)
        yield disk


def test_a_full_disk_is_one_line_and_what_was_there_stays(capsys, disk):
    for kind in WRITTEN:
        (disk / f"small.{kind}").write_bytes(OLD)
    fill(disk)
    assert "cannot be written: No space left" in assert_refused(capsys, "figure", disk)
    before = (disk / "small.nc").read_bytes()
    waiting = "cluster.patience=0.5"  # s, for a disk that stays full
    status, _, err = call(capsys, "run", disk, "--set", waiting)
    assert status == 2
    assert "No space left" in err
    assert "Traceback" not in err
    assert (disk / "small.nc").read_bytes() == before


def test_a_read_only_disk_is_one_line(capsys, disk):
    make_read_only(disk)
    for command, *more in (("table",), ("run",)):
        assert "Read-only file system" in assert_refused(capsys, command, disk, *more)
    for reading in ("status", "plan"):
        assert call(capsys, reading, disk)[0] == 0
