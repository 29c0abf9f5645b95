"""One process per folder of results: a lock of the operating system that dies with its holder."""

import contextlib
import fcntl
import json
import os
import socket
import sys
from collections.abc import Iterator
from datetime import datetime
from pathlib import Path
from typing import IO

from workflow.errors import UserError
from workflow.system.files import refused

NAME = "lock"


@contextlib.contextmanager
def hold(folder: Path) -> Iterator[None]:
    """Hold the lock of a folder, made if need be. Raises UserError naming who has it."""
    with refused(folder, "cannot be used for results:"):
        folder.mkdir(parents=True, exist_ok=True)
        file = (folder / NAME).open("a+")
    with file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise UserError(f"{folder}: in use by {_words(folder)}; one run at a time") from None
        except OSError as error:  # a file system without locks
            print(
                f"warning: {folder}: cannot be locked ({error.strerror}); "
                "see to it that no other run uses it",
                file=sys.stderr,
            )
        _sign(file)
        yield


def holder(folder: Path) -> str | None:
    """Return who holds the lock of a folder, in words, or None."""
    try:
        with (folder / NAME).open() as file:
            fcntl.flock(file, fcntl.LOCK_SH | fcntl.LOCK_NB)
    except BlockingIOError:
        return _words(folder)
    except OSError:
        pass
    return None


def _sign(file: IO[str]) -> None:
    """Write into the lock who holds it; a full disk may prevent that, but not the lock."""
    with contextlib.suppress(OSError):
        since = datetime.now().astimezone().isoformat(" ", "seconds")
        file.truncate(0)
        text = json.dumps({"pid": os.getpid(), "host": socket.gethostname(), "since": since})
        os.write(file.fileno(), text.encode())  # no buffer, which would fail again when closed


def _words(folder: Path) -> str:
    try:
        signed = json.loads((folder / NAME).read_text())
        return f"process {signed['pid']} on {signed['host']} since {signed['since']}"
    except (OSError, ValueError, KeyError, TypeError):
        return "an unknown process"
