"""Writing a result file: whole or not at all, the same bytes for the same numbers."""

import errno
import os

import pytest
import xarray as xr

from workflow.errors import UserError
from workflow.result.netcdf import write_datasets


def test_file_is_reopened_as_it_was_with_comparisons_as_groups(tmp_path, dataset):
    path = tmp_path / "small.nc"
    write_datasets(path, {"": dataset, "coarse": dataset * 2.0})
    with xr.open_dataset(path) as again:
        xr.testing.assert_identical(again.load(), dataset)
    with xr.open_dataset(path, group="coarse") as group:
        xr.testing.assert_equal(group.load(), dataset * 2.0)
    assert list(tmp_path.iterdir()) == [path]


def test_same_numbers_give_the_same_bytes(tmp_path, dataset):
    for name in ("a.nc", "b.nc"):
        write_datasets(tmp_path / name, {"": dataset, "coarse": dataset})
    assert (tmp_path / "a.nc").read_bytes() == (tmp_path / "b.nc").read_bytes()


def test_curves_are_compressed(tmp_path, dataset):
    write_datasets(tmp_path / "small.nc", {"": dataset})
    with xr.open_dataset(tmp_path / "small.nc") as again:
        assert again.mu.encoding["zlib"]


@pytest.mark.parametrize("error", [OSError(errno.ENOSPC, "No space left"), RuntimeError("HDF")])
def test_failed_write_keeps_the_old_file_and_leaves_nothing(tmp_path, monkeypatch, error, dataset):
    def fail(_):
        raise error

    path = tmp_path / "small.nc"
    path.write_bytes(b"old")
    monkeypatch.setattr(os, "fsync", fail)
    with pytest.raises(UserError, match=r"small\.nc: cannot be written: "):
        write_datasets(path, {"": dataset})
    assert path.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [path]


def test_result_in_the_place_of_a_folder_is_reported(tmp_path, dataset):
    folder = tmp_path / "small.nc"
    folder.mkdir()
    with pytest.raises(UserError, match="cannot be written"):
        write_datasets(folder, {"": dataset})
    assert list(tmp_path.iterdir()) == [folder]


def test_result_in_a_folder_that_is_not_there_is_reported(tmp_path, dataset):
    with pytest.raises(UserError, match="cannot be written"):
        write_datasets(tmp_path / "nowhere" / "small.nc", {"": dataset})
