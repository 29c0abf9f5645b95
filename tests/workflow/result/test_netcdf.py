"""Result files: atomic writes, reproducible bytes, and readers during a write."""

import errno
import os
import shutil
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest
import xarray as xr

from elastomer_friction.workflow.ground import UserError
from elastomer_friction.workflow.result import netcdf
from elastomer_friction.workflow.result.netcdf import (
    REQUIRED_ATTRIBUTES,
    open_tree,
    result_file,
    write_datasets,
)
from tests.support.disks import fill, make_read_only, mounted
from tests.support.results import FILES, OLD, WRITTEN, assert_refused, call
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


def test_without_memory_for_hdf5_a_result_is_neither_written_nor_called_damaged(
    tmp_path, dataset, monkeypatch
):
    path = tmp_path / "small.nc"
    write_datasets(path, {"": dataset})
    before = path.read_bytes()
    monkeypatch.setattr(netcdf, "HDF5_BYTES", 2**62)
    with pytest.raises(MemoryError):
        open_tree(path)
    with pytest.raises(MemoryError):
        write_datasets(path, {"": dataset * 2.0})
    assert path.read_bytes() == before


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


def test_a_group_with_other_axis_values_opens_in_a_tree(tmp_path):
    path = tmp_path / "sphere.nc"
    required = dict.fromkeys(REQUIRED_ATTRIBUTES, "") | {"study": "{}"}
    sizes = {"": 4, "published": 3, "fine": 4}
    groups = {
        label: xr.Dataset(
            {"half_space": ("speed", np.arange(size) / 10.0)}, {"speed": np.arange(size) + 1.0}
        )
        for label, size in sizes.items()
    }
    write_datasets(path, groups | {"": groups[""].assign_attrs(required)})
    with open_tree(path) as tree:
        xr.testing.assert_equal(tree.to_dataset(), groups[""])
        xr.testing.assert_equal(tree["fine"].to_dataset(), groups["fine"])
        published = tree["published"].to_dataset(inherit=False)
        xr.testing.assert_equal(published.rename(published_speed="speed"), groups["published"])


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


def test_the_error_of_a_full_disk_is_reported_instead_of_that_of_hdf5(tmp_path, dataset):
    with mounted(tmp_path / "disk", "64k") as disk:
        fill(disk)
        with pytest.raises(UserError, match=r"cannot be written: No space left on device$"):
            write_datasets(disk / "small.nc", {"": dataset})


@pytest.mark.parametrize("place", ["folder", "nowhere/small.nc"])
def test_a_place_that_cannot_be_written_is_reported(tmp_path, dataset, place):
    (tmp_path / "folder").mkdir()
    with pytest.raises(UserError, match="cannot be written"):
        write_datasets(tmp_path / place, {"": dataset})
    assert list(tmp_path.iterdir()) == [tmp_path / "folder"]


# For every line of input, prints two numbers of the file opened first, read lazily, and the largest
# mu_1 of the study and of its comparison in the current file.
READER = """
import sys, dask, xarray as xr
with dask.config.set(scheduler="synchronous"), xr.open_dataset(sys.argv[1], chunks={}) as data:
    lazy = (data.mu - data.mu_2).sum()
    for _ in sys.stdin:
        groups = xr.open_groups(sys.argv[1])
        now = [float(abs(groups[g].mu_1).max()) for g in ("/", "/coarse")]
        print(float(lazy.compute()), float(data.mu_1.max()), *now, flush=True)
        for group in groups.values():
            group.close()
"""


@pytest.fixture
def few(dataset):
    """Return a result with few variables, which is quick to write."""
    return dataset[["mu", "mu_1", "mu_2"]]


@pytest.fixture
def ask(tmp_path, few):
    """Return a function that queries a reader process, which opened the result of run 1."""
    write_datasets(tmp_path / "small.nc", numbered(few, 1))
    words = [sys.executable, "-c", READER, str(tmp_path / "small.nc")]
    with subprocess.Popen(
        words, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as reader:

        def answer():
            reader.stdin.write("\n")
            reader.stdin.flush()
            return [float(word) for word in reader.stdout.readline().split()]

        yield answer
        reader.stdin.close()
    assert reader.returncode == 0


def numbered(dataset, number):
    """Return the result of a run, scaled by its number."""
    return {"": dataset * float(number), "coarse": dataset * -float(number)}


def test_a_reader_keeps_the_file_it_opened_and_sees_one_run_whole(tmp_path, few, ask, monkeypatch):
    largest = float(abs(few.mu_1).max())
    first = [float((few.mu - few.mu_2).sum()), float(few.mu_1.max())]
    largest_read = []

    def look(_):
        """Query the reader once the file is written, and again after the rename."""
        *lazy, study, coarse = ask()
        np.testing.assert_allclose(lazy, first, rtol=1e-12)
        assert study == coarse  # of the same run
        largest_read.append(study / largest)

    monkeypatch.setattr(os, "fsync", look)
    for number in (2, 3):
        write_datasets(tmp_path / "small.nc", numbered(few, number))
    np.testing.assert_allclose(largest_read, [1.0, 2.0, 2.0, 3.0], rtol=1e-12)
    with xr.open_dataset(tmp_path / "small.nc") as last:
        xr.testing.assert_equal(last.load(), numbered(few, 3)[""])


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
