"""The same program everywhere: what results depend on, compared before a worker does work."""

import platform
import socket
from functools import cache

from distributed import Client

from ..errors import UserError
from ..system import our_sources, version_of
from .calls import Call, patiently
from .watch import NO_ANSWER, Watch

PACKAGES = ("numpy", "numba", "llvmlite", "scipy", "dask", "distributed")
ANSWER_SECONDS = 10.0  # to wait for the answers of all workers

Versions = dict[str, str]  # what a process runs


@cache
def own_versions() -> Versions:
    """Return what this process runs; the hash of our own sources is last."""
    found = {name: version_of(name) for name in PACKAGES}
    return found | {"python": platform.python_version(), "our sources": our_sources()}


def require(expected: Versions) -> None:
    """Raise UserError with a table where this process, a worker, differs from the driver."""
    if own_versions() != expected:
        raise UserError(*_table(expected, {socket.gethostname(): own_versions()}))


def check_versions(client: Client, watch: Watch) -> None:
    """Raise UserError with a table where scheduler or workers differ from this process.

    Workers that come later, or do not answer now, check by themselves at their first batch.
    """
    others: dict[str, Versions | BaseException] = {}
    try:
        ask = (client.run_on_scheduler, own_versions)
        others["scheduler"] = patiently(watch, NO_ANSWER, *ask)
    except UserError:
        raise
    except Exception as error:  # whatever importing our package there may raise
        others["scheduler"] = error
    workers = Call(_workers_run, client)
    if workers.wait(ANSWER_SECONDS):
        others |= workers.result()
    odd = {name: found for name, found in others.items() if found != own_versions()}
    if odd:
        raise UserError(*_table(own_versions(), odd))


def _workers_run(client: Client) -> dict[str, Versions | BaseException]:
    return client.run(own_versions, on_error="return")


def _table(mine: Versions, others: dict[str, Versions | BaseException]) -> list[str]:
    lines = ["scheduler and workers must run what the driver runs:"]
    lines.append(f"  {'':28s}{'':14s}{'there':18s}driver")
    for name, found in sorted(others.items()):
        if isinstance(found, BaseException):
            lines.append(f"  {name:28s}cannot import it: {found}")
            continue
        for package, value in mine.items():
            if found.get(package) != value:
                lines.append(f"  {name:28s}{package:14s}{found.get(package)!s:18s}{value}")
    return lines
