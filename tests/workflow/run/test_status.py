"""Status: what a run writes, brought up to date from the journal, or counted anew."""

import dataclasses
import json
import os
import shutil
import socket

import pytest

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.plan.batches import missing_work, total_records, total_seconds
from elastomer_friction.workflow.run.failures import Failures
from elastomer_friction.workflow.run.status import (
    Status,
    StatusWriter,
    check_owner,
    read_status,
    status_file,
    status_lines,
    study_digest,
)
from elastomer_friction.workflow.store.merge import merge_into
from elastomer_friction.workflow.store.store import Store, store_folder
from elastomer_friction.workflow.system.lock import hold
from tests.support.shards import BATCH, filled
from tests.support.small import cut_batches, random_result, small_plan, small_study

STUDY = small_study()
PLAN = small_plan()


@pytest.fixture
def place(tmp_path):
    """Return result path, store, and the writer of a run that has begun there."""
    result = tmp_path / "small.nc"
    folder = store_folder(result)
    folder.mkdir()
    store = Store(folder)
    store.begin(study_digest(STUDY))
    status = Status(study_digest(STUDY), PLAN.records, 0, 7200.0)
    return result, store, StatusWriter(result, folder, status, lambda: (5, 1800.0))


def read(place):
    """Return the status of the small study."""
    return read_status(STUDY, place[0], place[1].folder)


def written(place):
    """Return the status as it stands on the disk."""
    return json.loads(status_file(place[0]).read_text())


def test_a_run_does_not_replace_the_result_of_another_study(finished, tmp_path):
    study = finished.plan.study
    folder = shutil.copytree(finished.path.parent, tmp_path / "copy")
    result = folder / finished.path.name
    copy = dataclasses.replace(study, folder=tmp_path)  # a file of the same name elsewhere
    check_owner(copy, result)
    for old, new in (('"title": "small"', '"title": "other"'), ("0.03", "0.04")):
        edited = dataclasses.replace(study, text=study.text.replace(old, new))
        assert edited.text != study.text
        check_owner(edited, result)  # of the same file
        with pytest.raises(UserError, match="holds the result of another study, 'small'"):
            check_owner(dataclasses.replace(edited, folder=tmp_path), result)


def test_a_run_says_how_far_it_is_and_whether_it_was_killed(place):
    result, store, writer = place
    with hold(store.folder):
        writer.write(3, 2)
        lines, facts = status_lines(STUDY, result, store.folder)
    facts_of_running = facts["state"], facts["workers"], facts["batches_running"]
    assert lines[:5] == [
        "done        0 of 64 records (problem x block)",
        "running     2 batches on 3 workers",
        "waiting     64 records",
        "failed      0 problems",
        "remaining   2 core-hours, predicted",
    ]
    assert f"running, by process {os.getpid()} on {socket.gethostname()} since" in lines[5]
    assert facts_of_running == ("running", 3, 2)
    killed, facts = status_lines(STUDY, result, store.folder)
    assert killed[1] == "running     0 batches on 0 workers"
    assert killed[5].startswith("run         was killed, 20")
    assert (facts["state"], facts["workers"], facts["records_done"]) == ("was killed", 0, 0)


HOUR = dataclasses.replace(BATCH, seconds=3600.0)


def test_what_the_journal_got_since_is_counted_by_the_reader_and_the_writer(place):
    _, store, writer = place
    writer.write(3, 2)
    store.add([(HOUR, random_result(HOUR))])
    found = read(place)
    assert (found.done, found.failed) == (16, 0)
    assert found.left == pytest.approx(3600.0)
    assert written(place)["done"] == 0
    writer.end("interrupted")
    found = written(place)
    assert (found["done"], found["state"]) == (16, "interrupted")
    assert (found["workers"], found["running"]) == (0, 0)
    assert found["left"] == pytest.approx(3600.0)


def test_records_of_a_failed_problem_are_settled_for_the_reader_and_for_the_writer(place):
    _, store, writer = place
    store.record_failure(BATCH.tasks[0].key, "why")
    counted = read(place)
    missing = missing_work(PLAN, Failures(store, PLAN, 0))
    writer.extent = lambda: (PLAN.records - total_records(missing), total_seconds(missing))
    writer.end("interrupted")
    found = read(place)
    assert found.pid == os.getpid()  # from the file
    assert (counted.done, counted.failed) == (found.done, found.failed) == (4, 1)
    assert counted.left == found.left


def test_nothing_is_left_once_all_is_done_whatever_was_predicted(place):
    _, store, writer = place
    writer.status.total = 16
    writer.write(1, 1)
    store.add([(HOUR, random_result(HOUR))])
    assert read(place).left == 0.0


def test_a_status_that_cannot_be_written_is_said_once_and_ends_nothing(place, clock, capsys):
    result, _, writer = place
    status_file(result).mkdir()
    for _ in range(3):
        writer.write(1, 1)
        clock[0] += 10.0
    writer.end("finished")
    said = capsys.readouterr().err
    assert said.startswith(f"warning: {status_file(result)}: cannot be written: ")
    assert said.endswith("; the run continues\n")
    assert said.count("\n") == 1
    assert read(place).state == "not running"
    status_file(result).rmdir()
    writer.end("finished")
    assert written(place)["state"] == "finished"


def test_the_status_of_another_version_of_the_program_is_another(monkeypatch):
    before = study_digest(STUDY)
    monkeypatch.setattr("elastomer_friction.workflow.run.status.CODE_HASH", "0123456789abcdef")
    assert study_digest(STUDY) != before


def test_a_damaged_shard_is_counted_by_the_writer_and_the_reader(place, capsys):
    _, store, writer = place
    store.add([(BATCH, random_result(BATCH))])
    next(store.folder.glob("*.npz")).unlink()
    store.prepare()
    assert read(place).done == 0
    writer.write(1, 1)
    assert written(place)["done"] == 5
    assert "set aside" in capsys.readouterr().err
    store.add([(BATCH, random_result(BATCH, 1))])
    writer.end("running")
    assert written(place)["done"] == 5 + 16  # not counted anew


def merge(result, store):
    """Take over what is of no study that is known here."""
    other, _ = filled(result.parent / "other", [dataclasses.replace(BATCH, first_block=99)])
    merge_into(other.folder, store.folder)


SPOILT = {
    "a merge": merge,
    "no file": lambda result, store: status_file(result).unlink(),
    "half a file": lambda result, store: status_file(result).write_text('{"study": 1'),
    "another file": lambda result, store: status_file(result).write_text("{}"),
    "another run": lambda result, store: store.begin("another study"),
    "no journal": lambda result, store: (store.folder / "journal").write_bytes(b""),
}


@pytest.mark.parametrize("spoil", SPOILT.values(), ids=SPOILT)
def test_without_a_status_that_holds_records_are_counted(place, spoil):
    result, store, writer = place
    writer.status.done = 999
    writer.write(1, 1)
    spoil(result, store)
    found = read(place)
    assert found.done == 0
    expected = sum(batch.seconds for batch in cut_batches(PLAN, set()))
    assert 0.0 < found.left < 100.0 * expected  # rates are those of this machine


def test_rounds_may_take_more_than_was_foreseen(tmp_path):
    lines = Status("x", 64, 80, 0.0).lines(tmp_path / "small.nc", None)
    assert lines[0].startswith("done        80 of 80 records")
    assert lines[2:4] == ["waiting     0 records", "failed      0 problems"]


@pytest.mark.parametrize("number", [1, 2])
def test_what_no_run_has_written_nobody_runs(number):
    assert not Status("x", 64, 0, 0.0).runs(f"process {number} on here since 12:00")


@pytest.mark.parametrize(
    ("number", "host", "whose"), [(1, "a", True), (1, "ab", False), (21, "a", False)]
)
def test_whose_run_it_is_hangs_on_the_whole_of_process_and_host(number, host, whose):
    status = Status("x", 64, 0, 0.0, pid=1, host="a")
    assert status.runs(f"process {number} on {host} since 12:00") is whose


def test_other_settings_are_another_status_and_another_cluster_is_not(place):
    place[2].write(1, 1)
    other = small_study("study.seed=2")
    assert study_digest(other) != study_digest(STUDY)
    assert read_status(other, place[0], place[1].folder).study == study_digest(other)
    elsewhere = small_study('cluster.where="slurm"', "cluster.jobs=7")
    assert elsewhere.cluster.jobs == 7
    assert (study_digest(elsewhere), elsewhere.text) == (study_digest(STUDY), STUDY.text)


def test_it_is_written_every_few_seconds_only(place, clock, monkeypatch):
    writer, written = place[2], []
    monkeypatch.setattr(
        "elastomer_friction.workflow.run.status.write_durably", lambda *_: written.append(clock[0])
    )
    for _ in range(20):
        writer.write(1, 1)
        clock[0] += 1.0
    assert written == [clock[0] - 20.0 + wait for wait in (0.0, 5.0, 10.0, 15.0)]
