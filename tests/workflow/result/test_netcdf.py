"""Writing a result file: whole or not at all, the same bytes for the same numbers."""

import errno
import os
from dataclasses import replace

import numpy as np
import pytest
import xarray as xr

from elastomer_friction.workflow.errors import UserError
from elastomer_friction.workflow.result.netcdf import result_file, write_datasets
from tests.support.disks import fill, mounted
from tests.support.small import small_study


def test_file_is_reopened_as_it_was_with_comparisons_as_groups(tmp_path, dataset):
    path = tmp_path / "small.nc"
    write_datasets(path, {"": dataset, "coarse": dataset * 2.0})
    assert list(tmp_path.iterdir()) == [path]
    with xr.open_dataset(path) as again:
        xr.testing.assert_identical(again.load(), dataset)
        assert again.mu.encoding["zlib"]  # a curve
    with xr.open_dataset(path, group="coarse") as group:
        xr.testing.assert_equal(group.load(), dataset * 2.0)
    write_datasets(tmp_path / "again.nc", {"": dataset, "coarse": dataset * 2.0})
    assert (tmp_path / "again.nc").read_bytes() == path.read_bytes()


def test_a_result_opens_as_a_tree_and_its_curves_over_time_in_s(tmp_path, with_models):
    path = tmp_path / "small.nc"
    write_datasets(path, {"": with_models, "coarse": with_models, "fine": with_models})
    with xr.open_datatree(path) as tree:
        assert set(tree.children) == {"coarse", "fine"}
        assert tree.ds.coords["time_s"].attrs["units"] == "s"
        for group in (tree.ds, tree["coarse"].ds):
            assert {"time", "time_s", "speed_ratio", "q_max"} <= set(group.mu.coords)
            np.testing.assert_allclose(group.time_s, group.time * group.tau, rtol=1e-7)
            point = group.isel(velocity=0, roughness=0).squeeze()
            (line,) = point.mu.plot(x="time_s")
            assert line.get_xdata()[0] == 0.0


def test_results_of_a_scale_lie_beside_that_of_the_study(tmp_path):
    usual, wide = small_study(), replace(small_study(), scale="wide")
    assert result_file(tmp_path, usual) == tmp_path / "small.nc"
    assert result_file(tmp_path, wide) == tmp_path / "small-wide.nc"
    assert result_file(tmp_path / "mine.nc", wide) == tmp_path / "mine.nc"


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


def test_the_disk_itself_is_asked_why_where_hdf5_does_not_know(tmp_path, monkeypatch, dataset):
    def refuse(*_, **__):
        raise PermissionError(errno.EACCES, "Permission denied")

    monkeypatch.setattr(type(dataset), "to_netcdf", refuse)
    with pytest.raises(UserError, match=r"cannot be written: .*Permission denied") as error:
        write_datasets(tmp_path / "small.nc", {"": dataset})
    assert isinstance(error.value.__cause__, RuntimeError)  # which may pass
    with mounted(tmp_path / "disk", "64k") as disk:
        fill(disk)
        with pytest.raises(UserError, match=r"cannot be written: No space left on device$"):
            write_datasets(disk / "small.nc", {"": dataset})
    assert list(tmp_path.iterdir()) == [tmp_path / "disk"]


@pytest.mark.parametrize("place", ["folder", "nowhere/small.nc"])
def test_a_place_that_cannot_be_written_is_reported(tmp_path, dataset, place):
    (tmp_path / "folder").mkdir()
    with pytest.raises(UserError, match="cannot be written"):
        write_datasets(tmp_path / place, {"": dataset})
    assert list(tmp_path.iterdir()) == [tmp_path / "folder"]
