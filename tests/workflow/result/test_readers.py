"""A result opened lazily while runs replace it: a reader sees one file, and blocks nobody."""

import os
import subprocess
import sys

import numpy as np
import pytest
import xarray as xr

from elastomer_friction.workflow.result.netcdf import write_datasets

# Says on every line it gets: two numbers of the file it opened first, read only now, and the
# largest mu_1 of the study and of its comparison in the file that is there now.
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
    """Return a result of few variables, which is quick to write."""
    return dataset[["mu", "mu_1", "mu_2"]]


@pytest.fixture
def ask(tmp_path, few):
    """Return a function that asks a reader in another process, which opened the result of run 1."""
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
    """Return the result of a run that differs from all others."""
    return {"": dataset * float(number), "coarse": dataset * -float(number)}


def test_a_reader_keeps_the_file_it_opened_and_sees_one_run_whole(tmp_path, few, ask, monkeypatch):
    largest = float(abs(few.mu_1).max())
    first = [float((few.mu - few.mu_2).sum()), float(few.mu_1.max())]
    seen = []

    def look(_):
        """Ask the reader when the file is written, and again when it has got its name."""
        *lazy, study, coarse = ask()
        np.testing.assert_allclose(lazy, first, rtol=1e-12)
        assert study == coarse  # of one and the same run
        seen.append(study / largest)

    monkeypatch.setattr(os, "fsync", look)
    for number in (2, 3):
        write_datasets(tmp_path / "small.nc", numbered(few, number))
    np.testing.assert_allclose(seen, [1.0, 2.0, 2.0, 3.0], rtol=1e-12)
    with xr.open_dataset(tmp_path / "small.nc") as last:
        xr.testing.assert_equal(last.load(), numbered(few, 3)[""])
