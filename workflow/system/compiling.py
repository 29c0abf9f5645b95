"""A line on the screen before kernels are compiled: that takes long, and happens once."""

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

LINE = "Compiling the kernels, about 20 s, once."


@contextmanager
def saying_what_compiles() -> Iterator[None]:
    """Say so once if numba compiles anything within this block; what it finds is no compiling."""
    from numba.core import event  # slow to import, and there once there is anything to compile

    class Once(event.Listener):
        said = False

        def on_start(self, event: Any) -> None:
            """Say it."""
            if not self.said:
                print(LINE, file=sys.stderr, flush=True)
            self.said = True

        def on_end(self, event: Any) -> None:
            """Say nothing."""

    with event.install_listener("numba:compile", Once()):
        yield
