"""Calls that fail, a process that ends anywhere: all is kept but what was not yet stored."""

import contextlib
import errno
import io
import os
from pathlib import Path

from tests.support.faults import SHARDS, TRUTH, checked, fill, readable
from tests.support.shards import held, reopened
from tests.support.sweeps import mostly_exhaustive
from workflow.errors import UserError
from workflow.store.store import Store


class Crash(BaseException):
    """The end of the process, wherever it is."""


class Faults:
    """Lets the nth call that changes a folder fail, a write half-way; counts the calls."""

    def __init__(self, nth, error, share):
        self.nth, self.error, self.share = nth, error, share
        self.calls = 0

    def count(self):
        """Count a call; raise if it is the one to fail."""
        self.calls += 1
        if self.calls == self.nth:
            raise self.error

    def before(self, function):
        """Return the function, failing in its turn."""

        def call(*args, **named):
            self.count()
            return function(*args, **named)

        return call

    def opened(self, function):
        """Return Path.open, whose files for writing fail in their turn."""
        faults = self

        class Torn(io.FileIO):
            def write(self, content):
                try:
                    faults.count()
                except BaseException:
                    super().write(content[: int(faults.share * len(content))])
                    raise
                return super().write(content)

        def call(path, mode="r", *args, **named):
            if mode == "rb":
                return function(path, mode, *args, **named)
            self.count()
            return Torn(path, mode.replace("b", ""))

        return call


FULL = OSError(errno.ENOSPC, "No space left on device")
BROKEN = OSError(errno.EIO, "Input/output error")


@mostly_exhaustive(
    "error, share, every",
    [(FULL, 0.5, 5), (Crash(), 1.0, 5)],  # one call in so many fails
    [*((FULL, share, 1) for share in (0.0, 0.5, 1.0)), (BROKEN, 0.9, 1)]
    + [(Crash(), share, 1) for share in (0.5, 1.0)],
)
def test_call_that_fails_loses_at_most_what_was_not_yet_stored(
    tmp_path, instant, monkeypatch, error, share, every
):
    for nth in range(1, 1000, every):
        folder = tmp_path / str(nth)
        folder.mkdir()
        store, faults = Store(folder), Faults(nth, error, share)
        with monkeypatch.context() as patch:
            patch.setattr(os, "fsync", faults.before(os.fsync))
            patch.setattr(os, "open", faults.before(os.open))
            patch.setattr(Path, "replace", faults.before(Path.replace))
            patch.setattr(Path, "open", faults.opened(Path.open))
            with contextlib.suppress(Crash, UserError):
                fill(store)
        if faults.calls < nth:
            break
        promised = held(store)
        assert promised < TRUTH.keys()
        assert checked(store) == promised
        assert readable(folder) >= promised
        fill(reopened(folder))  # the next run goes on
        assert checked(Store(folder)) == TRUTH.keys()
    assert nth > 3 * len(SHARDS) * 3  # calls per file, shards, files changed at least
