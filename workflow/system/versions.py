"""The same program everywhere: what results depend on, compared before a worker does work."""

import platform
import socket
from functools import cache

from ..ground import UserError
from .packages import our_sources, version_of

DEPENDED_ON = ("numpy", "numba", "llvmlite", "scipy", "dask", "distributed")

Versions = dict[str, str]  # what a process runs


@cache
def own_versions() -> Versions:
    """Return what this process runs; the hash of our own sources is last."""
    found = {name: version_of(name) for name in DEPENDED_ON}
    return found | {"python": platform.python_version(), "our sources": our_sources()}


def require(expected: Versions) -> None:
    """Raise UserError with a table where this process, a worker, differs from the driver."""
    found = own_versions()
    odd = [name for name, version in expected.items() if found.get(name) != version]
    if odd:
        head = "workers must run what the driver runs:"
        rows = [("", "", "there", "driver")]
        rows += [(socket.gethostname(), name, str(found.get(name)), expected[name]) for name in odd]
        raise UserError(head, *(f"  {row[0]:28s}{row[1]:14s}{row[2]:18s}{row[3]}" for row in rows))
