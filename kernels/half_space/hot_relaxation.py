"""Relaxation after a velocity step of a half-space that its friction heats."""

import numpy as np

from ..model.friction import mean_slope
from ..rheology.law import law_of
from ..rheology.spectrum import Spectrum
from .body import HalfSpace, body_after, step_tolerance, try_step
from .heating import Heating, SlidingContact, heated_step
from .hot_sliding import HotSliding


def hot_relaxation(
    space: HalfSpace,
    spectrum: Spectrum,
    heating: Heating,
    ends: tuple[HotSliding, HotSliding],
    speed: float,
    numbers: np.ndarray,
) -> tuple[np.ndarray, int]:
    """Return (mu at the given steps after the jump to ``speed``, passes); mu tends to that at v2.

    ends : steady sliding before the jump and long after it. speed : vbar, signed. The flux of heat
    is that of the returned friction.
    """
    (one, two), surface = ends, space.surface
    direction, n = two.sliding.step.direction, surface.z.shape[1]
    earlier, offset = (
        np.roll(surface.slope, -direction, axis=1),
        two.sliding.mu - two.sliding.step_mu,
    )
    body = one.sliding.body._replace(memory=one.sliding.body.memory.copy())
    warmth, passes, mu, at = one.warmth, 0, np.empty(numbers.size), 0
    assert warmth is not None
    dt = 1.0 / (surface.steps_per_spacing * abs(speed))

    def attempt(duration: float, temperature: float) -> SlidingContact:
        law, moved_to = law_of(space.form, duration), (body.offset + direction) % n
        tolerance = step_tolerance(spectrum, law)
        w, contact = try_step(space, body, law, surface.z, moved_to, tolerance)
        weight = surface.slope + law.lag * (earlier - surface.slope)
        friction = mean_slope(contact.p, weight) + offset
        return SlidingContact((law, w, contact, moved_to), contact.p, friction, direction, 0.0)

    for number in range(1, int(numbers[-1]) + 1):
        sliding, warmth, _ = heated_step(heating, warmth, dt, attempt)
        body = body_after(body, *sliding.result)
        passes += sliding.result[2].passes
        if number == numbers[at]:
            mu[at] = sliding.friction
            at += 1
    return mu, passes
