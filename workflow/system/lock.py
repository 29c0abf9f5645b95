"""One process per folder of results: a lock of the operating system that dies with its holder."""

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
GLANCE_SECONDS = 2.0
LONGEST = 4096  # bytes of who has signed


@contextlib.contextmanager
def hold(folder: Path, *, without: bool = False) -> Iterator[None]:
    """Hold the lock of a folder, made if need be. Raises UserError naming who has it.

    without : go on where the file system has no locks, which is refused otherwise.
    """
    with refused(folder, "cannot be used for results:"):
        folder.mkdir(parents=True, exist_ok=True)
        file = open_plain(folder / LOCK, "ab+")
        flushed = flush_folder(folder)
    with file:
        _take(file, folder, without)
        if not flushed:
            print(
                f"note: {folder}: the file system flushes no folder: a power cut may cost the "
                "newest files, which are computed again",
                file=sys.stderr,
            )
        _sign(file)
        yield


def holder(folder: Path) -> str | None:
    """Return who holds the lock of a folder, in words, or None."""
    with contextlib.suppress(OSError), open_plain(folder / LOCK) as file:
        try:
            fcntl.flock(file, fcntl.LOCK_SH | fcntl.LOCK_NB)
        except BlockingIOError:
            return _words(folder)
        except OSError:  # a file system without locks: is a process of this machine still there?
            signed = _signed(folder)
            here = signed.get("host") == socket.gethostname()
            return _words(folder) if here and Path(f"/proc/{signed['pid']}").exists() else None
    return None


def _take(file: IO[bytes], folder: Path, without: bool) -> None:
    """Take the lock. Who only looks at it (``holder``) has it for a moment: wait for that."""
    end = time.monotonic() + GLANCE_SECONDS
    while True:
        try:
            return fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            if time.monotonic() > end:
                who = _words(folder)
                raise UserError(f"{folder}: in use by {who}; one run at a time") from None
            time.sleep(0.01)
        except OSError as error:
            if without:
                return None
            raise UserError(
                f"{folder}: cannot be locked ({error.strerror}); see to it that no other run uses "
                "it, then go on with --no-lock"
            ) from error


def _sign(file: IO[bytes]) -> None:
    """Write into the lock who holds it; a full disk may prevent that, but not the lock."""
    with contextlib.suppress(OSError):
        since = datetime.now().astimezone().isoformat(" ", "seconds")
        file.truncate(0)
        text = json.dumps({"pid": os.getpid(), "host": socket.gethostname(), "since": since})
        os.write(file.fileno(), text.encode())  # no buffer, which would fail again when closed


def _signed(folder: Path) -> dict[str, Any]:
    """Return pid, host and since of who has signed the lock; nothing where that is damaged."""
    with contextlib.suppress(OSError, ValueError, KeyError, TypeError, RecursionError):
        with open_plain(folder / LOCK) as file:
            signed = json.loads(file.read(LONGEST))
        return {name: signed[name] for name in ("pid", "host", "since")}
    return {}


def _words(folder: Path) -> str:
    known = "process {pid} on {host} since {since}" if (signed := _signed(folder)) else ""
    return known.format(**signed) or "an unknown process"
