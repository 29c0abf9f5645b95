"""Check of netCDF files of unknown origin, which are first read in a separate process.

If the separate process reads a file completely within its limits, and without any other file, this
process can read it too.
"""

import contextlib
import math
import zlib
from pathlib import Path
from typing import Any

import numpy as np

from ..ground import UserError
from .durable_files import read_whole
from .sandbox import (
    KILLED,
    answer,
    limit_cpu_time,
    limit_memory,
    no_files,
    read_apart,
    requested_paths,
)

MIN_READ_SECONDS, READ_BYTES_PER_SECOND = 1.0, 1e7  # CPU time for a file and for each variable
MAX_READ_SECONDS = 1e4  # cap on the CPU time in proportion to the size, which may be forged
OTHER_FILE = "its content is in another file"


def unreadable(paths: list[Path]) -> dict[Path, str]:
    """Return the netCDF files that cannot be read completely, as path -> reason.

    Raises UserError if no process can be started, or if it is killed from outside, for instance
    for lack of memory.
    """
    reasons: dict[Path, str] = {}
    remaining = list(paths)
    while remaining:
        output, fault = read_apart(__name__, remaining)
        answers = output.decode().split("\n")[:-1]
        answered = zip(remaining, answers, strict=False)
        reasons |= {path: reason for path, reason in answered if reason}
        remaining = remaining[len(answers) :]
        if fault == KILLED:
            raise UserError(f"{remaining[0]}: cannot be read: {fault}")
        if fault and remaining:
            reasons[remaining.pop(0)] = fault
    return reasons


def _read_error(content: bytes) -> str:
    """Return why a netCDF file cannot be read completely, and without other files, or ""."""
    outcome = _outcome(content)  # first, as it may load a filter, which is a file too
    with no_files():
        return outcome[0] if _outcome(content) == outcome else OTHER_FILE


def _outcome(content: bytes) -> tuple[str, int]:
    """Read a netCDF file completely; return why this fails or "", and a checksum of its values."""
    import netCDF4

    checksum = 0
    _limit_cpu_time(len(content))
    try:
        with netCDF4.Dataset("file.nc", memory=content) as file:
            groups: list[Any] = [file]
            for group in groups:
                groups += group.groups.values()
                for owner in (group, *group.variables.values()):
                    for name in owner.ncattrs():
                        owner.getncattr(name)
                for variable in group.variables.values():
                    variable.set_auto_maskandscale(False)
                    _limit_cpu_time(8 * math.prod(variable.shape))
                    values = np.asarray(variable[...])
                    checksum = zlib.crc32(
                        values.tobytes()
                        if values.dtype != object
                        else repr(values.tolist()).encode(),
                        checksum,
                    )
    except MemoryError:
        return "it claims more data than fits into memory", checksum
    except Exception as error:  # a forged file can cause any exception
        return " ".join(f"{error}".split()) or type(error).__name__, checksum
    return "", checksum


def _main() -> None:
    """Print a line for each file named on standard input: why it is unreadable, or nothing."""
    import netCDF4  # noqa: F401 - before memory is limited

    limit_memory()
    for path in requested_paths():
        reason = ""
        with contextlib.suppress(UserError):  # the caller meets and reports the same disk error
            reason = _read_error(read_whole(path))
        answer(f"{reason}\n".encode(errors="replace"))


def _limit_cpu_time(size: int) -> None:
    """Limit the CPU time to that for ``size`` bytes."""
    limit_cpu_time(MIN_READ_SECONDS + min(size / READ_BYTES_PER_SECOND, MAX_READ_SECONDS))


if __name__ == "__main__":
    _main()
