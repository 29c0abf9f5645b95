"""Calls to the file system that fail in their turn, and the end of a process between them."""

import io


class Crash(BaseException):
    """The end of the process, wherever it is."""


class Faults:
    """Lets the nth call that changes a folder fail, a write half-way; counts the calls."""

    def __init__(self, nth, error, share):
        self.nth, self.error, self.share, self.calls = nth, error, share, 0

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
