"""A results folder of version 0.3.0: its store is converted once, and its records stay as written.

The program computes its own records anew beside them.
"""

import shutil
import tarfile

import netCDF4
import numpy as np
import pytest

from elastomer_friction.workflow.cli import main
from elastomer_friction.workflow.store.merge import merge_into
from elastomer_friction.workflow.store.shard import digest
from elastomer_friction.workflow.store.store import Store
from tests.support.faults import endless
from tests.support.python import ROOT
from tests.support.shards import held, reopened

ARCHIVE = ROOT / "tests" / "resources" / "version-0.3.0.tar.xz"
SHARD = "a8b4a41cf995f9e17b6cf603b827dc3c"


@pytest.fixture
def old(tmp_path):
    """Return the folder, which holds the study too."""
    with tarfile.open(ARCHIVE) as archive:
        archive.extractall(tmp_path, filter="data")
    return tmp_path


def verified(folder, capsys):
    """Return the report of verify on a folder: first word of each line -> the rest."""
    assert main(["verify", str(folder)]) == 0
    return dict(line.split(maxsplit=1) for line in capsys.readouterr().out.splitlines())


def records(store):
    """Return all records of a store and their numbers, NaN included, as bytes."""
    keys = sorted(held(store))
    return keys, *(values.tobytes() for values in store.read(keys, 100))


def test_a_run_converts_the_store_once_and_keeps_every_bit(old, capsys):
    assert verified(old, capsys)["note"].startswith("1 netCDF shards: the next run converts")
    with netCDF4.Dataset(old / "store" / f"{SHARD}.nc") as data:
        data.set_auto_maskandscale(False)
        scalars, curves = data["scalars"][:], data["curves"][:]
    store = reopened(old / "store")
    assert capsys.readouterr().err.endswith("converted 1 shards of version 0.3.0 to .npz\n")
    assert not list(store.folder.glob("*.nc"))
    rows = [store.index.find(record)[1] for record in sorted(held(store))]
    assert records(store)[1] == scalars[rows].tobytes()
    padded = np.pad(curves[rows], ((0, 0), (0, 100 - curves.shape[1])), constant_values=np.nan)
    assert records(store)[2] == padded.tobytes()
    again = reopened(old / "store")
    assert capsys.readouterr().err == ""
    assert records(again) == records(store)
    assert verified(old, capsys)["records"] == "4 of 2 problems"


def test_a_store_is_merged_as_it_is(old, capsys):
    target = old / "target" / "store"
    assert merge_into(old / "store", target) == ["merged      1 of 1 shards, 4 new records"]
    assert verified(target.parent, capsys)["records"] == "4 of 2 problems"
    assert merge_into(old / "store", target) == ["merged      0 of 1 shards, 0 new records"]
    assert (old / "store" / f"{SHARD}.nc").is_file()
    assert records(Store(target)) == records(reopened(old / "store"))


def end_before_the_journal(store):
    """Let the process end once the new shard is written."""

    def end(_):
        raise KeyboardInterrupt

    store._drop = end


def test_a_conversion_that_ends_half_way_is_completed_by_the_next_run(old):
    shutil.copytree(old / "store", old / "whole")
    store = Store(old / "store")
    end_before_the_journal(store)
    with pytest.raises(KeyboardInterrupt):
        store.prepare()
    assert {path.suffix for path in store.folder.iterdir()} == {".nc", ".npz", ""}
    assert records(reopened(old / "store")) == records(reopened(old / "whole"))


def cut(path):
    path.write_bytes(path.read_bytes()[:1000])


def without_end(path):
    path.write_bytes(endless(path.read_bytes()))


def in_single_precision(path):
    content = path.read_bytes()
    path.unlink()
    with netCDF4.Dataset("old.nc", memory=content) as old, netCDF4.Dataset(path, "w") as new:
        new.setncatts(old.__dict__)
        for name, dimension in old.dimensions.items():
            new.createDimension(name, dimension.size)
        for name, variable in old.variables.items():
            kind = "f4" if name == "curves" else variable.dtype
            new.createVariable(name, kind, variable.dimensions)[:] = variable[:]


@pytest.mark.parametrize("damage", [cut, without_end, in_single_precision])
@pytest.mark.parametrize("renamed", [True, False])
def test_a_damaged_shard_is_set_aside_or_left_out(old, capsys, damage, renamed):
    path = old / "store" / f"{SHARD}.nc"
    damage(path)
    if renamed:
        path = path.rename(path.with_stem(digest(path.read_bytes())))
    left_out, merged = merge_into(old / "store", old / "target")
    assert left_out.startswith(f"left out    {path.name}: ")
    assert merged == "merged      0 of 1 shards, 0 new records"
    capsys.readouterr()
    assert held(reopened(old / "store")) == set()
    assert f"warning: {path} is damaged" in capsys.readouterr().err
    assert not list((old / "store").glob("*.npz"))


def test_the_result_is_shown_with_a_note_and_written_again(old, capsys):
    study, out = str(old / "small.toml"), ["--out", str(old)]
    note = f"note: {old / 'small.nc'}: was computed by another version of the program\n"
    assert main(["table", study, *out]) == 0
    assert note in capsys.readouterr().err
    assert main(["run", study, *out]) == 0
    assert "2 batches computed" in capsys.readouterr().out
    assert verified(old, capsys)["records"] == "8 of 4 problems"
    assert main(["table", study, *out]) == 0
    assert note not in capsys.readouterr().err
    empty = old / "empty"
    assert main(["run", study, "--out", str(empty)]) == 0
    assert (empty / "small.nc").read_bytes() == (old / "small.nc").read_bytes()
