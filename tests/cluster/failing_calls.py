"""Runs in one process, in which each call to the disk fails, from the last call to the first.

Arguments: the library of faulty_disk.py, which is loaded by LD_PRELOAD, a new folder, and "each" or
"all", which is each call with both errors, alone and with all that follow.
"""

import ctypes
import errno
import shutil
import sys
from pathlib import Path

from elastomer_friction.workflow.cli import main
from tests.support.small import write_study

SETTINGS = ("study.realizations=4", "cluster.patience=0.01")
EVER = 2**31 - 1


def run(folder: Path) -> int | str | None:
    """Run the small study in this process; return the exit status."""
    settings = [word for setting in SETTINGS for word in ("--set", setting)]
    try:
        return main(["run", str(folder / "small.toml"), "--out", str(folder), *settings])
    except SystemExit as end:
        return end.code


def result(folder: Path) -> bytes:
    """Return the bytes of the result after a run that ends well."""
    assert run(folder) == 0
    return (folder / "small.nc").read_bytes()


class Calls:
    """The calls to the disk, which the library counts and fails."""

    def __init__(self, library: str) -> None:
        loaded = ctypes.CDLL(library)
        self.number, self.first, self.last = (
            ctypes.c_long.in_dll(loaded, f"disk_{name}") for name in ("calls", "first", "last")
        )
        self.error = ctypes.c_int.in_dll(loaded, "disk_errno")
        self.folder = (ctypes.c_char * 512).in_dll(loaded, "disk_counted")

    def fail(self, folder: Path | None, first: int = EVER, last: int = EVER, error: int = 0):
        """Fail calls number ``first`` to ``last`` below a folder, or none, from now on."""
        self.number.value, self.first.value, self.last.value = 0, first, last
        self.error.value = error
        self.folder.value = bytes(folder) if folder else b""


def fresh(folder: Path) -> Path:
    """Return a new folder with the small study."""
    folder.mkdir(parents=True)
    write_study(folder)
    return folder


def cases_of(total: int, which: str) -> list[tuple[int, int, int]]:
    """Return the cases as (first call, last call, error)."""
    kinds = [(error, ever) for ever in (False, True) for error in (errno.EIO, errno.ENOSPC)]
    chosen = {call: kinds if which == "all" else [kinds[call % 4]] for call in range(total, 0, -1)}
    return [(c, EVER if ever else c, error) for c in chosen for error, ever in chosen[c]]


def sweep(library: str, base: Path, which: str) -> None:
    """Print "case" and the exit status of each case; the next run must give the same bytes."""
    calls = Calls(library)
    folder = fresh(base / "sound")
    calls.fail(folder)
    sound = result(folder)
    for case, (first, last, error) in enumerate(cases_of(calls.number.value, which)):
        folder = fresh(base / str(case))
        calls.fail(folder, first, last, error)
        status = run(folder)
        calls.fail(None)
        print("case", status)
        assert status in (0, 2), (first, last, error)
        assert result(folder) == sound, (first, last, error)
        shutil.rmtree(folder)


if __name__ == "__main__":
    sweep(sys.argv[1], Path(sys.argv[2]), sys.argv[3])
