"""Tests of the program, with one thread per process as in its command and workers."""

import os

# Before numpy is imported. Tools of this package also run where the program is not installed.
os.environ |= {f"{library}_NUM_THREADS": "1" for library in ("OMP", "MKL", "OPENBLAS", "NUMBA")}
