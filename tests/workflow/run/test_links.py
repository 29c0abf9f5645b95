"""Whoever may write to a folder of results can put links and pipes there: none is opened."""

import os

import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.run.status import read_status, status_file
from elastomer_friction.workflow.store import journal
from elastomer_friction.workflow.store.store import store_folder
from elastomer_friction.workflow.system.durable_files import (
    MAX_FILE_BYTES,
    read_whole,
    write_durably,
)
from elastomer_friction.workflow.system.lock import LOCK, holder
from tests.support.commands import refusal
from tests.support.runs import run
from tests.support.small import small_study, write_study

OURS = b"a file of ours that nobody is to change"


@pytest.fixture
def folder(tmp_path):
    """Return a folder for results with an empty store."""
    store_folder(tmp_path / "small.nc").mkdir()
    return tmp_path


def linked(path):
    """Put a link in a place; return the file of ours that it leads to."""
    ours = path.with_name("ours")
    ours.write_bytes(OURS)
    path.symlink_to(ours)
    return ours


@pytest.mark.parametrize("place", [f"store/{LOCK}", f"store/{journal.NAME}", "small.nc"])
@pytest.mark.parametrize("there", [True, False])
def test_a_run_refuses_a_link_and_leaves_what_it_leads_to(folder, place, there):
    ours = linked(folder / place)
    if not there:
        ours.unlink()  # a link may also make a file elsewhere
    with pytest.raises(UserError, match=r"it is a link$"):
        run(folder)
    assert not there or ours.read_bytes() == OURS
    assert ours.exists() is there


@pytest.mark.parametrize("command", ["table", "figure"])
def test_a_result_that_is_a_link_is_not_shown(folder, capsys, command):
    linked(folder / "small.nc")
    said = refusal(capsys, command, write_study(folder), "--out", str(folder))
    assert "small.nc: is a symbolic link, which is not opened" in said


def test_a_file_is_written_beside_a_link_with_the_name_of_its_unfinished_one(folder):
    ours = linked(folder / f".new.{os.getpid()}.tmp")
    write_durably(folder / "new", b"new")
    assert (folder / "new").read_bytes() == b"new"
    assert ours.read_bytes() == OURS


def test_a_status_and_a_lock_are_not_read_through_a_link_or_a_pipe(folder):
    result, study = folder / "small.nc", small_study()
    run(folder)
    for path in (status_file(result), store_folder(result) / LOCK):
        path.rename(path.with_name("moved"))
        path.symlink_to("moved")
        assert read_status(study, result, store_folder(result)).state == "not running"
        assert holder(store_folder(result)) is None
        path.unlink()
        os.mkfifo(path)  # to open one waits for whoever writes
        assert read_status(study, result, store_folder(result)).state == "not running"
        assert holder(store_folder(result)) is None


@pytest.mark.parametrize("place", [f"store/{LOCK}", f"store/{journal.NAME}", "small.nc"])
def test_a_run_refuses_a_pipe_at_once(folder, place):
    os.mkfifo(folder / place)
    with pytest.raises(UserError, match=r"it is not a regular file|No such device"):
        run(folder)


def test_a_file_is_read_as_a_whole_up_to_a_stated_size_and_no_device(folder):
    with (folder / "vast").open("wb") as file:
        file.truncate(MAX_FILE_BYTES + 1)  # of a size that takes no room
    for path, why in ((folder / "vast", MAX_FILE_BYTES), (os.devnull, "it is not a regular file")):
        with pytest.raises(UserError, match=f"cannot be read: .*{why}"):
            read_whole(path)
