"""Steady sliding of a half-space at the temperature to which its friction heats the contact.

The unknown is the logarithm x of the factor by which relaxation is faster than at the temperature
of the scene. Sliding at exp(-x) times the speed leads to a temperature T, and x is the root of

    x - ln(a_T(T_scene)/a_T(T)) = 0.

Without heat, or if a_T is constant, x = 0 is the root, and the first solution is that without heat.
"""

import math
from typing import NamedTuple

from ..rheology.spectrum import Spectrum
from ..root_search import new_secant_search, next_secant_guess
from .body import HalfSpace
from .heating import Heating, Warmth
from .patches import real_contact
from .sliding_body import SlidingBody, slide_steadily

RATE_TOLERANCE = 5e-4  # of x; mu changes by about a fifth of it
FIRST_RATE_STEP = 20.0  # limit of the first change of x
MIN_RATE_STEP = 1e-6
TYPICAL_SLOPE = 1.5  # of the function whose root is sought


class HotSliding(NamedTuple):
    """A body in steady sliding at its own temperature, or at that of the scene."""

    sliding: SlidingBody  # at the reduced speed exp(-x) v; its passes are those of all solutions
    warmth: Warmth | None = None  # None without heat
    log_rate: float = 0.0  # x
    shear: float = 0.0  # part of friction, in h/dx; 0 without heat
    solutions: int = 1  # number of contacts that were solved

    @property
    def slowing(self) -> float:
        """Return the reduced speed over the speed."""
        return math.exp(-self.log_rate)


def slide_with_heat(
    space: HalfSpace,
    spectrum: Spectrum,
    heating: Heating | None,
    speed: float,
    start: HotSliding | None = None,
    variables: int | None = None,
) -> HotSliding:
    """Return the state of steady sliding at a signed speed (vbar), with its temperature.

    start : the state at another speed, from which the search begins. variables : as for
    ``slide_steadily``. Raises ValueError without convergence, and for a temperature out of the
    range of the shift.
    """
    body, passes, solutions = start.sliding.body if start else None, 0, 0
    if heating is None:
        return HotSliding(slide_steadily(space, spectrum, speed, body, variables))
    secants = new_secant_search(start.log_rate if start else 0.0, FIRST_RATE_STEP, TYPICAL_SLOPE)
    while True:
        x = secants.search.x
        sliding = slide_steadily(space, spectrum, speed * math.exp(-x), body, variables)
        body, passes, solutions = sliding.body, passes + sliding.passes, solutions + 1
        area = real_contact(sliding.body.p, sliding.viscous) if heating.law else 0.0
        warmth, shear = heating.steady(sliding.body.p, sliding.mu, area, speed)
        excess = x - heating.heat.log_rate(warmth.contact)
        secants = next_secant_guess(secants, x, excess, RATE_TOLERANCE, MIN_RATE_STEP)
        if secants.search.ended:
            heating.heat.check(warmth.contact, speed)
            return HotSliding(sliding._replace(passes=passes), warmth, x, shear, solutions)
