"""Steady sliding under one load, as plain numbers."""

from types import SimpleNamespace

import numpy as np

from elastomer_friction.kernels.quick.contacts.steady_friction import (
    AtSpeed,
    Grounds,
    refine,
    steady_friction,
)


def one_load(line, speed, scheme, load, others=()):
    """Return what is found under a load; ``seen`` is None where the samples of the line will do."""
    at_speed = AtSpeed.of(scheme, line.steps_per_spacing, speed, others)
    found = steady_friction(Grounds.of([line]), at_speed, np.array([load]))
    refine(found, 0, 0)
    names = ("d", "mu", "contact", "indentation", "updates", "full", "samples")
    return SimpleNamespace(
        **{name: getattr(found, name)[0, 0] for name in names},
        jumps=found.found.jumps[0, 0],
        state=found.state(0, 0),
        seen=found.seen.get((0, 0)),
        samples_seen=found.samples_seen(0, 0),
    )
