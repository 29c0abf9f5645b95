"""The same core in C (dense.c), built where a compiler is."""

import ctypes
import shutil
import subprocess
import tempfile
from pathlib import Path

import numpy as np

FLAGS = ["-O3", "-march=native", "-ffast-math", "-fPIC", "-shared"]
NUMBERS = np.ctypeslib.ndpointer(np.float64, flags="C_CONTIGUOUS")
REAL, COUNT = ctypes.c_double, ctypes.c_long


class Compiled:
    """The functions of dense.c. Raises FileNotFoundError where there is no compiler."""

    def __init__(self) -> None:
        compiler = shutil.which("gcc") or shutil.which("cc")
        if compiler is None:
            raise FileNotFoundError("no compiler for C")
        source = Path(__file__).with_name("dense.c")
        with tempfile.TemporaryDirectory() as folder:
            target = Path(folder) / "dense.so"
            subprocess.run([compiler, *FLAGS, str(source), "-o", str(target), "-lm"], check=True)
            library = ctypes.CDLL(str(target))
        self._steady, self._friction, self._march = library.steady, library.friction, library.march
        for function in (self._steady, self._friction, self._march):
            function.restype = REAL
        self._steady.argtypes = [NUMBERS, NUMBERS, COUNT, REAL, REAL, REAL]
        self._friction.argtypes = [NUMBERS, NUMBERS, NUMBERS, COUNT, REAL, REAL, REAL]
        self._march.argtypes = [NUMBERS, NUMBERS, NUMBERS, COUNT, *[REAL] * 4, COUNT, NUMBERS]

    def steady(self, z, decay, stiffness, load):
        """Return (w, d) of steady sliding; w of shape (n,)."""
        w = np.empty_like(z)
        return w, self._steady(z, w, z.size, decay, stiffness, load)

    def friction(self, z, slope, w, d, speed, load):
        """Return mu at an instant, without what the edges of contacts ask for."""
        return self._friction(z, slope, w, z.size, d, speed, load)

    def march(self, z, weight, w, d, decay, stiffness, load, steps):
        """Return mu of each step, shape (steps,)."""
        w, mu = w.copy(), np.empty(steps)
        self._march(z, weight, w, z.size, d, decay, stiffness, load, steps, mu)
        return mu
