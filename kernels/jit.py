"""The one place that decides how kernels are compiled and where machine code is cached.

numba's disk cache does not notice an edit in a *called* function of another module, so the
cache folder carries a hash of all kernel sources: any edit opens a new folder.
"""

import hashlib
import os
import tempfile
from pathlib import Path

import numba


def source_hash() -> str:
    """Return a short hash over every source file of this package (hexadecimal)."""
    digest = hashlib.sha256()
    for source in sorted(Path(__file__).parent.glob("*.py")):
        digest.update(source.name.encode())
        digest.update(source.read_bytes())
    return digest.hexdigest()[:16]


def _cache_folder() -> str:
    base = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")
    folder = base / "elastomer-friction" / source_hash()
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            return str(folder)
    except OSError:  # read-only home, as on many batch nodes
        return tempfile.mkdtemp(prefix="elastomer-friction-")


if not os.environ.get("NUMBA_CACHE_DIR"):
    numba.config.CACHE_DIR = _cache_folder()

# nogil: a scheduler must be able to talk to a worker while a kernel runs.
# error_model numpy: division by zero gives inf as in numpy, and loops stay vectorizable.
kernel = numba.njit(nogil=True, error_model="numpy", cache=True)
