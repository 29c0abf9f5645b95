"""Output of a process: a lost terminal or a missing character never ends a run."""

import contextlib
import errno
import io
import os
import sys
from pathlib import Path
from typing import Any, TextIO


class _TolerantStream(io.TextIOWrapper):
    """A text stream that drops output that it cannot write.

    A signal may arrive while a line is written, and print one itself (RuntimeError).
    """

    def write(self, text: str, /) -> int:
        """Write as much as possible."""
        try:
            return super().write(text)
        except (OSError, RuntimeError, ValueError) as error:
            self._discard(error)
        return len(text)

    def flush(self) -> None:
        """Flush as much as possible."""
        try:
            super().flush()
        except (OSError, RuntimeError, ValueError) as error:
            self._discard(error)

    def _discard(self, error: Exception) -> None:
        """Discard the buffer of a pipe without a reader."""
        if isinstance(error, OSError) and error.errno == errno.EPIPE:
            with contextlib.suppress(OSError):
                null = os.open(os.devnull, os.O_RDWR)
                os.dup2(null, self.fileno())
                os.close(null)


def program() -> str:
    """Return the command that started the program: its console command or the module."""
    command = Path(sys.argv[0]).name
    return command if command == "elastomer-friction" else "python -m workflow"


def make_streams_tolerant() -> None:
    """Keep errors of stdout and stderr from ending this process; called at its start.

    Closed streams are opened on the null device, so that no file gets their numbers. Characters
    missing in the terminal are shown as numbers.
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
