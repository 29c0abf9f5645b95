"""From a study to a result: see docs/architecture.md."""

import os

# We write no file that has its name already, so HDF5 needs no locks of its own; where a file system
# has none, it would refuse to write. HDF5 looks here once, when it is loaded.
os.environ.setdefault("HDF5_USE_FILE_LOCKING", "FALSE")
