"""Safe access to regular files: no pipes, devices or unexpected links, and a size limit."""

import errno
import os
import stat
from pathlib import Path
from typing import Any

MAX_INPUT_BYTES = 2**30


def open_plain(path: Path, mode: str = "rb", *, linked: bool = False) -> Any:
    """Open a regular file as ``open`` does; follow a link only if ``linked`` is true.

    Pipes, devices and unexpected links are refused: opening a pipe waits for its writer, a device
    may never end, and another user with access to the folder could have placed a link to one of
    our files there. Raises OSError.
    """

    def opener(name: str, flags: int) -> int:
        flags |= os.O_NONBLOCK | (0 if linked else os.O_NOFOLLOW)
        try:
            descriptor = os.open(name, flags, 0o666)
        except OSError as error:
            if error.errno == errno.ELOOP:
                raise OSError(errno.ELOOP, "it is a link", name) from None
            raise
        if not stat.S_ISREG(os.fstat(descriptor).st_mode):
            os.close(descriptor)
            raise OSError(errno.EINVAL, "it is not a regular file", name)
        return descriptor

    return open(path, mode, opener=opener, buffering=0 if "a" in mode else -1)


def read_plain(path: Path, most: int = MAX_INPUT_BYTES) -> bytes:
    """Return the content of a file; the path may be a link.

    Raises OSError if it is not a regular file or has more than ``most`` bytes.
    """
    with open_plain(path, linked=True) as file:
        size = os.fstat(file.fileno()).st_size
        if size > most:
            raise OSError(errno.EFBIG, f"it has {size} bytes, more than {most}", str(path))
        content: bytes = file.read()
        return content
