"""Files that are opened only if they are files, and read as a whole only up to a stated size."""

import errno
import os
import stat
from pathlib import Path
from typing import Any

MOST_BYTES = 2**30  # of a file of input


def open_plain(path: Path, mode: str = "rb", *, linked: bool = False) -> Any:
    """Open a file as ``open`` does, but no pipe or device, and a link only where that is said.

    To open a pipe waits for whoever writes to it, a device may have no end, and whoever may write
    to a folder could have put a link there to any file of ours. Raises OSError.
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
            raise OSError(errno.EINVAL, "it is no file", name)
        return descriptor

    return open(path, mode, opener=opener, buffering=0 if "a" in mode else -1)


def read_plain(path: Path, most: int = MOST_BYTES) -> bytes:
    """Return the content of a file, to which the path may be a link.

    Raises OSError for what is no file, and for one of more than ``most`` bytes.
    """
    with open_plain(path, linked=True) as file:
        size = os.fstat(file.fileno()).st_size
        if size > most:
            raise OSError(errno.EFBIG, f"it has {size} bytes, more than {most}", str(path))
        content: bytes = file.read()
        return content
