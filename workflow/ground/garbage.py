"""A pause of Python's garbage collector, for work that creates almost no cyclic garbage."""

import atexit
import contextlib
import gc
from collections.abc import Iterator

atexit.register(gc.freeze)  # skips the last collection; the process frees all memory anyway


@contextlib.contextmanager
def garbage_collection_paused() -> Iterator[None]:
    """Disable the collection of cyclic garbage within a ``with`` block."""
    enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if enabled:
            gc.enable()
