"""What a process says: a terminal that is gone, or cannot show a letter, ends no run."""

import contextlib
import errno
import io
import os
import sys
from pathlib import Path
from typing import Any, TextIO


class _Forgiving(io.TextIOWrapper):
    """A stream to print to; what cannot be written is lost, and nobody is troubled.

    A signal may come while a line is written, and print one itself (RuntimeError).
    """

    def write(self, text: str, /) -> int:
        """Write as far as that is possible."""
        try:
            return super().write(text)
        except (OSError, RuntimeError, ValueError) as error:
            self._lost(error)
        return len(text)

    def flush(self) -> None:
        """Flush as far as that is possible."""
        try:
            super().flush()
        except (OSError, RuntimeError, ValueError) as error:
            self._lost(error)

    def _lost(self, error: Exception) -> None:
        """Let what is left in the buffer of a pipe that nobody reads go nowhere."""
        if isinstance(error, OSError) and error.errno == errno.EPIPE:
            with contextlib.suppress(OSError):
                nowhere = os.open(os.devnull, os.O_RDWR)
                os.dup2(nowhere, self.fileno())
                os.close(nowhere)


def program() -> str:
    """Return how the program was called: by its console command, or as a module of Python."""
    command = Path(sys.argv[0]).name
    return command if command == "elastomer-friction" else "python -m workflow"


def forgive_streams() -> None:
    """Let nothing that is printed in this process end it; for its start.

    Streams that are closed lead nowhere, so that no file gets their numbers; letters that the
    terminal does not have are shown as numbers.
    """
    while (descriptor := os.open(os.devnull, os.O_RDWR)) <= 2:
        pass
    os.close(descriptor)
    sys.stdout = _forgiving(sys.stdout)
    sys.stderr = _forgiving(sys.stderr)


def _forgiving(stream: Any) -> TextIO:
    if stream is None:
        return Path(os.devnull).open("w", encoding="utf-8")
    how = {"line_buffering": stream.line_buffering, "write_through": stream.write_through}
    encoding = stream.encoding
    return _Forgiving(stream.detach(), encoding, "backslashreplace", **how)
