"""Steady sliding under one load, as plain numbers."""

from types import SimpleNamespace

import numpy as np

from kernels.patches.refined import Refined
from kernels.patches.steady_friction import Ground, steady_friction


def one_load(line, speed, scheme, load, others=()):
    """Return what is found under a load, ``seen`` on the line itself or on finer samples."""
    found = steady_friction(Ground.of(line), speed, scheme, np.array([load]), None, others)
    state, samples = found.state(0), float(found.samples[0])
    names = ("mu", "contact", "indentation", "updates", "jumps", "full")
    return SimpleNamespace(
        **{name: getattr(found, name)[0] for name in names},
        samples=samples,
        state=state,
        speed=speed,
        seen=found.seen.get(0, Refined(line, state, load, 1.0, samples)),
        samples_seen=float(found.samples_seen[0]),
    )
