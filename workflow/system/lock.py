"""Lock of a results folder for one process, released by the operating system at its end."""

import contextlib
import fcntl
import json
import os
import socket
import sys
import time
from collections.abc import Iterator
from datetime import datetime
from pathlib import Path
from typing import IO, Any

from ..ground import UserError, open_plain
from .durable_files import flush_folder, refused

LOCK = "lock"
PROBE_SECONDS = 2.0  # to wait for a process that only looks at the lock
MAX_SIGNATURE_BYTES = 4096


@contextlib.contextmanager
def hold(folder: Path, *, without: bool = False) -> Iterator[None]:
    """Hold the lock of a folder, made if need be. Raises UserError that names another holder.

    without : continue on a file system without locks, instead of raising UserError.
    """
    with refused(folder, "cannot be used for results:"):
        folder.mkdir(parents=True, exist_ok=True)
        file = open_plain(folder / LOCK, "ab+")
        flushed = flush_folder(folder)
    with file:
        _acquire(file, folder, without)
        if not flushed:
            print(
                f"note: {folder}: the file system cannot flush a folder: a power cut may lose the "
                "newest files, which are then computed again",
                file=sys.stderr,
            )
        _sign(file)
        yield


def holder(folder: Path) -> str | None:
    """Return the holder of the lock of a folder, in words, or None."""
    with contextlib.suppress(OSError), open_plain(folder / LOCK) as file:
        try:
            fcntl.flock(file, fcntl.LOCK_SH | fcntl.LOCK_NB)
        except BlockingIOError:
            return _description(folder)
        except OSError:  # no locks: does the signing process still run on this machine?
            signed = _signature(folder)
            here = signed.get("host") == socket.gethostname()
            alive = here and Path(f"/proc/{signed['pid']}").exists()
            return _description(folder) if alive else None
    return None


def _acquire(file: IO[bytes], folder: Path, without: bool) -> None:
    """Acquire the lock; wait for processes that hold it briefly in ``holder``."""
    end = time.monotonic() + PROBE_SECONDS
    while True:
        try:
            return fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            if time.monotonic() > end:
                who = _description(folder)
                raise UserError(f"{folder}: in use by {who}; one run at a time") from None
            time.sleep(0.01)
        except OSError as error:
            if without:
                return None
            raise UserError(
                f"{folder}: cannot be locked ({error.strerror}); make sure that no other run "
                "uses it, then add --no-lock"
            ) from error


def _sign(file: IO[bytes]) -> None:
    """Write the holder into the lock file; if the disk is full, the lock holds all the same."""
    with contextlib.suppress(OSError):
        since = datetime.now().astimezone().isoformat(" ", "seconds")
        file.truncate(0)
        text = json.dumps({"pid": os.getpid(), "host": socket.gethostname(), "since": since})
        os.write(file.fileno(), text.encode())  # no buffer, which would fail again when closed


def _signature(folder: Path) -> dict[str, Any]:
    """Return pid, host and since of the holder; empty if the file is damaged."""
    with contextlib.suppress(OSError, ValueError, KeyError, TypeError, RecursionError):
        with open_plain(folder / LOCK) as file:
            fields = json.loads(file.read(MAX_SIGNATURE_BYTES))
        return {name: fields[name] for name in ("pid", "host", "since")}
    return {}


def _description(folder: Path) -> str:
    known = "process {pid} on {host} since {since}" if (signed := _signature(folder)) else ""
    return known.format(**signed) or "an unknown process"
