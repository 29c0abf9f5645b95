"""Laws with known numbers, and synthetic results of a study that follow them."""

from dataclasses import replace

import numpy as np
import xarray as xr

from elastomer_friction.workflow.law import LoadLaw, MemoryLaw
from elastomer_friction.workflow.law.load_law import LOAD_TABLES

SPEEDS = np.array([0.001, 0.01, 0.02, 0.05, 0.1])  # m/s


def memory_law(states=2):
    """Return a law with up to two states and an age of contacts."""
    return MemoryLaw(
        speed=SPEEDS,
        direct=0.02 * np.log1p(SPEEDS / 0.002),
        target=np.array([0.4 / (1.0 + SPEEDS / 0.03), 0.2 + 0.0 * SPEEDS])[:states],
        rate_per_length=np.array([2e3, 1e3, 2e4])[: states + 1],
        rate=np.array([3.0, 20.0, 400.0])[: states + 1],
        age=1.0 + 0.3 * np.log(0.1 / SPEEDS) / np.log(100.0),
    )


def load_law(states=2):
    """Return a table over three loads; its numbers increase by 10 % from load to load."""
    laws = []
    for factor in (0.9, 1.0, 1.1):
        law = memory_law(states)
        scaled = {name: factor * getattr(law, name) for name in LOAD_TABLES}
        laws.append(replace(law, **scaled))
    return LoadLaw.of([1.0, 2.0, 8.0], laws)


STEPS = [0.02, 0.05, 0.02, 0.01, 0.02, 0.1, 0.05, 0.1, 0.01, 0.05, -0.05, 0.02, -0.02, 0.01, 0.02]
RESTS = [(0.0, 0.1), (0.05, 0.06), (0.0, 0.4), (0.02, 0.15), (0.0, 0.1), (0.05, 0.06), (0.0, 0.4)]
SEGMENTS = [*((v, 0.003 / abs(v)) for v in STEPS), *RESTS, (0.02, 0.15)]  # velocity, duration


def result(law, segments=SEGMENTS, samples=40, **attributes):
    """Return a result of ``scene.run`` for segments (velocity, duration) with jumps between."""
    rows, t, x = [], 0.0, 0.0
    state, mu = law.step(law.init(segments[0][0]), segments[0][0], 0.0)
    for k, (v, duration) in enumerate(segments):
        state, _ = law.step(state, v, 0.0)
        for end in duration * np.geomspace(1e-3, 1.0, samples):
            since = 0.0 if not rows or rows[-1][4] != k else rows[-1][5]
            state, mu = law.step(state, v, end - since)
            rows.append([t + end, v, x + v * end, mu, k, end, state[1]])
        t, x = t + duration, x + v * duration
    given = dataset(*np.array(rows).T[:5], **attributes)
    return given.assign(age=("event", [row[6] for row in rows]))


def dataset(time, velocity, distance, mu, segment, force=2.0, **attributes):
    """Return a dataset of traces."""
    traces = {"time": time, "velocity": velocity, "distance": distance, "mu": mu}
    variables = {f"trace_{name}": ("event", np.asarray(v)) for name, v in traces.items()}
    variables["trace_segment"] = ("event", np.asarray(segment, np.int32))
    coords = {"normal_force": force}
    return xr.Dataset(variables, coords, {"title": "synthetic", **attributes})
