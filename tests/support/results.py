"""A result of the small study with a figure, and checks of the commands that read it."""

from pathlib import Path

import xarray as xr
from matplotlib import pyplot as plt

from elastomer_friction.workflow.cli import main
from elastomer_friction.workflow.result.netcdf import write_datasets
from tests.support.commands import besides_notes, refusal

FIGURE = """
from matplotlib.figure import Figure


def draw(groups):
    figure = Figure()
    figure.subplots().plot(groups[""].mu_1.values.ravel())
    return figure
"""
READERS = ("figure", "table")
WRITTEN = ("png", "pdf", "csv")  # suffixes of the files that READERS write
FILES = ("small.nc", "small.toml", "figure.py")
OLD = b"what was there before"


def call(capsys, command: str, folder: Path, *more: str) -> tuple[int, str, str]:
    """Run a command on the small study; return (exit status, stdout, stderr without notes)."""
    status = main([command, str(folder / "small.toml"), "--out", str(folder), *more])
    plt.close("all")
    out, err = capsys.readouterr()
    return status, out, "".join(f"{line}\n" for line in besides_notes(err))


def contents(folder: Path) -> dict[str, bytes]:
    """Return the bytes of all files in a folder by name, without those of its store."""
    return {path.name: path.read_bytes() for path in folder.iterdir() if path.is_file()}


def assert_refused(capsys, command: str, folder: Path, *more: str) -> str:
    """Assert exit status 2, one line on stderr, and unchanged files; return the line."""
    before = contents(folder)
    message = refusal(capsys, command, str(folder / "small.toml"), "--out", str(folder), *more)
    assert contents(folder) == before
    return message


def rewritten(folder: Path, change) -> None:
    """Replace the result by ``change`` of its dataset."""
    with xr.open_dataset(folder / "small.nc") as dataset:
        changed = change(dataset.load())
    write_datasets(folder / "small.nc", {"": changed})
