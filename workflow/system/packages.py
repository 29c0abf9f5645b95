"""What this process runs: versions of packages, and the processor.

A worker must run what the driver runs before it does work.
"""

import contextlib
import hashlib
import platform
import socket
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import NamedTuple

from ..ground import UserError

ROOT = Path(__file__).resolve().parents[2]  # the folder of kernels, workflow and studies
FOLDERS = ("kernels", "workflow")  # of our sources
PACKAGES = ("numpy", "numba", "scipy", "dask", "distributed", "xarray", "netCDF4")
COMPUTING = ("numpy", "numba", "llvmlite")  # on whose versions the bits of records may depend
DEPENDED_ON = (*COMPUTING, "scipy", "dask", "distributed")  # by what a worker does

Versions = dict[str, str]  # what a process runs


class Maker(NamedTuple):
    """What computed records: two of them may differ in the last bits."""

    versions: str  # of python, the C library and the packages that compute
    processor: str


@cache
def version_of(package: str) -> str:
    """Return the version of an installed package."""
    try:
        return version(package)
    except PackageNotFoundError:
        return "not installed"


VERSION = version_of("elastomer-friction")


def package_versions() -> str:
    """Return the versions of the packages that take part, in words."""
    return ", ".join(f"{name} {version_of(name)}" for name in PACKAGES)


@cache
def our_sources() -> str:
    """Return a short hash over all our source files: the same program has the same."""
    digest = hashlib.sha256()
    for source in sorted(path for name in FOLDERS for path in (ROOT / name).rglob("*.py")):
        digest.update(source.relative_to(ROOT).as_posix().encode() + source.read_bytes())
    return digest.hexdigest()[:16]


def import_dask() -> None:
    """Import dask, which reads its settings then. Raises UserError where these are malformed."""
    try:
        import dask  # noqa: F401
    except ValueError as error:  # as of its files of settings, in several lines
        raise UserError(f"the settings of dask: {' '.join(str(error).split())}") from error


def processor() -> str:
    """Return the name of the processor, on whose kind the last bits of results depend."""
    with contextlib.suppress(OSError):
        for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor() or platform.machine()


@cache
def this_maker() -> Maker:
    """Return what this process computes with."""
    python = f"python {platform.python_version()}"
    library = " ".join(platform.libc_ver()).strip() or "unknown C library"
    packages = [f"{name} {version_of(name)}" for name in COMPUTING]
    return Maker(", ".join([python, library, *packages]), processor())


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
