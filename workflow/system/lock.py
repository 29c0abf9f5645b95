"""Lock of a folder for one process, which the operating system releases when the process ends."""

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
PROBE_SECONDS = 2.0  # longest wait for a process that only probes the lock, in ``holder``
MAX_SIGNATURE_BYTES = 4096  # bytes that are read of a lock file


@contextlib.contextmanager
def hold(folder: Path, *, without: bool = False) -> Iterator[None]:
    """Hold the lock of a folder, which is created if missing. Raises UserError if it is in use.

    without : whether to continue without a lock if the file system does not support locks.
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
    """Return a description of the process that holds the lock of a folder, or None."""
    with contextlib.suppress(OSError), open_plain(folder / LOCK) as file:
        try:
            fcntl.flock(file, fcntl.LOCK_SH | fcntl.LOCK_NB)
        except BlockingIOError:
            return _description(folder)
        except OSError:  # no support for locks: check whether the signing process still runs here
            signed = _signature(folder)
            here = signed.get("host") == socket.gethostname()
            alive = here and Path(f"/proc/{signed['pid']}").exists()
            return _description(folder) if alive else None
    return None


def _acquire(file: IO[bytes], folder: Path, without: bool) -> None:
    """Acquire the lock; wait up to PROBE_SECONDS for processes that only probe it."""
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
    """Write pid, host and time into the lock file; ignore a full disk, as the lock still holds."""
    with contextlib.suppress(OSError):
        since = datetime.now().astimezone().isoformat(" ", "seconds")
        file.truncate(0)
        text = json.dumps({"pid": os.getpid(), "host": socket.gethostname(), "since": since})
        os.write(file.fileno(), text.encode())  # unbuffered; a buffer would fail again on close


def _signature(folder: Path) -> dict[str, Any]:
    """Return the fields pid, host and since of the lock file; empty if it is damaged."""
    with contextlib.suppress(OSError, ValueError, KeyError, TypeError, RecursionError):
        with open_plain(folder / LOCK) as file:
            fields = json.loads(file.read(MAX_SIGNATURE_BYTES))
        return {name: fields[name] for name in ("pid", "host", "since")}
    return {}


def _description(folder: Path) -> str:
    known = "process {pid} on {host} since {since}" if (signed := _signature(folder)) else ""
    return known.format(**signed) or "an unknown process"
