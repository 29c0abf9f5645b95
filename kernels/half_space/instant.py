"""Friction at the moment of a velocity jump: displacements stand, rates jump.

Behind a dashpot pressures follow the velocity at once. With f the part of A p that is there
without any rate, and eta the viscosity, on the samples that touch

    A p = f - eta du/dt,    du/dt = -(v dz/dx + d'),    p >= 0,

and p = 0 elsewhere: one more contact problem, restricted to the set. Without a dashpot mu is
continuous and its rate jumps.
"""

import numpy as np

from ..model.friction import mean_slope
from .body import TOLERANCE, HalfSpace, at_samples, lasting_depth
from .contact import ElasticContact, press
from .sliding_body import SlidingBody


def friction_jumps(
    space: HalfSpace, one: SlidingBody, speed: float, ratios: tuple[float, ...]
) -> tuple[np.ndarray, int]:
    """Return (jumps of mu from ``speed`` to ratios times it in h/dx, passes of the operator).

    one : steady sliding at speed (vbar, signed).
    """
    body, slope = one.body, space.surface.slope
    viscosity, lasting = lasting_depth(space.form, body.memory)
    if viscosity == 0.0:
        return np.zeros(len(ratios)), 0
    there = at_samples(lasting, body.offset, slope.shape)
    touching = body.p > 0.0
    mu, passes = [], 0
    found = ElasticContact(body.p, at_samples(body.depth, body.offset, slope.shape), 0.0, 0)
    for each in (1.0, *ratios):
        gap = -(there + viscosity * each * speed * slope)
        start = found._replace(d=float(gap[touching].mean()), passes=0)
        found = press(gap, space.pressure, space.operator, start, TOLERANCE, touching)
        passes += found.passes
        mu.append(mean_slope(found.p, slope))
    return np.array(mu[1:]) - mu[0], passes
