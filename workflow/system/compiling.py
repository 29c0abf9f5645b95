"""A line on the screen before kernels are compiled: that takes long, and happens once."""

import contextlib
import json
import os
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

FILE = "compile-seconds.json"  # what is compiled -> seconds that it took the last time
COMPILING_MIB = 300  # beyond what a process needs else; 254 were measured
WAITING = "Waiting for another process that compiles."


@contextlib.contextmanager
def report_compilation(what: str, usual: str, folder: str, waits: str) -> Iterator[None]:
    """Say so once if numba compiles anything within this block; what it finds is no compiling.

    what : is compiled. usual : how long that takes, where it is not known of this machine. folder :
    of the machine code; beside it is noted what took how long. waits : kind of event while another
    process is waited for that compiles.
    """
    from numba.core import event  # slow to import, and there once there is anything to compile

    compiles, notes = "numba:compile", Path(folder).parent
    began = ended = 0.0
    said = set[str]()

    class Teller(event.Listener):
        def on_start(self, event: Any) -> None:
            """Say it."""
            nonlocal began
            if not said or (event.kind == compiles and compiles not in said):
                known = _known(notes).get(what)
                long = usual if known is None else f"about {max(known, 1.0):.0f} s"
                cost = f"{long} and about {COMPILING_MIB} MiB"
                line = f"Compiling {what}, {cost}, once." if event.kind == compiles else WAITING
                print(line, file=sys.stderr, flush=True)
                began = time.monotonic()
            said.add(event.kind)

        def on_end(self, event: Any) -> None:
            """Note the time."""
            nonlocal ended
            ended = time.monotonic()

    teller = Teller()
    with event.install_listener(compiles, teller), event.install_listener(waits, teller):
        yield
    if compiles in said:
        aside = Path(notes, f"{FILE}.{os.getpid()}")
        with contextlib.suppress(OSError):  # if the disk takes it
            aside.write_text(json.dumps({**_known(notes), what: ended - began}), encoding="utf-8")
            aside.replace(Path(notes, FILE))


def _known(folder: Path) -> dict[str, float]:
    """Return what took how many seconds on this machine, or nothing."""
    with contextlib.suppress(OSError, ValueError, AttributeError, TypeError):
        text = Path(folder, FILE).read_text(encoding="utf-8")
        return {str(what): float(seconds) for what, seconds in json.loads(text).items()}
    return {}
