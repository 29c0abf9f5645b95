"""The same kernels in C (dense.c, scene.c), built if there is a compiler."""

import ctypes
import shutil
import subprocess
import tempfile
from pathlib import Path

import numpy as np

from elastomer_friction.kernels.scene.records import Trace

FLAGS = ["-O3", "-march=native", "-ffast-math", "-fPIC", "-shared"]
SOURCES = ("dense.c", "scene.c")
NUMBERS = np.ctypeslib.ndpointer(np.float64, flags="C_CONTIGUOUS")
INTEGERS = np.ctypeslib.ndpointer(np.int64, flags="C_CONTIGUOUS")
REAL, COUNT = ctypes.c_double, ctypes.c_long


class Compiled:
    """The functions of the C files. Raises FileNotFoundError without a compiler."""

    def __init__(self) -> None:
        compiler = shutil.which("gcc") or shutil.which("cc")
        if compiler is None:
            raise FileNotFoundError("no compiler for C")
        sources = [str(Path(__file__).with_name(name)) for name in SOURCES]
        with tempfile.TemporaryDirectory() as folder:
            target = Path(folder) / "rivals.so"
            subprocess.run([compiler, *FLAGS, *sources, "-o", str(target), "-lm"], check=True)
            library = ctypes.CDLL(str(target))
        self._steady, self._friction, self._march = library.steady, library.friction, library.march
        self._follow = library.follow
        for function in (self._steady, self._friction, self._march, self._follow):
            function.restype = REAL
        self._steady.argtypes = [NUMBERS, NUMBERS, COUNT, REAL, REAL, REAL]
        self._friction.argtypes = [NUMBERS, NUMBERS, NUMBERS, COUNT, REAL, REAL, REAL]
        self._march.argtypes = [NUMBERS, NUMBERS, NUMBERS, COUNT, *[REAL] * 4, COUNT, NUMBERS]
        of_form, of_track = [COUNT, REAL, NUMBERS, NUMBERS], [NUMBERS, NUMBERS, INTEGERS, INTEGERS]
        steps_and_control = [*[NUMBERS] * 3, COUNT, REAL]
        state, kept = [REAL, *[NUMBERS] * 5], [INTEGERS, COUNT, NUMBERS]
        self._follow.argtypes = [COUNT, *of_form, *of_track, *steps_and_control, *state, *kept]

    def steady(self, z, decay, stiffness, load):
        """Return (w, d) of steady sliding; w of shape (n,)."""
        w = np.empty_like(z)
        return w, self._steady(z, w, z.size, decay, stiffness, load)

    def friction(self, z, slope, w, d, speed, load):
        """Return mu at an instant, without corrections at the edges of contacts."""
        return self._friction(z, slope, w, z.size, d, speed, load)

    def march(self, z, weight, w, d, decay, stiffness, load, steps):
        """Return mu of each step, shape (steps,)."""
        w, mu = w.copy(), np.empty(steps)
        self._march(z, weight, w, z.size, d, decay, stiffness, load, steps, mu)
        return mu

    def follow(self, form, track, load, elements, recorded):
        """Return a Trace of the recorded steps of a scene under a load."""
        n = elements.p.size
        of_form = form.times.size, form.glass, form.compliances, form.times
        of_track = *track[:5], track.place, track.time, track.dt.size
        room = np.zeros(n), np.empty(n), np.zeros(n + 1)
        state = elements.d, elements.memory.copy(), elements.p.copy(), *room
        values = np.empty((len(Trace._fields), recorded.size))
        self._follow(n, *of_form, *of_track, load, *state, recorded, recorded.size, values)
        return Trace(*values)
