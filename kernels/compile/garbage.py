"""When Python need not look for garbage: in work that makes next to none, and at the end."""

import atexit
import contextlib
import gc
from collections.abc import Iterator


@contextlib.contextmanager
def garbage_collection_paused() -> Iterator[None]:
    """Let Python collect no cyclic garbage within this block; after it all is as it was."""
    before = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if before:
            gc.enable()


# The system takes back at once what is left when a process ends. Python would look through it
# first, for a second after compiling.
atexit.register(gc.freeze)
