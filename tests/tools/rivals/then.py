"""Times of commit 9b0af71 for the cases of rows.py, printed as JSON.

Run as a script with the root of a checkout of that commit as PYTHONPATH: it imports its kernels.
"""

import json
import math
import runpy
import sys
import time
from pathlib import Path

import numpy as np
from elastomer_friction.kernels.schemes import SCHEMES

from elastomer_friction.kernels import Case, Line, Quantities, amplitudes, draw_phases, run_case
from elastomer_friction.kernels.model.friction import lagged_slope
from elastomer_friction.kernels.quick.relaxation import march
from elastomer_friction.kernels.quick.steady import steady_sliding


def fastest(function, repeats):
    """Return the least CPU time of a call."""
    taken = []
    for _ in range(repeats + 1):
        began = time.thread_time()
        function()
        taken.append(time.thread_time() - began)
    return min(taken[1:])


def times(row, repeats, ratio):
    """Return seconds of the march, of a sweep, and of the whole case."""
    phases = draw_phases(np.random.default_rng(1), row.elements)
    line = Line.self_affine(amplitudes(row.hurst, row.elements), phases, row.elements, row.m)
    n, speed = line.z.size, row.x / math.pi
    step = SCHEMES["exponential"](1.0 / (row.m * speed * ratio))
    before = SCHEMES["exponential"](1.0 / (row.m * speed))
    load = row.load * n
    w, d, sweeps = steady_sliding(line.z, load, before.decay, before.stiffness)
    kept = np.array([row.steps])
    weight = lagged_slope(line.slope, step.lag)
    end = steady_sliding(line.z, load, step.decay, step.stiffness)
    cap = 1.02 * max(d, end[1])
    marched = fastest(
        lambda: march(line.z, weight, w, d, step.decay, step.stiffness, load, kept, cap), repeats
    )
    swept = fastest(lambda: steady_sliding(line.z, load, before.decay, before.stiffness), repeats)
    case = Case(row.load, speed, (ratio,), (kept,), "exponential")
    whole = fastest(lambda: run_case(line, case, Quantities()), repeats)
    return marched, swept / sweeps, whole


if __name__ == "__main__":
    given = runpy.run_path(str(Path(__file__).with_name("rows.py")))
    number = int(sys.argv[1])
    print(json.dumps([times(row, number, given["RATIO"]) for row in given["ROWS"]]))
