"""Message to the user before kernels are compiled, which takes long but happens only once."""

import contextlib
import sys
from collections.abc import Iterator
from typing import Any

COMPILING_MIB = 300  # additional memory needed to compile; measured: 254


@contextlib.contextmanager
def report_compilation(subject: str, duration: str, waiting_event: str) -> Iterator[None]:
    """Print a line if numba compiles ``subject`` in this block or waits for another process."""
    from numba.core import event  # slow to import

    lines = {
        "numba:compile": f"Compiling {subject}, {duration} and about {COMPILING_MIB} MiB, once.",
        waiting_event: "Waiting for another process that compiles.",
    }

    class Reporter(event.Listener):
        def on_start(self, event: Any) -> None:
            if event.kind in lines:
                print(lines.pop(event.kind), file=sys.stderr, flush=True)
                if "numba:compile" not in lines:  # compiling: report no wait after this
                    lines.clear()

        def on_end(self, event: Any) -> None: ...

    reporter, listen = Reporter(), event.install_listener
    with listen("numba:compile", reporter), listen(waiting_event, reporter):
        yield
