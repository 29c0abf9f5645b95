"""Space and time refined apart: e elements per dx, steps of dx/m, by a plain march.

The kernels tie them, e = m: a step shifts the line by one sample. Here a line is sampled max(e, m)
times per dx; elements are some samples apart, or a step shifts the line by some.
"""

import math

import numpy as np

from kernels import Line

from .marches import NumbaMarch
from .points import Point, Surface

SPIN_UP = 12.0  # tau
SCHEME = "exponential"


def steady_friction(point: Point, surface: Surface, elements: int, steps: int) -> tuple:
    """Return mean and standard deviation over time of friction in steady sliding, in h/dx.

    With ``elements`` and ``steps`` per dx. Where steps are finer than elements, d is not constant
    but follows the lattice: then over at least 2 tau and a shift by 8 dx.
    """
    samples = max(elements, steps)
    line = Line.self_affine(*surface, samples)
    march = NumbaMarch(line, point.load, samples // elements, samples // steps, SCHEME)
    steps_per_tau = steps * point.speed
    march.advance(math.ceil(SPIN_UP * steps_per_tau), 1.0 / steps_per_tau)
    count = math.ceil(max(2.0 * steps_per_tau, 8.0 * steps)) if steps > elements else 1
    mu = march.advance(count, 1.0 / steps_per_tau)
    return mu.mean(), mu.std()


def separate(
    point: Point, surfaces: list[Surface], levels: tuple[int, ...]
) -> tuple[np.ndarray, np.ndarray]:
    """Return (error, noise), both of shape (elements per dx, steps per dx), of mu_1, relative.

    error : rms over lines, against the finest level of both, extrapolated from the last two at
    order 2. noise : rms fluctuation of a line in time, which a jump would start from.
    """
    found = np.array(
        [[[steady_friction(point, s, e, m) for s in surfaces] for m in levels] for e in levels]
    )
    mu, fluctuation = found[..., 0], found[..., 1]
    limit = mu[-1, -1] + (mu[-1, -1] - mu[-2, -2]) / 3.0
    error = np.sqrt(np.mean((mu - limit) ** 2, axis=2)) / limit.mean()
    return error, np.sqrt(np.mean(fluctuation**2, axis=2)) / limit.mean()
