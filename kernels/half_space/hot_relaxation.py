"""Relaxation of a half-space heated by friction, after a velocity step."""

import numpy as np

from ..model.friction import mean_slope
from ..rheology.law import law_of
from ..rheology.spectrum import Spectrum
from .body import HalfSpace, body_after, step_tolerance, try_step
from .heating import Heating, SlidingContact, heated_step
from .hot_sliding import HotSliding
from .patches import real_contact


def hot_relaxation(
    space: HalfSpace,
    spectrum: Spectrum,
    heating: Heating,
    ends: tuple[HotSliding, HotSliding],
    speed: float,
    numbers: np.ndarray,
) -> tuple[np.ndarray, np.ndarray, np.ndarray, int]:
    """Return (mu, its shear part, real contact, passes) after the jump to ``speed``.

    Arrays are over the given steps. mu is viscoelastic and tends to mu_2.

    ends : steady sliding before the jump and long after it. speed : vbar, signed. The heat
    flux is that of the returned friction.
    """
    (one, two), surface = ends, space.surface
    direction, n = two.sliding.step.direction, surface.z.shape[1]
    earlier, offset = (
        np.roll(surface.slope, -direction, axis=1),
        two.sliding.mu - two.sliding.step_mu,
    )
    body = one.sliding.body._replace(memory=one.sliding.body.memory.copy())
    warmth, passes, curves, at = one.warmth, 0, np.empty((3, numbers.size)), 0
    assert warmth is not None
    sudden, dt = two.sliding.viscous, 1.0 / (surface.steps_per_spacing * abs(speed))

    def attempt(duration: float, temperature: float) -> SlidingContact:
        law, moved_to = law_of(space.form, duration), (body.offset + direction) % n
        tolerance = step_tolerance(spectrum, law)
        w, contact = try_step(space, body, law, surface.z, moved_to, tolerance)
        weight = surface.slope + law.lag * (earlier - surface.slope)
        mu, area = mean_slope(contact.p, weight) + offset, real_contact(contact.p, sudden)
        shear, result = heating.shear(area, speed, temperature), (law, w, contact, moved_to)
        parts = mu, shear, area
        return SlidingContact((result, parts), contact.p, mu + shear, direction, 0.0)

    for number in range(1, int(numbers[-1]) + 1):
        sliding, warmth, _ = heated_step(heating, warmth, dt, attempt)
        result, parts = sliding.result
        body = body_after(body, *result)
        passes += result[2].passes
        if number == numbers[at]:
            curves[:, at] = parts
            at += 1
    mu, shear, areas = curves
    return mu, shear, areas, passes
