"""Output streams that do not end a run if the terminal is lost or lacks a character."""

import contextlib
import errno
import io
import os
import sys
from pathlib import Path
from typing import Any, TextIO


class _TolerantStream(io.TextIOWrapper):
    """A text stream that drops output that it cannot write.

    RuntimeError is raised if a signal handler prints while a line is being written.
    """

    def write(self, text: str, /) -> int:
        """Write the text, or drop it if this fails."""
        try:
            return super().write(text)
        except (OSError, RuntimeError, ValueError) as error:
            self._discard(error)
        return len(text)

    def flush(self) -> None:
        """Flush the buffer, or discard it if this fails."""
        try:
            super().flush()
        except (OSError, RuntimeError, ValueError) as error:
            self._discard(error)

    def _discard(self, error: Exception) -> None:
        """Redirect a pipe that has lost its reader to the null device; ignore other errors."""
        if isinstance(error, OSError) and error.errno == errno.EPIPE:
            with contextlib.suppress(OSError):
                null = os.open(os.devnull, os.O_RDWR)
                os.dup2(null, self.fileno())
                os.close(null)


def program() -> str:
    """Return the command that started the program: the console script or python -m."""
    command = Path(sys.argv[0]).name
    return command if command == "elastomer-friction" else "python -m workflow"


def make_streams_tolerant() -> None:
    """Make stdout and stderr ignore write errors; call this when the process starts.

    Closed streams are opened on the null device, so that no file gets their descriptors. Characters
    that the encoding lacks are written as backslash escapes.
    """
    while (descriptor := os.open(os.devnull, os.O_RDWR)) <= 2:
        pass
    os.close(descriptor)
    sys.stdout = _tolerant(sys.stdout)
    sys.stderr = _tolerant(sys.stderr)


def _tolerant(stream: Any) -> TextIO:
    if stream is None:
        return Path(os.devnull).open("w", encoding="utf-8")
    buffering = {"line_buffering": stream.line_buffering, "write_through": stream.write_through}
    encoding = stream.encoding
    return _TolerantStream(stream.detach(), encoding, "backslashreplace", **buffering)
