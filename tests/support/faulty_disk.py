"""Disk errors in real processes, from a library that is loaded by LD_PRELOAD."""

import contextlib
import errno
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest

SOURCE = Path(__file__).with_name("disk.c")


class FaultyDisk(NamedTuple):
    """Disk errors that can be switched on and off."""

    library: Path
    flag: Path  # calls fail while this file exists
    always: Path  # a file that always exists

    def environment(self, *rules: str) -> dict[str, str]:
        """Return the environment of a process. rules : "CALL ERRNO PREFIX [always]"."""
        lines = []
        for rule in rules:
            call, error, prefix, *when = rule.split()
            flag = self.always if when else self.flag
            lines.append(f"{call} {getattr(errno, error)} {prefix} {flag}")
        return {"LD_PRELOAD": str(self.library), "DISK_FAULTS": "\n".join(lines)}

    @contextlib.contextmanager
    def failing(self) -> Iterator[None]:
        """Make calls fail within this block."""
        self.flag.touch()
        try:
            yield
        finally:
            self.flag.unlink()


def faulty_disk(folder: Path) -> FaultyDisk:
    """Return a disk whose errors are switched in a folder; skip the test without a compiler."""
    compiler = shutil.which("cc")
    if compiler is None:
        pytest.skip("no compiler of C: faults of the disk cannot be made")
    library = folder / "disk.so"
    command = [compiler, "-shared", "-fPIC", "-o", str(library), str(SOURCE), "-ldl"]
    subprocess.run(command, check=True)
    return FaultyDisk(library, folder / "flag", library)
