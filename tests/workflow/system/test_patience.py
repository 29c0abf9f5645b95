"""Errors of a disk that may pass: tried again, said at once, given up in the end."""

import errno
import os

import pytest

from elastomer_friction.workflow.errors import UserError
from elastomer_friction.workflow.system.durable import refused
from elastomer_friction.workflow.system.patience import GRACE_SECONDS, Patience

PASSING = ["EIO", "ESTALE", "EMFILE", "ENFILE", "ENOSPC", "EDQUOT", "ETIMEDOUT"]


class Disk:
    """A disk that refuses until a time of the clock, by an error."""

    def __init__(self, clock, path, until, error):
        self.clock, self.path, self.until, self.error = clock, path, until, error
        self.tried = []

    def __call__(self):
        self.tried.append(self.clock[0])
        with refused(self.path, "cannot be written:"):
            if self.clock[0] < self.until:
                raise self.error
        return "done"


def patience(clock, seconds, stop=lambda: False):
    """Return a patience whose waiting takes no time but that of the clock."""

    def sleep(duration):
        clock[0] += duration

    return Patience(seconds, stop, sleep)


def error(name):
    """Return an error of the disk."""
    number = getattr(errno, name)
    return OSError(number, os.strerror(number))


@pytest.mark.parametrize("name", PASSING)
def test_what_passes_is_tried_again_and_said_at_once(tmp_path, clock, capsys, name):
    disk = Disk(clock, tmp_path, clock[0] + 20.0, error(name))
    assert patience(clock, 600.0)(disk) == "done"
    said = capsys.readouterr().err
    words = f"cannot be written: {error(name).strerror}; tried again for 10.0 min at most"
    assert said == f"warning: {tmp_path}: {words}\n"
    gaps = [later - earlier for earlier, later in zip(disk.tried, disk.tried[1:], strict=False)]
    assert gaps[:4] == pytest.approx([0.1, 0.2, 0.4, 0.8])
    assert max(gaps) <= 10.0 + 1e-9


def test_hdf5_which_gives_no_reason_is_tried_again(tmp_path, clock):
    disk = Disk(clock, tmp_path, clock[0] + 1.0, RuntimeError("NetCDF: HDF error"))
    assert patience(clock, 60.0)(disk) == "done"


@pytest.mark.parametrize("name", ["EACCES", "EROFS", "ENOENT", "ENOTDIR"])
def test_what_does_not_pass_is_refused_at_once(tmp_path, clock, capsys, name):
    disk = Disk(clock, tmp_path, clock[0] + 1.0, error(name))
    with pytest.raises(UserError, match=f"cannot be written: {error(name).strerror}$"):
        patience(clock, 600.0)(disk)
    assert len(disk.tried) == 1
    assert capsys.readouterr().err == ""


def test_without_patience_nothing_is_tried_twice(tmp_path, clock):
    disk = Disk(clock, tmp_path, clock[0] + 1.0, error("EIO"))
    with pytest.raises(UserError, match=r"cannot be written: Input/output error$"):
        Patience()(disk)
    assert len(disk.tried) == 1


def test_it_ends_and_what_follows_is_tried_once_until_the_disk_is_back(tmp_path, clock, capsys):
    began, waiting = clock[0], patience(clock, 300.0)
    with pytest.raises(UserError, match=r"No space left on device; given up after 5\.0 min$"):
        waiting(Disk(clock, tmp_path, began + 1e6, error("ENOSPC")))
    assert clock[0] - began == pytest.approx(300.0)
    assert capsys.readouterr().err.count("\n") == 5  # at once, after 30, 60, 120 and 240 s
    disk = Disk(clock, tmp_path, began + 1e6, error("ENOSPC"))
    with pytest.raises(UserError):
        waiting(disk)
    assert len(disk.tried) == 1
    assert waiting(lambda: "done") == "done"
    assert waiting(Disk(clock, tmp_path, clock[0] + 20.0, error("ENOSPC"))) == "done"


def test_who_is_to_stop_waits_for_a_moment_longer(tmp_path, clock):
    began = clock[0]
    waiting = patience(clock, 600.0, lambda: clock[0] > began + 40.0)
    with pytest.raises(UserError, match="given up after"):
        waiting(Disk(clock, tmp_path, began + 1e6, error("EIO")))
    assert clock[0] - began < 40.0 + GRACE_SECONDS + 1.0
