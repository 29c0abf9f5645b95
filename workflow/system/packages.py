"""Package versions and processor of this process.

Workers must have the same versions as the driver, which ``require`` checks.
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

PROGRAM_ROOT = Path(__file__).resolve().parents[2]  # contains kernels, workflow and studies
SOURCE_FOLDERS = ("kernels", "workflow")
PACKAGES = ("numpy", "numba", "scipy", "dask", "distributed", "xarray", "netCDF4")
NUMERICAL_PACKAGES = ("numpy", "numba", "llvmlite")  # they may affect the last bits of records
WORKER_PACKAGES = (*NUMERICAL_PACKAGES, "scipy", "dask", "distributed")

Versions = dict[str, str]  # package -> version


class Maker(NamedTuple):
    """Versions and processor that computed records. The last bits may depend on them."""

    versions: str  # versions of Python, the C library and the numerical packages, as text
    processor: str


@cache
def version_of(package: str) -> str:
    """Return the version of a package, or "not installed"."""
    try:
        return version(package)
    except PackageNotFoundError:
        return "not installed"


VERSION = version_of("elastomer-friction")


def package_versions() -> str:
    """Return the versions of PACKAGES as text."""
    return ", ".join(f"{name} {version_of(name)}" for name in PACKAGES)


@cache
def our_sources() -> str:
    """Return a short hash of all Python files in SOURCE_FOLDERS."""
    digest = hashlib.sha256()
    for source in sorted(
        path for name in SOURCE_FOLDERS for path in (PROGRAM_ROOT / name).rglob("*.py")
    ):
        digest.update(source.relative_to(PROGRAM_ROOT).as_posix().encode() + source.read_bytes())
    return digest.hexdigest()[:16]


def import_dask() -> None:
    """Import dask, which reads its settings. Raises UserError if these are malformed."""
    try:
        import dask  # noqa: F401
    except ValueError as error:  # its message has several lines
        raise UserError(f"the settings of dask: {' '.join(str(error).split())}") from error


def processor() -> str:
    """Return the model name of the processor."""
    with contextlib.suppress(OSError):
        for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor() or platform.machine()


@cache
def this_maker() -> Maker:
    """Return the maker of records that this process computes."""
    python = f"python {platform.python_version()}"
    library = " ".join(platform.libc_ver()).strip() or "unknown C library"
    packages = [f"{name} {version_of(name)}" for name in NUMERICAL_PACKAGES]
    return Maker(", ".join([python, library, *packages]), processor())


@cache
def own_versions() -> Versions:
    """Return the versions in this process, with a hash of this program's sources."""
    versions = {name: version_of(name) for name in WORKER_PACKAGES}
    return versions | {"python": platform.python_version(), "our sources": our_sources()}


def require(expected: Versions, versions: Versions | None = None, role: str = "worker") -> None:
    """Raise UserError with a table if the versions of a process differ from the driver's.

    expected : of the driver. versions : of the process, by default of this one.
    """
    versions = own_versions() if versions is None else versions
    different = [name for name in expected if versions.get(name) != expected[name]]
    if different:
        head = f"{role}s must have the versions of the driver:"
        rows = [("", "", role, "driver")]
        host = socket.gethostname() if role == "worker" else ""
        rows += [(host, name, str(versions.get(name)), expected[name]) for name in different]
        raise UserError(head, *(f"  {row[0]:28s}{row[1]:14s}{row[2]:18s}{row[3]}" for row in rows))
