"""A result opened lazily while runs replace it: a reader sees one file, and blocks nobody."""

import subprocess
import sys
import threading

import numpy as np
import xarray as xr

from tests.support.curves import assembled
from workflow.result.netcdf import write_datasets

_, _, DATASET = assembled()
READER = """
import sys, dask, xarray as xr
with dask.config.set(scheduler="synchronous"), xr.open_dataset(sys.argv[1], chunks={}) as data:
    lazy = (data.mu - data.mu_2).sum()
    for _ in sys.stdin:
        print(float(lazy.compute()), float(data.mu_1.max()), flush=True)
"""


def numbered(number):
    """Return the result of a run that differs from all others."""
    return {"": DATASET * float(number), "coarse": DATASET * -float(number)}


def told(dataset):
    """Return what the reader computes of a dataset."""
    return float((dataset.mu - dataset.mu_2).sum()), float(dataset.mu_1.max())


def test_reader_in_another_process_keeps_the_file_it_opened(tmp_path):
    path = tmp_path / "small.nc"
    write_datasets(path, numbered(1))
    words = [sys.executable, "-c", READER, str(path)]
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "text": True}
    with subprocess.Popen(words, **pipes) as reader:
        for number in range(2, 7):
            reader.stdin.write("\n")
            reader.stdin.flush()
            found = [float(word) for word in reader.stdout.readline().split()]
            np.testing.assert_allclose(found, told(DATASET), rtol=1e-12)
            write_datasets(path, numbered(number))  # raises where a reader blocks it
        reader.stdin.close()
    assert reader.returncode == 0
    with xr.open_dataset(path) as last:
        xr.testing.assert_equal(last.load(), numbered(6)[""])


def test_every_reader_sees_one_run_whole(tmp_path):
    path = tmp_path / "small.nc"
    write_datasets(path, numbered(1))
    done = threading.Event()
    script = (
        "import sys, xarray as xr\n"
        "for _ in sys.stdin:\n"
        "    groups = xr.open_groups(sys.argv[1])\n"
        "    sums = [float(abs(groups[g].mu_1).max()) for g in ('/', '/coarse')]\n"
        "    print(*sums, flush=True)\n"
        "    [group.close() for group in groups.values()]\n"
    )
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "text": True}

    def write():
        for number in range(2, 14):
            write_datasets(path, numbered(number))
        done.set()

    largest = float(abs(DATASET.mu_1).max())
    seen = []
    with subprocess.Popen([sys.executable, "-c", script, str(path)], **pipes) as reader:
        writer = threading.Thread(target=write)
        writer.start()
        while not done.is_set() or not seen:
            reader.stdin.write("\n")
            reader.stdin.flush()
            root, coarse = map(float, reader.stdout.readline().split())
            assert root == coarse  # of one and the same run
            seen.append(root / largest)
        writer.join()
        reader.stdin.close()
    assert np.allclose(seen, np.round(seen), rtol=1e-12)
    assert seen == sorted(seen)
