"""A folder of results of version 0.3.0: it is read, and its records are computed anew beside it."""

import tarfile

import pytest

from elastomer_friction.workflow.cli import main
from elastomer_friction.workflow.store.merge import merge_into
from tests.support.python import ROOT

ARCHIVE = ROOT / "tests" / "resources" / "version-0.3.0.tar.xz"


@pytest.fixture
def old(tmp_path):
    """Return the folder, in which the study lies too."""
    with tarfile.open(ARCHIVE) as archive:
        archive.extractall(tmp_path, filter="data")
    return tmp_path


def told(folder, capsys):
    """Return what verify says of a folder: its first word of each line -> the rest."""
    assert main(["verify", str(folder)]) == 0
    return dict(line.split(maxsplit=1) for line in capsys.readouterr().out.splitlines())


def test_the_store_is_sound_and_is_taken_over(old, capsys):
    assert told(old, capsys)["records"] == "4 of 2 problems"
    target = old / "target" / "store"
    assert merge_into(old / "store", target) == [
        "taken over  1 of 1 shards, 4 records that are new"
    ]
    assert told(target.parent, capsys)["records"] == "4 of 2 problems"


def test_the_result_is_shown_with_a_note_and_written_anew(old, capsys):
    study, out = str(old / "small.toml"), ["--out", str(old)]
    note = f"note: {old / 'small.nc'}: was computed by another version of the program\n"
    assert main(["table", study, *out]) == 0
    assert note in capsys.readouterr().err
    assert main(["run", study, *out]) == 0
    assert "2 batches computed" in capsys.readouterr().out
    assert told(old, capsys)["records"] == "8 of 4 problems"
    assert main(["table", study, *out]) == 0
    assert note not in capsys.readouterr().err
    empty = old / "empty"
    assert main(["run", study, "--out", str(empty)]) == 0
    assert (empty / "small.nc").read_bytes() == (old / "small.nc").read_bytes()
