"""Results on a full or a read-only disk: one line, and what was there stays."""

import shutil

import pytest

from tests.support.disks import fill, make_read_only, mounted
from tests.support.results import FILES, OLD, READERS, WRITTEN, assert_refused, call


@pytest.mark.parametrize("command", READERS)
def test_a_full_disk_is_one_line_and_what_was_there_stays(capsys, shown, tmp_path, command):
    with mounted(tmp_path / "disk", "2m") as disk:
        for name in FILES:
            shutil.copy(shown / name, disk)
        for kind in WRITTEN:
            (disk / f"small.{kind}").write_bytes(OLD)
        fill(disk)
        assert "cannot be written: No space left" in assert_refused(capsys, command, disk)


@pytest.mark.parametrize("command", [*READERS, "run"])
def test_a_read_only_disk_is_one_line(capsys, shown, tmp_path, scheduler, command):
    with mounted(tmp_path / "disk", "4m") as disk:
        for name in FILES:
            shutil.copy(shown / name, disk)
        make_read_only(disk)
        more = ("--scheduler", scheduler) if command == "run" else ()
        assert "Read-only file system" in assert_refused(capsys, command, disk, *more)
        for reading in ("status", "plan"):
            assert call(capsys, reading, disk)[0] == 0


def test_a_run_on_a_full_disk_keeps_the_old_result(capsys, shown, tmp_path, scheduler):
    with mounted(tmp_path / "disk", "1m") as disk:
        shutil.copy(shown / "small.toml", disk)
        (disk / "small.nc").write_bytes(OLD)
        fill(disk)
        status, _, err = call(capsys, "run", disk, "--scheduler", scheduler)
        assert status == 2
        assert "No space left" in err
        assert "Traceback" not in err
        assert (disk / "small.nc").read_bytes() == OLD
